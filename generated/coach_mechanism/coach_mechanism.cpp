// coach_mechanism, content hash 2678ee471f5fa604
// Made by `mbgen generate coach_mechanism.json`, mbgen 0.1.0. Change the model, not this file.
#include "coach_mechanism.hpp"

#include "mbgen/elementary.hpp"
#include "mbgen/motion.hpp"
#include "mbgen/scalar.hpp"
#include "mbgen/solver.hpp"

#include <cmath>

namespace coach_mechanism {
namespace {

/// Projection of the loop blocks, chosen at run time.
struct Projection {
  double Rz[58];  ///< of each block, row by row
  double zdd_star[22];  ///< accelerations of each block at zero independent ones
};

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
      sines[22], cosines[22], R_chassis_z_z, R_chassis_z_y, s1_3, R_chassis_x_y, R_chassis_y_y,
      R_chassis_x_z, R_chassis_y_z, s1_8, s1_10, R_carrier_left_aux1_y_x, R_carrier_left_aux1_z_x,
      R_carrier_left_aux2_y_y, R_carrier_left_aux2_z_y, s1_19, s1_24, R_carrier_left_x_x,
      R_carrier_left_y_x, R_carrier_left_z_x, R_carrier_left_x_z, R_carrier_left_y_z,
      R_carrier_left_z_z, s1_28, s1_30, R_carrier_right_aux1_y_x, R_carrier_right_aux1_z_x,
      R_carrier_right_aux2_y_y, R_carrier_right_aux2_z_y, s1_39, s1_44, R_carrier_right_x_x,
      R_carrier_right_y_x, R_carrier_right_z_x, R_carrier_right_x_z, R_carrier_right_y_z,
      R_carrier_right_z_z, R_rear_axle_aux5_x_x, R_rear_axle_aux5_y_x, s1_48, R_rear_axle_x_y,
      R_rear_axle_y_y, R_rear_axle_x_z, R_rear_axle_y_z, R_rear_axle_z_y, R_rear_axle_z_z, s5_1,
      s5_2, w_chassis_y, s5_3, s5_4, w_chassis_z, s5_5, w_chassis_x, R_chassis_aux5_x_x,
      R_chassis_aux5_y_x, s7_2, s7_4, s7_6, s5_7, s5_8, s5_9, s5_11, s5_12, s5_13, s5_15, s5_17,
      s5_19, s5_20, s5_21, s5_22, s5_23, s5_25, s5_26, s5_28, s5_30, s5_32, s5_33, s5_34, s5_36,
      s5_37, s5_40, s5_41, s5_44, s5_45, s5_46, s5_47, s5_48, s5_50, s5_51, s5_53, s4_1, s4_2, s4_3,
      s4_4, s4_5, s4_6, s4_7, s4_8, s4_9, s4_10, s4_11, s4_12, s4_13, s4_14, s4_15, s4_16, s4_17,
      s4_18, s4_19, s4_20, s4_21, s4_22, s4_23, s4_24, s4_25, s4_26, s4_27, s4_28, s4_29, s4_30,
      s4_32, s4_33, s4_34, s4_36, s4_37, s4_38, s4_39, s4_40, s4_41, s4_42, s4_44, s4_45, s4_46,
      s4_47, s4_48, s4_49, w_carrier_left_y, w_carrier_left_x, s4_52, w_carrier_left_z, s4_55,
      s4_57, s4_59, w_carrier_right_y, w_carrier_right_x, s4_62, w_carrier_right_z, s4_65, s4_67,
      s4_69, w_rear_axle_x, w_rear_axle_y, w_rear_axle_z, s8_3, s8_4, s8_5, s2_7, s2_9, s2_10,
      s2_12, s2_13, s2_14, s2_15, s2_16, s2_17, r_rear_axle_aux1_x, s2_18, s2_19,
      r_rear_axle_aux3_z, s2_20, s2_24, s2_27, s2_28, s2_31, s2_32, s2_33, s2_34, s2_35, s2_36,
      s2_37, s2_38, s2_39, s2_47, s2_49, s2_50, s2_52, s2_53, s2_54, s2_55, s2_56, s2_57, s2_58,
      s2_59, s2_60, s2_62, s2_63, s2_65, s2_66, s2_67, s2_68, s2_69, s2_70, s2_71, s2_72, s2_73,
      s2_74, s2_75, s2_76, s2_78, s2_79, s2_80, s2_81, s2_82, s2_83, s2_84, s2_85, s2_86, s2_87,
      s2_88, s2_89, s2_90, s2_91, s2_92, s2_93, s2_94, s2_95, s2_96, s2_97, s2_98, s2_99, s2_100,
      s2_101, s2_102, s2_103, s2_104, s2_105, s2_106, s2_108, s2_109, s2_110, s2_111, s2_113,
      s2_114, s2_115, s2_116, s2_118, s2_119, s2_120, s2_121, s2_122, s2_124, s2_128, s2_129,
      s2_132, s2_133, s2_135, s2_137, s2_140, s2_141, s2_145, s2_149, s2_150, s2_151, s2_154,
      s2_155, s2_158, s2_161, s2_162, s2_163, s2_165, s2_167, s3_2, Rz_rear_axle_rz_0,
      Rz_rear_axle_ry_0, s3_5, s3_7, s3_9, s3_11, s3_13, Rz_rear_axle_rx_0, s3_16, s3_20, s3_22,
      s3_24, s3_26, s3_28, s3_30, Rz_rear_axle_tx_0, s3_33, s3_35, s3_37, s3_39, s3_41, s3_44,
      s3_47, Rz_rear_axle_tz_1, s3_48, Rz_rear_axle_ry_1, s3_52, s3_54, s3_56, s3_58, s3_60,
      Rz_rear_axle_rx_1, s3_63, s3_66, s3_67, s3_68, s3_69, s3_70, s3_71, Rz_rear_axle_tx_1, s3_73,
      s3_75, s3_77, s3_79, s3_81, s3_84, s3_87, s3_90, s3_93, s3_95, s6_3, s6_6, s6_7, s6_9, s6_12,
      s6_13, s6_16, s6_19, s6_38, s6_40, s6_44, s6_45, zdd_star_rear_axle_tz, zdd_star_rear_axle_rz,
      zdd_star_rear_axle_ry, zdd_star_rear_axle_rx, s6_61, s6_63, s6_65, s6_67, s6_69, s6_71, s6_72,
      zdd_star_rear_axle_tx, s7_22, s7_24, s7_26, s7_27, s7_28, s7_29, s7_31, s7_33, s7_34, s8_6,
      s8_7, s8_8, s8_9, s8_10, s8_13, s7_35, s7_38, s7_39, s7_40, s7_41, s7_42, s7_43, s7_46, s7_47,
      s7_48, s7_49, s7_50, s7_51, s8_14, s8_15, s8_16, s8_17, s8_18, s8_19, s8_21, s8_22, s8_23,
      s8_24, s8_26, s8_27, s8_28, s8_29, s8_30, s8_32, s8_33, s8_34, s8_35, s8_36, s8_37, s8_41,
      s8_45, s8_48, s8_51, s8_54, s8_60, s8_63, s8_65, s8_68, s8_71, s8_72, s8_73, s8_74, s8_75,
      s8_77, s8_79, s8_86, s8_90, s8_94, s8_98, s8_99, s8_100, s8_101, s8_102, s8_104, s8_105,
      s8_106, s8_107, s8_109, s8_110, s8_111, s8_112, s8_113, s8_114, s8_115, s8_119, s8_123,
      s8_124, s8_126, s8_127, s8_128, s8_129, s8_131, s8_142, s8_147, s8_149, s8_152, s8_154,
      s8_155, f_rear_axle_x, f_rear_axle_y, f_rear_axle_z, s8_159, s8_160, s8_161, s8_166, s8_180,
      s8_228, s8_229, s8_230, s8_231, s8_359, s8_360, s8_361, s8_363, s8_364, s8_366, s8_387,
      s8_395, s8_402, s8_408, s8_413, s8_416, s9_1, s8_417, s8_420, s8_421, s8_422, s8_429, s8_435,
      s8_440, s8_445, s8_446, s8_454, s8_455, s8_456, s8_457, s8_458, s8_459, s8_461, s8_462,
      s8_463, s8_464, s8_465, s8_467, s8_468, s8_469, s8_470, s8_472, s8_473, s8_474, s8_477,
      s8_478, s8_480, s8_485, s8_487, s8_489, s8_491, s8_494, s8_495, s8_497, s8_498, s8_499,
      s8_501, s8_502, s8_503, s2_203, s2_206, s2_209, s2_211, s2_214, s2_217, s2_219, s2_223,
      s2_226, r_carrier_left_aux1_y, s2_227, r_carrier_left_aux1_z, s2_229, s2_234,
      r_carrier_right_aux1_y, s2_235, s2_237, s2_238, s2_243, s2_244, s2_245, s2_247, s2_250,
      s2_252, s2_253, s2_254, s2_255, s2_256, s2_257, s2_260, s2_261, s2_265, s2_268, s2_274,
      s2_275, s2_278, s2_324, s3_97, s3_98, s3_99, s3_100, s3_101, Rz_arb_front_left_0, s3_105,
      s3_107, s3_108, s3_109, Rz_carrier_right_ry_1, s3_110, s3_111, Rz_carrier_right_rx_1, s3_114,
      Rz_arb_front_right_1, s3_118, Rz_upper_arm_left_2, Rz_lower_arm_left_2, s3_119, s3_120,
      s3_122, s3_123, Rz_carrier_right_rz_2, Rz_carrier_right_ry_2, s3_125, s3_127,
      Rz_carrier_right_rx_2, s3_131, s3_133, Rz_arb_front_left_2, s3_135, Rz_arb_front_right_2,
      s3_138, s3_140, s3_142, s3_143, s6_91, s6_92, s6_93, s6_95, s6_98, s6_100, s6_101, s6_105,
      s6_116, s6_118, s6_121, s6_126, s6_127, s6_128, s6_130, s6_131, s6_144, s6_159, s6_166,
      s6_168, s6_173, s6_174, s6_182, s6_195, zdd_star_lower_arm_left, zdd_star_carrier_left_ry,
      zdd_star_carrier_left_rx, s6_200, s6_203, s6_204, s6_205, zdd_star_carrier_right_rz,
      zdd_star_carrier_right_ry, s6_208, s6_212, zdd_star_carrier_right_rx, s6_221, s6_223,
      zdd_star_arb_front_left, s6_227, s6_228, zdd_star_arb_front_right, s6_232, s6_234, s6_235,
      s6_236, s6_237, s7_58, s7_59, s7_62, s7_63, s7_65, s7_67, s7_69, s7_71, s8_504, s8_505, s7_72,
      s7_73, s7_74, s7_101, s7_103, s7_105, s7_107, s7_109, s8_506, s8_507, s8_508, s8_509, s7_125,
      s7_130, s7_132, s7_134, s8_513, s8_514, s8_515, s8_516, s8_517, s8_518, s8_519, s8_520,
      s8_521, s7_143, s7_150, s7_151, s7_154, s7_155, s7_157, s7_159, s7_161, s7_163, s8_522,
      s8_523, s8_524, s8_525, s7_164, s7_171, s7_172, s7_173, s7_174, s7_177, s7_178, s7_181,
      s7_182, s7_184, s7_186, s7_188, s7_190, s8_526, s8_527, s8_528, s8_529, s7_191, s7_194,
      s7_195, s7_199, s7_202, s7_207, s7_208, s7_209, s7_211, s7_212, s7_213, s7_215, s7_222,
      s7_224, s7_225, s7_226, s7_228, s7_230, s8_531, s7_231, s8_532, s8_533, s8_535, s8_536,
      s8_537, s8_539, s8_541, s8_542, s8_544, s8_545, s8_546, s8_549, s8_552, s8_555, s8_557,
      s8_559, s8_562, s8_564, s8_566, s8_567, s8_570, s8_573, s8_574, s8_575, s8_579, s8_580,
      s8_584, s8_587, s8_588, s8_589, s8_590, s8_591, s8_592, s8_593, s8_594, s8_595, s8_596,
      s8_597, s8_598, s8_599, s8_600, s8_601, s8_602, s8_603, s8_607, s8_608, s8_610, s8_611,
      s8_612, s8_613, s8_614, s8_615, s8_619, s8_620, s8_621, s8_623, s8_625, s8_626, s8_627,
      s8_628, s8_629, s8_630, s8_636, s8_639, s8_644, s8_647, s8_649, s8_650, s8_651, s8_653,
      f_carrier_right_x, f_carrier_right_y, f_carrier_right_z, s8_681, s8_682, s8_683, s8_684,
      s8_685, s8_687, s8_689, n_carrier_right_x, n_carrier_right_y, s8_695, s8_696,
      n_carrier_right_z, s8_698, s8_699, s8_700, s8_701, s8_702, s8_703, s8_707, s8_708, s8_709,
      s8_710, s8_712, s8_713, s8_717, s8_719, s8_722, s8_724, s8_729, s8_732, s8_736, s8_740,
      s8_742, s8_743, s8_744, s8_745, s8_746, s8_747, s8_748, s8_749, s8_750, s8_752, s8_753,
      s8_754, s8_755, s8_756, s8_757, s8_758, s8_762, s8_763, s8_764, s8_766, s8_767, s8_768,
      s8_769, s8_770, s8_771, s8_775, s8_776, s8_777, s8_778, s8_779, s8_780, s8_781, s8_784,
      s8_785, s8_787, s8_788, s8_789, s8_790, f_carrier_left_x, f_carrier_left_y, f_carrier_left_z,
      n_carrier_left_x, n_carrier_left_y, s8_837, s8_871, s8_872, s8_873, s8_874, s8_876, s8_878,
      s8_890, s8_897, s8_912, s8_914, s8_921, s8_922, s8_933, s8_935, s8_942, s8_943, s8_953,
      s8_955, s8_958, s8_959, s8_968, s8_983, s8_985, s8_990, s8_991, s8_994, s8_1002, s8_1003,
      s8_1004, s8_1007, s8_1008, s8_1010, s8_1011, s8_1013, s8_1019, s8_1020, s8_1034, s8_1035,
      s8_1044, s8_1054, s8_1065, s8_1067, s8_1068, s8_1072, s8_1073, s8_1076, s8_1077, s8_1080,
      s8_1087, s8_1092, s8_1094, s8_1096, s8_1097, s8_1100, s8_1104, s8_1105, s8_1110, s8_1117,
      s8_1122, s8_1126, s8_1127, s8_1129, s8_1131, s8_1133, s8_1135, s8_1137, s8_1138, s8_1140,
      s8_1141, s8_1143, s8_1144, s8_1145, s8_1146, s8_1147, s8_1148, s8_1149, s8_1151, s8_1152,
      s8_1153, s8_1154, s8_1155, s8_1156, s8_1158, s8_1159, s8_1160, s8_1161, s8_1162, s8_1164,
      s8_1165, s8_1166, s8_1167, s8_1168, s8_1169, s8_1170;
};

/// Part 1 of compute_accelerations: step 1: poses and axes b; step 5: applied forces Q (48); step
/// 7: inertias of the bodies and forces on joints; step 5: applied forces Q (48); step 4: angular
/// velocities; step 8: elimination from the leaves to the root (63); step 2: closure Jacobian Phi_z
/// and its factors (60), long_rod_left .. arb_link_rear_right.
[[gnu::noinline]] void compute_accelerations_1(const State& state, const double* tau,
    AccelerationsWork& __restrict work) noexcept {
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
  const double R_chassis_aux5_z_z = work.cosines[1];
  const double s1_1 = work.cosines[2];
  work.R_chassis_z_z = R_chassis_aux5_z_z*s1_1;
  const double s1_2 = work.sines[2];
  work.R_chassis_z_y = R_chassis_aux5_z_z*s1_2;
  work.s1_3 = s1_2*work.R_chassis_z_y + s1_1*work.R_chassis_z_z;
  const double R_chassis_aux4_y_x = work.sines[0];
  const double s1_4 = work.sines[1];
  const double s1_5 = s1_4*s1_2;
  const double R_chassis_aux4_x_x = work.cosines[0];
  work.R_chassis_x_y = R_chassis_aux4_x_x*s1_5 - R_chassis_aux4_y_x*s1_1;
  work.R_chassis_y_y = R_chassis_aux4_x_x*s1_1 + R_chassis_aux4_y_x*s1_5;
  const double s1_6 = s1_4*s1_1;
  work.R_chassis_x_z = R_chassis_aux4_y_x*s1_2 + R_chassis_aux4_x_x*s1_6;
  work.R_chassis_y_z = R_chassis_aux4_y_x*s1_6 - R_chassis_aux4_x_x*s1_2;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s1_7 = 0.44999999999999996*R_lower_arm_left_y_y;
  work.s1_8 = s1_7 + 0.04999999999999999*R_lower_arm_left_z_y;
  const double s1_9 = 0.44999999999999996*R_lower_arm_left_z_y;
  work.s1_10 = s1_9 - 0.04999999999999999*R_lower_arm_left_y_y;
  const double s1_11 = work.sines[4];
  work.R_carrier_left_aux1_y_x = R_lower_arm_left_y_y*s1_11;
  work.R_carrier_left_aux1_z_x = R_lower_arm_left_z_y*s1_11;
  const double s1_12 = R_lower_arm_left_y_y*work.R_carrier_left_aux1_y_x;
  const double s1_13 = s1_12 + R_lower_arm_left_z_y*work.R_carrier_left_aux1_z_x;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double R_carrier_left_aux1_y_y = R_lower_arm_left_y_y*R_carrier_left_aux1_x_x;
  const double s1_14 = work.cosines[5];
  const double s1_15 = work.sines[5];
  work.R_carrier_left_aux2_y_y = R_carrier_left_aux1_y_y*s1_14 - R_lower_arm_left_z_y*s1_15;
  const double R_carrier_left_aux1_z_y = R_lower_arm_left_z_y*R_carrier_left_aux1_x_x;
  work.R_carrier_left_aux2_z_y = R_carrier_left_aux1_z_y*s1_14 + R_lower_arm_left_y_y*s1_15;
  const double s1_16 = R_carrier_left_aux1_y_y*s1_15 + R_lower_arm_left_z_y*s1_14;
  const double R_carrier_left_aux2_z_z = R_lower_arm_left_y_y*s1_14 - R_carrier_left_aux1_z_y*s1_15;
  const double s1_17 = work.R_carrier_left_aux1_y_x*work.R_carrier_left_aux2_z_y;
  const double s1_18 = s1_17 - work.R_carrier_left_aux1_z_x*work.R_carrier_left_aux2_y_y;
  work.s1_19 = s1_11*s1_14;
  const double s1_20 = R_carrier_left_aux1_x_x*work.R_carrier_left_aux2_z_y;
  const double s1_21 = s1_20 + work.R_carrier_left_aux1_z_x*work.s1_19;
  const double s1_22 = R_carrier_left_aux1_x_x*work.R_carrier_left_aux2_y_y;
  const double s1_23 = work.R_carrier_left_aux1_y_x*work.s1_19 + s1_22;
  work.s1_24 = R_lower_arm_left_z_y*s1_21 + R_lower_arm_left_y_y*s1_23;
  const double R_carrier_left_aux2_x_z = s1_11*s1_15;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_25 = work.cosines[6];
  const double s1_26 = work.sines[6];
  work.R_carrier_left_x_x = R_carrier_left_aux1_x_x*s1_25 - R_carrier_left_aux2_x_z*s1_26;
  work.R_carrier_left_y_x = s1_16*s1_26 + work.R_carrier_left_aux1_y_x*s1_25;
  work.R_carrier_left_z_x = work.R_carrier_left_aux1_z_x*s1_25 - R_carrier_left_aux2_z_z*s1_26;
  work.R_carrier_left_x_z = R_carrier_left_aux2_x_z*s1_25 + R_carrier_left_aux1_x_x*s1_26;
  work.R_carrier_left_y_z = work.R_carrier_left_aux1_y_x*s1_26 - s1_16*s1_25;
  work.R_carrier_left_z_z = R_carrier_left_aux2_z_z*s1_25 + work.R_carrier_left_aux1_z_x*s1_26;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double R_lower_arm_right_z_y = work.sines[9];
  const double s1_27 = 0.04999999999999999*R_lower_arm_right_z_y;
  work.s1_28 = s1_27 - 0.44999999999999996*R_lower_arm_right_y_y;
  const double s1_29 = 0.44999999999999996*R_lower_arm_right_z_y;
  work.s1_30 = s1_29 + 0.04999999999999999*R_lower_arm_right_y_y;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s1_31 = work.sines[10];
  work.R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_31;
  work.R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_31;
  const double s1_32 = R_lower_arm_right_y_y*work.R_carrier_right_aux1_y_x;
  const double s1_33 = s1_32 + R_lower_arm_right_z_y*work.R_carrier_right_aux1_z_x;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double s1_34 = work.cosines[11];
  const double s1_35 = work.sines[11];
  work.R_carrier_right_aux2_y_y = R_carrier_right_aux1_y_y*s1_34 - R_lower_arm_right_z_y*s1_35;
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  work.R_carrier_right_aux2_z_y = R_carrier_right_aux1_z_y*s1_34 + R_lower_arm_right_y_y*s1_35;
  const double s1_36 = R_carrier_right_aux1_y_y*s1_35 + R_lower_arm_right_z_y*s1_34;
  const double R_carrier_right_aux2_z_z = R_lower_arm_right_y_y*s1_34 -
      R_carrier_right_aux1_z_y*s1_35;
  const double s1_37 = work.R_carrier_right_aux1_y_x*work.R_carrier_right_aux2_z_y;
  const double s1_38 = s1_37 - work.R_carrier_right_aux1_z_x*work.R_carrier_right_aux2_y_y;
  work.s1_39 = s1_31*s1_34;
  const double s1_40 = R_carrier_right_aux1_x_x*work.R_carrier_right_aux2_z_y;
  const double s1_41 = s1_40 + work.R_carrier_right_aux1_z_x*work.s1_39;
  const double s1_42 = R_carrier_right_aux1_x_x*work.R_carrier_right_aux2_y_y;
  const double s1_43 = work.R_carrier_right_aux1_y_x*work.s1_39 + s1_42;
  work.s1_44 = R_lower_arm_right_z_y*s1_41 + R_lower_arm_right_y_y*s1_43;
  const double R_carrier_right_aux2_x_z = s1_31*s1_35;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_45 = work.cosines[12];
  const double s1_46 = work.sines[12];
  work.R_carrier_right_x_x = R_carrier_right_aux1_x_x*s1_45 - R_carrier_right_aux2_x_z*s1_46;
  work.R_carrier_right_y_x = s1_36*s1_46 + work.R_carrier_right_aux1_y_x*s1_45;
  work.R_carrier_right_z_x = work.R_carrier_right_aux1_z_x*s1_45 - R_carrier_right_aux2_z_z*s1_46;
  work.R_carrier_right_x_z = R_carrier_right_aux2_x_z*s1_45 + R_carrier_right_aux1_x_x*s1_46;
  work.R_carrier_right_y_z = work.R_carrier_right_aux1_y_x*s1_46 - s1_36*s1_45;
  work.R_carrier_right_z_z = R_carrier_right_aux2_z_z*s1_45 + work.R_carrier_right_aux1_z_x*s1_46;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double R_rear_axle_aux5_z_z = work.cosines[18];
  work.R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double s1_47 = R_rear_axle_aux4_x_x*work.R_rear_axle_aux5_x_x;
  work.s1_48 = s1_47 + R_rear_axle_aux4_y_x*work.R_rear_axle_aux5_y_x;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_49 = work.sines[18];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_49;
  const double s1_50 = work.cosines[19];
  const double s1_51 = work.sines[19];
  work.R_rear_axle_x_y = R_rear_axle_aux5_x_z*s1_51 - R_rear_axle_aux4_y_x*s1_50;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_49;
  work.R_rear_axle_y_y = R_rear_axle_aux4_x_x*s1_50 + R_rear_axle_aux5_y_z*s1_51;
  work.R_rear_axle_x_z = R_rear_axle_aux4_y_x*s1_51 + R_rear_axle_aux5_x_z*s1_50;
  work.R_rear_axle_y_z = R_rear_axle_aux5_y_z*s1_50 - R_rear_axle_aux4_x_x*s1_51;
  work.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_51;
  work.R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_50;
  // operations: 44 add, 110 multiply, 44 sin cos

  // --- step 5: applied forces Q (48) ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  work.s5_1 = zd_chassis_rz*work.R_chassis_z_y;
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  work.s5_2 = zd_chassis_ry*s1_1;
  work.w_chassis_y = work.s5_1 + work.s5_2;
  work.s5_3 = zd_chassis_rz*work.R_chassis_z_z;
  work.s5_4 = zd_chassis_ry*s1_2;
  work.w_chassis_z = work.s5_3 - work.s5_4;
  work.s5_5 = zd_chassis_rz*s1_4;
  work.w_chassis_x = state.zd[Coordinate::chassis_rx] - work.s5_5;

  // --- step 7: inertias of the bodies and forces on joints ---
  work.R_chassis_aux5_x_x = R_chassis_aux4_x_x*R_chassis_aux5_z_z;
  work.R_chassis_aux5_y_x = R_chassis_aux4_y_x*R_chassis_aux5_z_z;
  const double tau_chassis_tx = tau[Coordinate::chassis_tx];
  const double tau_chassis_ty = tau[Coordinate::chassis_ty];
  const double s7_1 = work.R_chassis_aux5_y_x*tau_chassis_ty;
  const double tau_chassis_tz = tau[Coordinate::chassis_tz];
  work.s7_2 = s7_1 + work.R_chassis_aux5_x_x*tau_chassis_tx - s1_4*tau_chassis_tz;
  const double s7_3 = work.R_chassis_z_y*tau_chassis_tz + work.R_chassis_y_y*tau_chassis_ty;
  work.s7_4 = s7_3 + work.R_chassis_x_y*tau_chassis_tx;
  const double s7_5 = work.R_chassis_z_z*tau_chassis_tz + work.R_chassis_y_z*tau_chassis_ty;
  work.s7_6 = s7_5 + work.R_chassis_x_z*tau_chassis_tx;
  // operations: 6 add, 11 multiply

  // --- step 5: applied forces Q (48), continued ---
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s5_6 = 1.0/work.s1_3;
  work.s5_7 = work.s1_3*s5_6;
  work.s5_8 = s1_5*s5_6;
  const double tau_chassis_ry = tau[Coordinate::chassis_ry];
  const double tau_chassis_rx = tau[Coordinate::chassis_rx];
  work.s5_9 = s1_2*s5_6;
  const double tau_chassis_rz = tau[Coordinate::chassis_rz];
  const double s5_10 = tau_chassis_rx*work.s5_8 + s1_1*tau_chassis_ry;
  work.s5_11 = s5_10 + tau_chassis_rz*work.s5_9;
  work.s5_12 = s1_6*s5_6;
  work.s5_13 = s1_1*s5_6;
  const double s5_14 = tau_chassis_rx*work.s5_12 + tau_chassis_rz*work.s5_13;
  work.s5_15 = s5_14 - s1_2*tau_chassis_ry;
  const double s5_16 = 1.0/work.s1_24;
  work.s5_17 = s1_18*s5_16;
  const double tau_carrier_left_rx = tau[Coordinate::carrier_left_rx];
  const double tau_carrier_left_rz = tau[Coordinate::carrier_left_rz];
  const double s5_18 = R_carrier_left_aux1_x_x*tau_carrier_left_rx;
  work.s5_19 = s1_21*s5_16;
  work.s5_20 = s1_23*s5_16;
  work.s5_21 = s5_16*s1_13;
  const double tau_carrier_left_ry = tau[Coordinate::carrier_left_ry];
  work.s5_22 = s5_18 + tau_carrier_left_rz*work.s5_17 - tau_carrier_left_ry*work.s5_21;
  work.s5_23 = R_carrier_left_aux1_y_y*s5_16;
  const double s5_24 = work.R_carrier_left_aux1_y_x*tau_carrier_left_rx;
  work.s5_25 = tau_carrier_left_ry*work.s5_23 + s5_24 - tau_carrier_left_rz*work.s5_19;
  work.s5_26 = R_carrier_left_aux1_z_y*s5_16;
  const double s5_27 = work.R_carrier_left_aux1_z_x*tau_carrier_left_rx;
  work.s5_28 = tau_carrier_left_ry*work.s5_26 + s5_27 + tau_carrier_left_rz*work.s5_20;
  const double s5_29 = 1.0/work.s1_44;
  work.s5_30 = s1_38*s5_29;
  const double tau_carrier_right_rx = tau[Coordinate::carrier_right_rx];
  const double tau_carrier_right_rz = tau[Coordinate::carrier_right_rz];
  const double s5_31 = R_carrier_right_aux1_x_x*tau_carrier_right_rx;
  work.s5_32 = s1_41*s5_29;
  work.s5_33 = s1_43*s5_29;
  work.s5_34 = s5_29*s1_33;
  const double tau_carrier_right_ry = tau[Coordinate::carrier_right_ry];
  const double s5_35 = s5_31 + tau_carrier_right_rz*work.s5_30;
  work.s5_36 = s5_35 - tau_carrier_right_ry*work.s5_34;
  work.s5_37 = R_carrier_right_aux1_y_y*s5_29;
  const double s5_38 = work.R_carrier_right_aux1_y_x*tau_carrier_right_rx;
  const double s5_39 = tau_carrier_right_ry*work.s5_37 + s5_38;
  work.s5_40 = s5_39 - tau_carrier_right_rz*work.s5_32;
  work.s5_41 = R_carrier_right_aux1_z_y*s5_29;
  const double s5_42 = work.R_carrier_right_aux1_z_x*tau_carrier_right_rx;
  const double s5_43 = tau_carrier_right_ry*work.s5_41 + s5_42;
  work.s5_44 = s5_43 + tau_carrier_right_rz*work.s5_33;
  work.s5_45 = 1.0/work.s1_48;
  work.s5_46 = R_rear_axle_aux5_x_z*work.s5_45;
  work.s5_47 = R_rear_axle_aux5_y_z*work.s5_45;
  const double tau_rear_axle_rz = tau[Coordinate::rear_axle_rz];
  work.s5_48 = R_rear_axle_aux4_x_x*work.s5_45;
  const double tau_rear_axle_rx = tau[Coordinate::rear_axle_rx];
  const double tau_rear_axle_ry = tau[Coordinate::rear_axle_ry];
  const double s5_49 = tau_rear_axle_rx*work.s5_48 + tau_rear_axle_rz*work.s5_46;
  work.s5_50 = s5_49 - R_rear_axle_aux4_y_x*tau_rear_axle_ry;
  work.s5_51 = R_rear_axle_aux4_y_x*work.s5_45;
  const double s5_52 = tau_rear_axle_rx*work.s5_51 + R_rear_axle_aux4_x_x*tau_rear_axle_ry;
  work.s5_53 = s5_52 + tau_rear_axle_rz*work.s5_47;
  // operations: 23 add, 56 multiply, 4 divide

  // --- step 4: angular velocities ---
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  work.s4_1 = zd_carrier_left_rz*R_lower_arm_left_y_y;
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  work.s4_2 = zd_carrier_left_rx*work.R_carrier_left_aux1_z_x;
  work.s4_3 = work.s4_1 + work.s4_2;
  work.s4_4 = zd_carrier_left_rz*R_lower_arm_left_z_y;
  work.s4_5 = zd_carrier_left_rx*work.R_carrier_left_aux1_y_x;
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  work.s4_6 = zd_carrier_left_ry*work.R_carrier_left_aux2_y_y;
  work.s4_7 = work.s4_5 - work.s4_4;
  work.s4_8 = work.s4_6 + work.s4_7;
  work.s4_9 = zd_carrier_left_ry*work.R_carrier_left_aux2_z_y;
  work.s4_10 = work.s4_9 + work.s4_3;
  work.s4_11 = work.w_chassis_y*work.s4_10 - work.w_chassis_z*work.s4_8;
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  work.s4_12 = zd_carrier_right_rz*R_lower_arm_right_y_y;
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  work.s4_13 = zd_carrier_right_rx*work.R_carrier_right_aux1_z_x;
  work.s4_14 = work.s4_12 + work.s4_13;
  work.s4_15 = zd_carrier_right_rz*R_lower_arm_right_z_y;
  work.s4_16 = zd_carrier_right_rx*work.R_carrier_right_aux1_y_x;
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  work.s4_17 = zd_carrier_right_ry*work.R_carrier_right_aux2_y_y;
  work.s4_18 = work.s4_16 - work.s4_15;
  work.s4_19 = work.s4_17 + work.s4_18;
  work.s4_20 = zd_carrier_right_ry*work.R_carrier_right_aux2_z_y;
  work.s4_21 = work.s4_20 + work.s4_14;
  work.s4_22 = work.w_chassis_y*work.s4_21 - work.w_chassis_z*work.s4_19;
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  work.s4_23 = zd_rear_axle_ry*R_rear_axle_aux4_x_x;
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  work.s4_24 = zd_rear_axle_rx*work.R_rear_axle_aux5_y_x;
  work.s4_25 = work.s4_23 + work.s4_24;
  work.s4_26 = zd_rear_axle_ry*R_rear_axle_aux4_y_x;
  work.s4_27 = zd_rear_axle_rx*work.R_rear_axle_aux5_x_x;
  work.s4_28 = work.s4_27 - work.s4_26;
  work.s4_29 = work.w_chassis_x*work.s4_25 - work.w_chassis_y*work.s4_28;
  work.s4_30 = zd_rear_axle_rx*s1_49;
  const double s4_31 = state.zd[Coordinate::rear_axle_rz] - work.s4_30;
  work.s4_32 = work.w_chassis_y*s4_31 - work.w_chassis_z*work.s4_25;
  work.s4_33 = work.w_chassis_z*work.s4_28 - work.w_chassis_x*s4_31;
  // bell_crank: bell_crank, revolute, chassis
  work.s4_34 = zd_carrier_left_rx*R_carrier_left_aux1_x_x;
  const double s4_35 = state.zd[Coordinate::lower_arm_left] + work.s4_34;
  work.s4_36 = work.s4_9*s4_35;
  work.s4_37 = work.s4_6*s4_35;
  work.s4_38 = zd_carrier_left_ry*work.s1_19;
  work.s4_39 = s4_35 - work.s4_38;
  work.s4_40 = work.w_chassis_z*work.s4_39 - work.w_chassis_x*work.s4_10;
  work.s4_41 = work.w_chassis_x*work.s4_8 - work.w_chassis_y*work.s4_39;
  work.s4_42 = zd_carrier_right_rx*R_carrier_right_aux1_x_x;
  const double s4_43 = state.zd[Coordinate::lower_arm_right] + work.s4_42;
  work.s4_44 = work.s4_20*s4_43;
  work.s4_45 = work.s4_17*s4_43;
  work.s4_46 = zd_carrier_right_ry*work.s1_39;
  work.s4_47 = s4_43 - work.s4_46;
  work.s4_48 = work.w_chassis_z*work.s4_47 - work.w_chassis_x*work.s4_21;
  work.s4_49 = work.w_chassis_x*work.s4_19 - work.w_chassis_y*work.s4_47;
  work.w_carrier_left_y = work.w_chassis_y + work.s4_8;
  const double s4_50 = work.R_carrier_left_aux2_y_y*work.w_carrier_left_y;
  work.w_carrier_left_x = work.w_chassis_x + work.s4_39;
  const double s4_51 = work.R_carrier_left_aux2_y_y*work.w_carrier_left_x;
  work.s4_52 = work.s1_19*work.w_carrier_left_y + s4_51;
  work.w_carrier_left_z = work.w_chassis_z + work.s4_10;
  const double s4_53 = work.R_carrier_left_aux2_z_y*work.w_carrier_left_z;
  const double s4_54 = state.zd[Coordinate::wheel_front_left] + s4_50 + s4_53;
  work.s4_55 = s4_54 - work.s1_19*work.w_carrier_left_x;
  const double s4_56 = work.R_carrier_left_aux2_z_y*work.w_carrier_left_y;
  work.s4_57 = s4_56 - work.R_carrier_left_aux2_y_y*work.w_carrier_left_z;
  const double s4_58 = work.R_carrier_left_aux2_z_y*work.w_carrier_left_x;
  work.s4_59 = s4_58 + work.s1_19*work.w_carrier_left_z;
  work.w_carrier_right_y = work.w_chassis_y + work.s4_19;
  const double s4_60 = work.R_carrier_right_aux2_y_y*work.w_carrier_right_y;
  work.w_carrier_right_x = work.w_chassis_x + work.s4_47;
  const double s4_61 = work.R_carrier_right_aux2_y_y*work.w_carrier_right_x;
  work.s4_62 = work.s1_39*work.w_carrier_right_y + s4_61;
  work.w_carrier_right_z = work.w_chassis_z + work.s4_21;
  const double s4_63 = work.R_carrier_right_aux2_z_y*work.w_carrier_right_z;
  const double s4_64 = state.zd[Coordinate::wheel_front_right] + s4_60 + s4_63;
  work.s4_65 = s4_64 - work.s1_39*work.w_carrier_right_x;
  const double s4_66 = work.R_carrier_right_aux2_z_y*work.w_carrier_right_y;
  work.s4_67 = s4_66 - work.R_carrier_right_aux2_y_y*work.w_carrier_right_z;
  const double s4_68 = work.R_carrier_right_aux2_z_y*work.w_carrier_right_x;
  work.s4_69 = s4_68 + work.s1_39*work.w_carrier_right_z;
  // arb_rear_right: arb_rear_right, revolute, chassis
  work.w_rear_axle_x = work.w_chassis_x + work.s4_28;
  work.w_rear_axle_y = work.w_chassis_y + work.s4_25;
  const double s4_70 = work.R_rear_axle_y_y*work.w_rear_axle_x;
  const double s4_71 = s4_70 - work.R_rear_axle_x_y*work.w_rear_axle_y;
  work.w_rear_axle_z = work.w_chassis_z + s4_31;
  const double s4_72 = work.R_rear_axle_y_y*work.w_rear_axle_y;
  const double s4_73 = s4_72 + work.R_rear_axle_z_y*work.w_rear_axle_z;
  const double s4_74 = s4_73 + work.R_rear_axle_x_y*work.w_rear_axle_x;
  const double s4_75 = work.R_rear_axle_z_y*work.w_rear_axle_y;
  const double s4_76 = s4_75 - work.R_rear_axle_y_y*work.w_rear_axle_z;
  const double s4_77 = work.R_rear_axle_x_y*work.w_rear_axle_z;
  const double s4_78 = s4_77 - work.R_rear_axle_z_y*work.w_rear_axle_x;
  const double s4_79 = state.zd[Coordinate::wheel_rear_right] + s4_74;
  const double s4_80 = s4_79 + (state.zd[Coordinate::wheel_rear_left] + s4_74);
  // operations: 53 add, 70 multiply

  // --- step 8: elimination from the leaves to the root (63) ---
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s8_1 = tau[Coordinate::wheel_rear_left] + tau[Coordinate::wheel_rear_right];
  const double s8_2 = 22.0*s4_80;
  work.s8_3 = work.R_rear_axle_x_y*s8_1 + s4_76*s8_2;
  work.s8_4 = work.R_rear_axle_y_y*s8_1 + s4_78*s8_2;
  work.s8_5 = work.R_rear_axle_z_y*s8_1 + s4_71*s8_2;

  // --- step 2: closure Jacobian Phi_z and its factors (60), long_rod_left .. arb_link_rear_right
  // ---
  // long_rod_left
  const double s2_1 = 0.04999999999999982*work.R_rear_axle_aux5_x_x;
  const double s2_2 = s2_1 - 0.08000000000000002*work.R_rear_axle_x_z;
  const double s2_3 = 0.04999999999999982*work.R_rear_axle_aux5_y_x;
  const double s2_4 = s2_3 - 0.08000000000000002*work.R_rear_axle_y_z;
  const double s2_5 = 0.08000000000000002*work.R_rear_axle_z_z + 0.04999999999999982*s1_49;
  const double s2_6 = 0.55*work.R_rear_axle_x_y;
  work.s2_7 = s2_6 + s2_2;
  const double s2_8 = 0.55*work.R_rear_axle_y_y;
  work.s2_9 = s2_8 + s2_4;
  work.s2_10 = work.s4_28*work.s2_9 - work.s4_25*work.s2_7;
  const double s2_11 = 0.55*work.R_rear_axle_z_y;
  work.s2_12 = s2_11 - s2_5;
  work.s2_13 = work.s4_25*work.s2_12 - s4_31*work.s2_9;
  work.s2_14 = s4_31*work.s2_7 - work.s4_28*work.s2_12;
  work.s2_15 = work.s4_25*work.s2_10 - s4_31*work.s2_14;
  work.s2_16 = s4_31*work.s2_13 - work.s4_28*work.s2_10;
  work.s2_17 = work.s4_28*work.s2_14 - work.s4_25*work.s2_13;
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - 2.4999999999999996;
  work.s2_18 = 1.6 + (work.r_rear_axle_aux1_x + work.s2_7);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  work.s2_19 = 0.55 - z_rear_axle_ty - work.s2_9;
  work.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] - 0.5;
  work.s2_20 = 0.55 + (work.r_rear_axle_aux3_z + work.s2_12);
  const double s2_21 = work.s2_12*work.s2_19 + work.s2_9*work.s2_20;
  // diag_rod_left
  const double s2_22 = 0.1*work.R_rear_axle_x_y;
  const double s2_23 = 0.25*work.R_rear_axle_x_z;
  work.s2_24 = s2_22 + s2_23;
  const double s2_25 = 0.1*work.R_rear_axle_y_y;
  const double s2_26 = 0.25*work.R_rear_axle_y_z;
  work.s2_27 = s2_25 + s2_26;
  work.s2_28 = work.s4_28*work.s2_27 - work.s4_25*work.s2_24;
  const double s2_29 = 0.1*work.R_rear_axle_z_y;
  const double s2_30 = 0.25*work.R_rear_axle_z_z;
  work.s2_31 = s2_29 + s2_30;
  work.s2_32 = work.s4_25*work.s2_31 - s4_31*work.s2_27;
  work.s2_33 = s4_31*work.s2_24 - work.s4_28*work.s2_31;
  work.s2_34 = work.s4_25*work.s2_28 - s4_31*work.s2_33;
  work.s2_35 = s4_31*work.s2_32 - work.s4_28*work.s2_28;
  work.s2_36 = work.s4_28*work.s2_33 - work.s4_25*work.s2_32;
  work.s2_37 = 1.6999999999999997 + (work.r_rear_axle_aux1_x + work.s2_24);
  work.s2_38 = 0.4 - z_rear_axle_ty - work.s2_27;
  work.s2_39 = 0.15000000000000002 + (work.r_rear_axle_aux3_z + work.s2_31);
  const double s2_40 = work.s2_31*work.s2_38 + work.s2_27*work.s2_39;
  // arb_link_rear_left
  const double s2_41 = 0.35000000000000053*work.R_rear_axle_aux5_x_x;
  const double s2_42 = 0.15000000000000002*work.R_rear_axle_x_z + s2_41;
  const double s2_43 = 0.35000000000000053*work.R_rear_axle_aux5_y_x;
  const double s2_44 = 0.15000000000000002*work.R_rear_axle_y_z + s2_43;
  const double s2_45 = 0.35000000000000053*s1_49 - 0.15000000000000002*work.R_rear_axle_z_z;
  const double s2_46 = 0.6*work.R_rear_axle_x_y;
  work.s2_47 = s2_46 - s2_42;
  const double s2_48 = 0.6*work.R_rear_axle_y_y;
  work.s2_49 = s2_48 - s2_44;
  work.s2_50 = work.s4_28*work.s2_49 - work.s4_25*work.s2_47;
  const double s2_51 = 0.6*work.R_rear_axle_z_y;
  work.s2_52 = s2_51 + s2_45;
  work.s2_53 = work.s4_25*work.s2_52 - s4_31*work.s2_49;
  work.s2_54 = s4_31*work.s2_47 - work.s4_28*work.s2_52;
  work.s2_55 = s4_31*work.s2_53 - work.s4_28*work.s2_50;
  work.s2_56 = work.s4_25*work.s2_50 - s4_31*work.s2_54;
  work.s2_57 = 0.35000000000000053*work.cosines[20];
  work.s2_58 = work.s2_57 - work.r_rear_axle_aux1_x - work.s2_47 - 3.3000000000000003;
  work.s2_59 = 0.6 - z_rear_axle_ty - work.s2_49;
  work.s2_60 = 0.35000000000000053*work.sines[20];
  const double s2_61 = work.s2_52 + (work.r_rear_axle_aux3_z + work.s2_60);
  work.s2_62 = 0.44999999999999996 + s2_61;
  work.s2_63 = work.s2_57*work.s2_62 - work.s2_60*work.s2_58;
  const double s2_64 = work.s2_52*work.s2_59 + work.s2_49*work.s2_62;
  // long_rod_right
  work.s2_65 = s2_2 - s2_6;
  work.s2_66 = s2_4 - s2_8;
  work.s2_67 = work.s4_28*work.s2_66 - work.s4_25*work.s2_65;
  work.s2_68 = s2_11 + s2_5;
  work.s2_69 = s4_31*work.s2_66 + work.s4_25*work.s2_68;
  work.s2_70 = work.s4_28*work.s2_68 + s4_31*work.s2_65;
  work.s2_71 = work.s4_25*work.s2_67 - s4_31*work.s2_70;
  work.s2_72 = work.s4_28*work.s2_67 + s4_31*work.s2_69;
  work.s2_73 = work.s4_25*work.s2_69 + work.s4_28*work.s2_70;
  work.s2_74 = 1.6 + (work.r_rear_axle_aux1_x + work.s2_65);
  work.s2_75 = 0.55 + (z_rear_axle_ty + work.s2_66);
  work.s2_76 = 0.55 + (work.r_rear_axle_aux3_z - work.s2_68);
  const double s2_77 = work.s2_68*work.s2_75 + work.s2_66*work.s2_76;
  // diag_rod_right
  work.s2_78 = s2_23 - s2_22;
  work.s2_79 = s2_26 - s2_25;
  work.s2_80 = work.s4_28*work.s2_79 - work.s4_25*work.s2_78;
  work.s2_81 = s2_30 - s2_29;
  work.s2_82 = work.s4_25*work.s2_81 - s4_31*work.s2_79;
  work.s2_83 = s4_31*work.s2_78 - work.s4_28*work.s2_81;
  work.s2_84 = work.s4_25*work.s2_80 - s4_31*work.s2_83;
  work.s2_85 = s4_31*work.s2_82 - work.s4_28*work.s2_80;
  work.s2_86 = work.s4_28*work.s2_83 - work.s4_25*work.s2_82;
  work.s2_87 = 1.6999999999999997 + (work.r_rear_axle_aux1_x + work.s2_78);
  work.s2_88 = 0.4 + (z_rear_axle_ty + work.s2_79);
  work.s2_89 = work.s2_79*work.s2_87 - work.s2_78*work.s2_88;
  work.s2_90 = 0.15000000000000002 + (work.r_rear_axle_aux3_z + work.s2_81);
  work.s2_91 = work.s2_81*work.s2_88 - work.s2_79*work.s2_90;
  work.s2_92 = work.s2_78*work.s2_90 - work.s2_81*work.s2_87;
  work.s2_93 = work.s2_88*work.s2_85 + work.s2_90*work.s2_86 + work.s2_87*work.s2_84;
  // arb_link_rear_right
  work.s2_94 = s2_46 + s2_42;
  work.s2_95 = s2_48 + s2_44;
  work.s2_96 = work.s4_25*work.s2_94 - work.s4_28*work.s2_95;
  work.s2_97 = s2_45 - s2_51;
  work.s2_98 = s4_31*work.s2_95 + work.s4_25*work.s2_97;
  work.s2_99 = work.s4_28*work.s2_97 + s4_31*work.s2_94;
  work.s2_100 = s4_31*work.s2_98 - work.s4_28*work.s2_96;
  work.s2_101 = s4_31*work.s2_99 + work.s4_25*work.s2_96;
  work.s2_102 = work.s4_25*work.s2_98 + work.s4_28*work.s2_99;
  work.s2_103 = 0.35000000000000053*work.cosines[21];
  work.s2_104 = work.s2_94 + work.s2_103 - work.r_rear_axle_aux1_x - 3.3000000000000003;
  work.s2_105 = 0.6 + (z_rear_axle_ty - work.s2_95);
  work.s2_106 = 0.35000000000000053*work.sines[21];
  const double s2_107 = work.s2_97 + (work.r_rear_axle_aux3_z + work.s2_106);
  work.s2_108 = 0.44999999999999996 + s2_107;
  work.s2_109 = work.s2_103*work.s2_108 - work.s2_106*work.s2_104;
  work.s2_110 = 1.0/work.s2_87;
  work.s2_111 = work.s2_37*work.s2_110;
  const double s2_112 = work.s2_38 + work.s2_88*work.s2_111;
  work.s2_113 = work.s2_39 - work.s2_90*work.s2_111;
  work.s2_114 = s2_40 + work.s2_91*work.s2_111;
  work.s2_115 = work.s2_92*work.s2_111 - work.s2_24*work.s2_39 + work.s2_31*work.s2_37;
  work.s2_116 = work.s2_89*work.s2_111 - work.s2_27*work.s2_37 - work.s2_24*work.s2_38;
  const double s2_117 = 1.2494533266510743*std::abs(work.s2_87);
  work.s2_118 = work.s2_18*work.s2_110;
  work.s2_119 = 1.0/s2_112;
  work.s2_120 = work.s2_119*(work.s2_19 + work.s2_88*work.s2_118);
  work.s2_121 = work.s2_20 - work.s2_90*work.s2_118 - work.s2_113*work.s2_120;
  work.s2_122 = s2_21 + work.s2_91*work.s2_118 - work.s2_114*work.s2_120;
  const double s2_123 = work.s2_92*work.s2_118 - work.s2_7*work.s2_20 + work.s2_12*work.s2_18;
  work.s2_124 = s2_123 - work.s2_115*work.s2_120;
  const double s2_125 = work.s2_89*work.s2_118 - work.s2_9*work.s2_18 - work.s2_7*work.s2_19;
  const double s2_126 = s2_125 - work.s2_116*work.s2_120;
  const double s2_127 = mbgen::min(s2_117, 1.665350081353039*std::abs(s2_112));
  work.s2_128 = work.s2_74*work.s2_110;
  work.s2_129 = work.s2_119*(work.s2_75 - work.s2_88*work.s2_128);
  const double s2_130 = work.s2_89*work.s2_128 - work.s2_66*work.s2_74 + work.s2_65*work.s2_75;
  const double s2_131 = work.s2_92*work.s2_128 - work.s2_65*work.s2_76 - work.s2_68*work.s2_74;
  work.s2_132 = 1.0/s2_126;
  work.s2_133 = work.s2_132*(s2_130 + work.s2_116*work.s2_129);
  const double s2_134 = work.s2_76 - work.s2_90*work.s2_128 + work.s2_113*work.s2_129;
  work.s2_135 = s2_134 - work.s2_121*work.s2_133;
  const double s2_136 = s2_77 + work.s2_91*work.s2_128 + work.s2_114*work.s2_129;
  work.s2_137 = s2_136 - work.s2_122*work.s2_133;
  const double s2_138 = s2_131 + work.s2_115*work.s2_129 - work.s2_124*work.s2_133;
  const double s2_139 = mbgen::min(s2_127, 2.1234888829989926*std::abs(s2_126));
  work.s2_140 = work.s2_104*work.s2_110;
  work.s2_141 = work.s2_119*(work.s2_105 + work.s2_88*work.s2_140);
  const double s2_142 = work.s2_116*work.s2_141 - work.s2_95*work.s2_104;
  const double s2_143 = work.s2_115*work.s2_141 - work.s2_97*work.s2_104;
  const double s2_144 = work.s2_114*work.s2_141 - work.s2_97*work.s2_105;
  work.s2_145 = work.s2_132*(s2_142 - work.s2_94*work.s2_105 - work.s2_89*work.s2_140);
  const double s2_146 = s2_143 + work.s2_94*work.s2_108 - work.s2_92*work.s2_140;
  const double s2_147 = work.s2_108 + work.s2_90*work.s2_140 + work.s2_113*work.s2_141;
  const double s2_148 = s2_144 - work.s2_95*work.s2_108 - work.s2_91*work.s2_140;
  work.s2_149 = 1.0/s2_138;
  work.s2_150 = work.s2_149*(s2_146 - work.s2_124*work.s2_145);
  work.s2_151 = s2_147 - work.s2_121*work.s2_145 - work.s2_135*work.s2_150;
  const double s2_152 = s2_148 - work.s2_122*work.s2_145 - work.s2_137*work.s2_150;
  const double s2_153 = mbgen::min(s2_139, 1.7864443153153613*std::abs(s2_138));
  work.s2_154 = work.s2_58*work.s2_110;
  work.s2_155 = work.s2_119*(work.s2_88*work.s2_154 - work.s2_59);
  const double s2_156 = work.s2_116*work.s2_155 - work.s2_47*work.s2_59 + work.s2_49*work.s2_58;
  const double s2_157 = work.s2_115*work.s2_155 - work.s2_47*work.s2_62 - work.s2_52*work.s2_58;
  work.s2_158 = work.s2_132*(s2_156 - work.s2_89*work.s2_154);
  const double s2_159 = s2_64 - work.s2_91*work.s2_154 + work.s2_114*work.s2_155;
  const double s2_160 = work.s2_62 + work.s2_90*work.s2_154 + work.s2_113*work.s2_155;
  work.s2_161 = work.s2_149*(s2_157 - work.s2_92*work.s2_154 - work.s2_124*work.s2_158);
  work.s2_162 = 1.0/s2_152;
  work.s2_163 = work.s2_162*(s2_159 - work.s2_122*work.s2_158 - work.s2_137*work.s2_161);
  const double s2_164 = s2_160 - work.s2_121*work.s2_158 - work.s2_135*work.s2_161;
  work.s2_165 = s2_164 - work.s2_151*work.s2_163;
  const double s2_166 = mbgen::min(s2_153, 8.176955428452642*std::abs(s2_152));
  work.s2_167 = mbgen::min(s2_166, 2.7700489841913827*std::abs(work.s2_165));
  // operations: 178 add, 217 multiply, 5 divide, 11 other
}

/// Part 2 of compute_accelerations: step 3: Rz (61), long_rod_left .. arb_link_rear_right; step 6:
/// c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right; step 7: inertias of the bodies and
/// forces on joints, long_rod_left .. arb_link_rear_right; step 8: elimination from the leaves to
/// the root (63), long_rod_left .. arb_link_rear_right; step 7: inertias of the bodies and forces
/// on joints, long_rod_left .. arb_link_rear_right; step 8: elimination from the leaves to the root
/// (63), long_rod_left .. arb_link_rear_right.
[[gnu::noinline]] void compute_accelerations_2(const State& state, const double* tau,
    AccelerationsWork& __restrict work) noexcept {
  // --- step 3: Rz (61), long_rod_left .. arb_link_rear_right ---
  const double s3_1 = 1.0/work.s2_165;
  work.s3_2 = work.s2_63*s3_1;
  work.Rz_rear_axle_rz_0 = work.s2_162*(work.s2_151*work.s3_2);
  work.Rz_rear_axle_ry_0 = work.s2_149*(work.s2_135*work.s3_2 - work.s2_137*work.Rz_rear_axle_rz_0);
  const double s3_3 = work.s2_121*work.s3_2 - work.s2_124*work.Rz_rear_axle_ry_0;
  const double s3_4 = work.s2_9*work.Rz_rear_axle_rz_0 - work.s3_2;
  work.s3_5 = s3_4 - work.s2_7*work.Rz_rear_axle_ry_0;
  const double s3_6 = work.s2_27*work.Rz_rear_axle_rz_0 - work.s3_2;
  work.s3_7 = s3_6 - work.s2_24*work.Rz_rear_axle_ry_0;
  const double s3_8 = work.s2_66*work.Rz_rear_axle_rz_0 - work.s3_2;
  work.s3_9 = s3_8 - work.s2_65*work.Rz_rear_axle_ry_0;
  const double s3_10 = work.s2_79*work.Rz_rear_axle_rz_0 - work.s3_2;
  work.s3_11 = s3_10 - work.s2_78*work.Rz_rear_axle_ry_0;
  const double s3_12 = work.s2_94*work.Rz_rear_axle_ry_0 - work.s3_2;
  work.s3_13 = s3_12 - work.s2_95*work.Rz_rear_axle_rz_0;
  work.Rz_rear_axle_rx_0 = work.s2_132*(s3_3 - work.s2_122*work.Rz_rear_axle_rz_0);
  const double s3_14 = work.s2_113*work.s3_2 - work.s2_116*work.Rz_rear_axle_rx_0;
  const double s3_15 = s3_14 - work.s2_115*work.Rz_rear_axle_ry_0;
  work.s3_16 = work.s2_119*(s3_15 - work.s2_114*work.Rz_rear_axle_rz_0);
  const double s3_17 = work.s2_88*work.s3_16 + work.s2_89*work.Rz_rear_axle_rx_0;
  const double s3_18 = s3_17 + work.s2_92*work.Rz_rear_axle_ry_0;
  const double s3_19 = work.s2_7*work.Rz_rear_axle_rx_0 - work.s3_16;
  work.s3_20 = s3_19 - work.s2_12*work.Rz_rear_axle_rz_0;
  const double s3_21 = work.s2_24*work.Rz_rear_axle_rx_0 - work.s3_16;
  work.s3_22 = s3_21 - work.s2_31*work.Rz_rear_axle_rz_0;
  const double s3_23 = work.s2_47*work.Rz_rear_axle_rx_0 - work.s3_16;
  work.s3_24 = s3_23 - work.s2_52*work.Rz_rear_axle_rz_0;
  const double s3_25 = work.s2_68*work.Rz_rear_axle_rz_0 - work.s3_16;
  work.s3_26 = s3_25 + work.s2_65*work.Rz_rear_axle_rx_0;
  const double s3_27 = work.s2_78*work.Rz_rear_axle_rx_0 - work.s3_16;
  work.s3_28 = s3_27 - work.s2_81*work.Rz_rear_axle_rz_0;
  const double s3_29 = work.s3_16 + work.s2_97*work.Rz_rear_axle_rz_0;
  work.s3_30 = s3_29 + work.s2_94*work.Rz_rear_axle_rx_0;
  const double s3_31 = s3_18 + work.s2_91*work.Rz_rear_axle_rz_0 + work.s2_90*work.s3_2;
  work.Rz_rear_axle_tx_0 = work.s2_110*s3_31;
  const double s3_32 = work.Rz_rear_axle_tx_0 + work.s2_12*work.Rz_rear_axle_ry_0;
  work.s3_33 = s3_32 - work.s2_9*work.Rz_rear_axle_rx_0;
  const double s3_34 = work.Rz_rear_axle_tx_0 + work.s2_31*work.Rz_rear_axle_ry_0;
  work.s3_35 = s3_34 - work.s2_27*work.Rz_rear_axle_rx_0;
  const double s3_36 = work.Rz_rear_axle_tx_0 - work.s2_66*work.Rz_rear_axle_rx_0;
  work.s3_37 = s3_36 - work.s2_68*work.Rz_rear_axle_ry_0;
  const double s3_38 = work.Rz_rear_axle_tx_0 + work.s2_81*work.Rz_rear_axle_ry_0;
  work.s3_39 = s3_38 - work.s2_79*work.Rz_rear_axle_rx_0;
  const double s3_40 = work.Rz_rear_axle_tx_0 + work.s2_95*work.Rz_rear_axle_rx_0;
  work.s3_41 = s3_40 + work.s2_97*work.Rz_rear_axle_ry_0;
  const double s3_42 = work.s3_20*work.s3_20 + work.s3_5*work.s3_5 + work.s3_33*work.s3_33;
  const double s3_43 = s3_42 + work.s3_26*work.s3_26 + work.s3_9*work.s3_9;
  work.s3_44 = s3_43 + work.s3_37*work.s3_37;
  const double s3_45 = work.s3_22*work.s3_22 + work.s3_7*work.s3_7 + work.s3_35*work.s3_35;
  const double s3_46 = s3_45 + work.s3_28*work.s3_28 + work.s3_11*work.s3_11;
  work.s3_47 = s3_46 + work.s3_39*work.s3_39;
  work.Rz_rear_axle_tz_1 = work.s2_109*work.s2_163*s3_1;
  work.s3_48 = work.s2_162*(work.s2_109 + work.s2_151*work.Rz_rear_axle_tz_1);
  const double s3_49 = work.s2_137*work.s3_48 - work.s2_135*work.Rz_rear_axle_tz_1;
  work.Rz_rear_axle_ry_1 = work.s2_149*s3_49;
  const double s3_50 = work.s2_122*work.s3_48 - work.s2_124*work.Rz_rear_axle_ry_1;
  const double s3_51 = work.Rz_rear_axle_tz_1 - work.s2_7*work.Rz_rear_axle_ry_1;
  work.s3_52 = s3_51 - work.s2_9*work.s3_48;
  const double s3_53 = work.Rz_rear_axle_tz_1 - work.s2_24*work.Rz_rear_axle_ry_1;
  work.s3_54 = s3_53 - work.s2_27*work.s3_48;
  const double s3_55 = work.Rz_rear_axle_tz_1 - work.s2_47*work.Rz_rear_axle_ry_1;
  work.s3_56 = s3_55 - work.s2_49*work.s3_48;
  const double s3_57 = work.Rz_rear_axle_tz_1 - work.s2_65*work.Rz_rear_axle_ry_1;
  work.s3_58 = s3_57 - work.s2_66*work.s3_48;
  const double s3_59 = work.Rz_rear_axle_tz_1 - work.s2_78*work.Rz_rear_axle_ry_1;
  work.s3_60 = s3_59 - work.s2_79*work.s3_48;
  work.Rz_rear_axle_rx_1 = work.s2_132*(s3_50 - work.s2_121*work.Rz_rear_axle_tz_1);
  const double s3_61 = work.s2_114*work.s3_48 - work.s2_116*work.Rz_rear_axle_rx_1;
  const double s3_62 = s3_61 - work.s2_115*work.Rz_rear_axle_ry_1;
  work.s3_63 = work.s2_119*(s3_62 - work.s2_113*work.Rz_rear_axle_tz_1);
  const double s3_64 = work.s2_88*work.s3_63 + work.s2_89*work.Rz_rear_axle_rx_1;
  const double s3_65 = s3_64 + work.s2_92*work.Rz_rear_axle_ry_1 - work.s2_91*work.s3_48;
  work.s3_66 = work.s2_12*work.s3_48 - work.s3_63 + work.s2_7*work.Rz_rear_axle_rx_1;
  work.s3_67 = work.s2_31*work.s3_48 - work.s3_63 + work.s2_24*work.Rz_rear_axle_rx_1;
  work.s3_68 = work.s2_52*work.s3_48 - work.s3_63 + work.s2_47*work.Rz_rear_axle_rx_1;
  work.s3_69 = work.s2_65*work.Rz_rear_axle_rx_1 - work.s3_63 - work.s2_68*work.s3_48;
  work.s3_70 = work.s2_81*work.s3_48 - work.s3_63 + work.s2_78*work.Rz_rear_axle_rx_1;
  work.s3_71 = work.s2_97*work.s3_48 - work.s3_63 - work.s2_94*work.Rz_rear_axle_rx_1;
  work.Rz_rear_axle_tx_1 = work.s2_110*(s3_65 - work.s2_90*work.Rz_rear_axle_tz_1);
  const double s3_72 = work.Rz_rear_axle_tx_1 + work.s2_12*work.Rz_rear_axle_ry_1;
  work.s3_73 = s3_72 - work.s2_9*work.Rz_rear_axle_rx_1;
  const double s3_74 = work.Rz_rear_axle_tx_1 + work.s2_31*work.Rz_rear_axle_ry_1;
  work.s3_75 = s3_74 - work.s2_27*work.Rz_rear_axle_rx_1;
  const double s3_76 = work.Rz_rear_axle_tx_1 + work.s2_52*work.Rz_rear_axle_ry_1;
  work.s3_77 = s3_76 - work.s2_49*work.Rz_rear_axle_rx_1;
  const double s3_78 = work.Rz_rear_axle_tx_1 - work.s2_66*work.Rz_rear_axle_rx_1;
  work.s3_79 = s3_78 - work.s2_68*work.Rz_rear_axle_ry_1;
  const double s3_80 = work.Rz_rear_axle_tx_1 + work.s2_81*work.Rz_rear_axle_ry_1;
  work.s3_81 = s3_80 - work.s2_79*work.Rz_rear_axle_rx_1;
  const double s3_82 = work.s3_20*work.s3_66 + work.s3_5*work.s3_52 + work.s3_33*work.s3_73;
  const double s3_83 = s3_82 + work.s3_26*work.s3_69 + work.s3_9*work.s3_58;
  work.s3_84 = s3_83 + work.s3_37*work.s3_79;
  const double s3_85 = work.s3_22*work.s3_67 + work.s3_7*work.s3_54 + work.s3_35*work.s3_75;
  const double s3_86 = s3_85 + work.s3_28*work.s3_70 + work.s3_11*work.s3_60;
  work.s3_87 = s3_86 + work.s3_39*work.s3_81;
  const double s3_88 = work.s3_66*work.s3_66 + work.s3_52*work.s3_52 + work.s3_73*work.s3_73;
  const double s3_89 = s3_88 + work.s3_69*work.s3_69 + work.s3_58*work.s3_58;
  work.s3_90 = s3_89 + work.s3_79*work.s3_79;
  const double s3_91 = work.s3_67*work.s3_67 + work.s3_54*work.s3_54 + work.s3_75*work.s3_75;
  const double s3_92 = s3_91 + work.s3_70*work.s3_70 + work.s3_60*work.s3_60;
  work.s3_93 = s3_92 + work.s3_81*work.s3_81;
  const double s3_94 = work.s3_68*work.s3_68 + work.s3_56*work.s3_56 + work.s3_77*work.s3_77;
  work.s3_95 = s3_94 + work.s3_71*work.s3_71;
  // operations: 118 add, 147 multiply, 1 divide

  // --- step 6: c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right ---
  // long_rod_left
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s6_1 = zd_rear_axle_tx + work.s2_13;
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s6_2 = zd_rear_axle_ty + work.s2_14;
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  work.s6_3 = zd_rear_axle_tz + work.s2_10;
  // diag_rod_left
  const double s6_4 = zd_rear_axle_tx + work.s2_32;
  const double s6_5 = zd_rear_axle_ty + work.s2_33;
  work.s6_6 = zd_rear_axle_tz + work.s2_28;
  // arb_link_rear_left
  work.s6_7 = zd_rear_axle_ty + work.s2_54;
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double s6_8 = zd_arb_rear_left*work.s2_60;
  work.s6_9 = zd_arb_rear_left*s6_8 - work.s4_28*work.s2_54 + work.s4_25*work.s2_53;
  const double s6_10 = zd_arb_rear_left*work.s2_57;
  const double s6_11 = work.s2_56 + zd_arb_rear_left*s6_10;
  work.s6_12 = work.s2_53 + (zd_rear_axle_tx + s6_8);
  work.s6_13 = work.s2_50 + (zd_rear_axle_tz + s6_10);
  // long_rod_right
  const double s6_14 = zd_rear_axle_tx - work.s2_69;
  const double s6_15 = zd_rear_axle_ty + work.s2_70;
  work.s6_16 = zd_rear_axle_tz + work.s2_67;
  // diag_rod_right
  const double s6_17 = zd_rear_axle_tx + work.s2_82;
  const double s6_18 = zd_rear_axle_ty + work.s2_83;
  work.s6_19 = zd_rear_axle_tz + work.s2_80;
  const double s6_20 = work.s2_93 + s6_18*s6_18 + work.s6_19*work.s6_19 + s6_17*s6_17;
  const double s6_21 = work.s2_111*s6_20 - work.s2_39*work.s2_36 - work.s2_37*work.s2_34;
  const double s6_22 = s6_21 + work.s2_38*work.s2_35 - s6_5*s6_5 - work.s6_6*work.s6_6;
  const double s6_23 = s6_22 - s6_4*s6_4;
  const double s6_24 = work.s2_118*s6_20 - work.s2_20*work.s2_17 - work.s2_18*work.s2_15;
  const double s6_25 = s6_24 + work.s2_19*work.s2_16 - s6_2*s6_2 - work.s6_3*work.s6_3;
  const double s6_26 = s6_25 - s6_1*s6_1 - work.s2_120*s6_23;
  const double s6_27 = work.s2_128*s6_20 - work.s2_76*work.s2_73 - work.s2_74*work.s2_71;
  const double s6_28 = s6_27 + work.s2_75*work.s2_72 - s6_15*s6_15 - work.s6_16*work.s6_16;
  const double s6_29 = s6_28 - s6_14*s6_14 + work.s2_129*s6_23 - work.s2_133*s6_26;
  const double s6_30 = work.s2_141*s6_23 - work.s2_105*work.s2_100;
  const double s6_31 = work.s2_140*s6_20;
  const double s6_32 = work.s2_145*s6_26;
  const double s6_33 = work.s2_150*s6_29;
  const double s6_34 = work.s2_155*s6_23 - work.s6_7*work.s6_7 - work.s6_13*work.s6_13;
  const double s6_35 = s6_34 - work.s6_12*work.s6_12 + work.s2_59*work.s2_55;
  const double s6_36 = s6_35 + work.s2_62*work.s6_9 + work.s2_58*s6_11 - work.s2_154*s6_20;
  const double s6_37 = s6_36 - work.s2_158*s6_26 - work.s2_161*s6_29;
  // arb_link_rear_right
  work.s6_38 = zd_rear_axle_ty - work.s2_99;
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double s6_39 = zd_arb_rear_right*work.s2_106;
  work.s6_40 = work.s2_102 + zd_arb_rear_right*s6_39;
  const double s6_41 = zd_arb_rear_right*work.s2_103;
  const double s6_42 = work.s2_101 + zd_arb_rear_right*s6_41;
  const double s6_43 = s6_30 + work.s2_108*work.s6_40 + work.s2_104*s6_42;
  work.s6_44 = work.s2_98 + (zd_rear_axle_tx + s6_39);
  work.s6_45 = work.s2_96 + (zd_rear_axle_tz + s6_41);
  const double s6_46 = s6_43 - work.s6_38*work.s6_38 - work.s6_45*work.s6_45;
  const double s6_47 = s6_46 - work.s6_44*work.s6_44 - s6_31 - s6_32 - s6_33;
  work.zdd_star_rear_axle_tz = s3_1*(s6_37 - work.s2_163*s6_47);
  work.zdd_star_rear_axle_rz = work.s2_162*(s6_47 - work.s2_151*work.zdd_star_rear_axle_tz);
  const double s6_48 = s6_29 - work.s2_137*work.zdd_star_rear_axle_rz;
  work.zdd_star_rear_axle_ry = work.s2_149*(s6_48 - work.s2_135*work.zdd_star_rear_axle_tz);
  const double s6_49 = s6_26 - work.s2_124*work.zdd_star_rear_axle_ry;
  const double s6_50 = s6_49 - work.s2_122*work.zdd_star_rear_axle_rz;
  const double s6_51 = work.s2_12*work.zdd_star_rear_axle_ry;
  const double s6_52 = work.s2_31*work.zdd_star_rear_axle_ry;
  const double s6_53 = work.s2_52*work.zdd_star_rear_axle_ry;
  const double s6_54 = work.s2_68*work.zdd_star_rear_axle_ry;
  const double s6_55 = work.s2_81*work.zdd_star_rear_axle_ry;
  const double s6_56 = work.s2_97*work.zdd_star_rear_axle_ry;
  work.zdd_star_rear_axle_rx = work.s2_132*(s6_50 - work.s2_121*work.zdd_star_rear_axle_tz);
  const double s6_57 = s6_23 - work.s2_116*work.zdd_star_rear_axle_rx;
  const double s6_58 = s6_57 - work.s2_115*work.zdd_star_rear_axle_ry;
  const double s6_59 = s6_58 - work.s2_114*work.zdd_star_rear_axle_rz;
  const double s6_60 = work.s2_9*work.zdd_star_rear_axle_rx;
  work.s6_61 = work.s2_7*work.zdd_star_rear_axle_rx;
  const double s6_62 = work.s2_27*work.zdd_star_rear_axle_rx;
  work.s6_63 = work.s2_24*work.zdd_star_rear_axle_rx;
  const double s6_64 = work.s2_49*work.zdd_star_rear_axle_rx;
  work.s6_65 = work.s2_47*work.zdd_star_rear_axle_rx;
  const double s6_66 = work.s2_66*work.zdd_star_rear_axle_rx;
  work.s6_67 = work.s2_65*work.zdd_star_rear_axle_rx;
  const double s6_68 = work.s2_79*work.zdd_star_rear_axle_rx;
  work.s6_69 = work.s2_78*work.zdd_star_rear_axle_rx;
  const double s6_70 = work.s2_95*work.zdd_star_rear_axle_rx;
  work.s6_71 = work.s2_94*work.zdd_star_rear_axle_rx;
  work.s6_72 = work.s2_119*(s6_59 - work.s2_113*work.zdd_star_rear_axle_tz);
  const double s6_73 = work.s2_88*work.s6_72 - s6_20 + work.s2_89*work.zdd_star_rear_axle_rx;
  const double s6_74 = s6_73 + work.s2_92*work.zdd_star_rear_axle_ry;
  const double s6_75 = s6_74 + work.s2_91*work.zdd_star_rear_axle_rz;
  work.zdd_star_rear_axle_tx = work.s2_110*(s6_75 - work.s2_90*work.zdd_star_rear_axle_tz);
  // operations: 85 add, 97 multiply

  // --- step 7: inertias of the bodies and forces on joints, long_rod_left .. arb_link_rear_right
  // ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_7 = 22.789999999999992*work.R_rear_axle_aux5_x_x;
  const double s7_8 = 0.03300000000000041*work.R_rear_axle_x_z + s7_7;
  const double s7_9 = 22.789999999999992*work.R_rear_axle_aux5_y_x;
  const double s7_10 = 0.03300000000000041*work.R_rear_axle_y_z + s7_9;
  const double s1_49 = work.sines[18];
  const double s7_11 = 3.469446951953614e-18*work.R_rear_axle_x_z;
  const double s7_12 = 617.7850000000001*work.R_rear_axle_x_y + s7_11;
  const double s7_13 = 3.469446951953614e-18*work.R_rear_axle_y_z;
  const double s7_14 = 617.7850000000001*work.R_rear_axle_y_y + s7_13;
  const double s7_15 = 3.469446951953614e-18*work.R_rear_axle_x_y;
  const double s7_16 = s7_15 + 23.660200000000025*work.R_rear_axle_x_z;
  const double s7_17 = s7_16 + 0.03300000000000041*work.R_rear_axle_aux5_x_x;
  const double s7_18 = 3.469446951953614e-18*work.R_rear_axle_y_y;
  const double s7_19 = s7_18 + 23.660200000000025*work.R_rear_axle_y_z;
  const double s7_20 = s7_19 + 0.03300000000000041*work.R_rear_axle_aux5_y_x;
  const double s7_21 = work.R_rear_axle_x_y*s7_12 + work.R_rear_axle_x_z*s7_17;
  work.s7_22 = s7_21 + work.R_rear_axle_aux5_x_x*s7_8;
  const double s7_23 = work.R_rear_axle_y_y*s7_14 + work.R_rear_axle_y_z*s7_20;
  work.s7_24 = s7_23 + work.R_rear_axle_aux5_y_x*s7_10;
  const double s7_25 = work.R_rear_axle_y_y*s7_12 + work.R_rear_axle_y_z*s7_17;
  work.s7_26 = s7_25 + work.R_rear_axle_aux5_y_x*s7_8;
  work.s7_27 = work.R_rear_axle_z_y*s7_12 + work.R_rear_axle_z_z*s7_17 - s1_49*s7_8;
  work.s7_28 = work.R_rear_axle_z_y*s7_14 + work.R_rear_axle_z_z*s7_20 - s1_49*s7_10;
  work.s7_29 = 664.2352000000001 - work.s7_22 - work.s7_24;
  const double s7_30 = 0.19999999999999582*work.R_rear_axle_aux5_x_x;
  work.s7_31 = 2.26*work.R_rear_axle_x_z + s7_30;
  const double s7_32 = 0.19999999999999582*work.R_rear_axle_aux5_y_x;
  work.s7_33 = 2.26*work.R_rear_axle_y_z + s7_32;
  work.s7_34 = 2.26*work.R_rear_axle_z_z - 0.19999999999999582*s1_49;

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right
  // ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  work.s8_6 = work.Rz_rear_axle_ry_0*work.s7_34 - work.Rz_rear_axle_rx_0*work.s7_33;
  work.s8_7 = work.Rz_rear_axle_rx_0*work.s7_31 - work.Rz_rear_axle_rz_0*work.s7_34;
  work.s8_8 = work.Rz_rear_axle_rz_0*work.s7_33 - work.Rz_rear_axle_ry_0*work.s7_31;
  work.s8_9 = work.Rz_rear_axle_ry_1*work.s7_34 - work.Rz_rear_axle_rx_1*work.s7_33;
  work.s8_10 = work.s3_48*work.s7_34 + work.Rz_rear_axle_rx_1*work.s7_31;
  const double s8_11 = work.s3_63*work.s7_34 + work.Rz_rear_axle_tz_1*work.s7_33;
  const double s8_12 = s8_11 - work.Rz_rear_axle_ry_1*work.s7_26;
  work.s8_13 = s8_12 - work.Rz_rear_axle_rx_1*work.s7_27;

  // --- step 7: inertias of the bodies and forces on joints, long_rod_left .. arb_link_rear_right,
  // continued ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  work.s7_35 = work.s7_29 + (work.s7_22 + work.s7_24);
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double R_arb_rear_left_x_x = work.cosines[20];
  const double s7_36 = 0.3875000000000011*R_arb_rear_left_x_x;
  const double R_arb_rear_left_x_z = work.sines[20];
  const double s7_37 = 0.034999999999999976*R_arb_rear_left_x_z;
  work.s7_38 = R_arb_rear_left_x_z*s7_37 + R_arb_rear_left_x_x*s7_36;
  work.s7_39 = R_arb_rear_left_x_x*s7_37 - R_arb_rear_left_x_z*s7_36;
  work.s7_40 = 1.5500000000000032*R_arb_rear_left_x_x;
  work.s7_41 = 1.5500000000000032*R_arb_rear_left_x_z;
  work.s7_42 = 0.4225000000000012 - work.s7_38;
  work.s7_43 = 0.1575 + (work.s7_38 + work.s7_42) - 0.1575;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double R_arb_rear_right_x_x = work.cosines[21];
  const double s7_44 = 0.3875000000000011*R_arb_rear_right_x_x;
  const double R_arb_rear_right_x_z = work.sines[21];
  const double s7_45 = 0.034999999999999976*R_arb_rear_right_x_z;
  work.s7_46 = R_arb_rear_right_x_z*s7_45 + R_arb_rear_right_x_x*s7_44;
  work.s7_47 = R_arb_rear_right_x_x*s7_45 - R_arb_rear_right_x_z*s7_44;
  work.s7_48 = 1.5500000000000032*R_arb_rear_right_x_x;
  work.s7_49 = 1.5500000000000032*R_arb_rear_right_x_z;
  work.s7_50 = 0.4225000000000012 - work.s7_46;
  work.s7_51 = 0.1575 + (work.s7_46 + work.s7_50) - 0.1575;
  // operations: 37 add, 51 multiply

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  work.s8_14 = work.w_chassis_x + work.w_chassis_x;
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  work.s8_15 = zd_upper_arm_right*zd_upper_arm_right + zd_upper_arm_right*work.s8_14;
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  work.s8_16 = zd_upper_arm_left*zd_upper_arm_left + zd_upper_arm_left*work.s8_14;
  work.s8_17 = work.w_chassis_y + work.w_chassis_y;
  work.s8_18 = zd_arb_rear_right*zd_arb_rear_right + zd_arb_rear_right*work.s8_17;
  work.s8_19 = zd_arb_rear_left*zd_arb_rear_left + zd_arb_rear_left*work.s8_17;
  const double s8_20 = work.zdd_star_rear_axle_tz + zd_rear_axle_ty*work.s8_14;
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  work.s8_21 = zd_pitman_arm*zd_pitman_arm + zd_pitman_arm*work.s8_17;
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  work.s8_22 = zd_arb_front_right*zd_arb_front_right + zd_arb_front_right*work.s8_17;
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  work.s8_23 = zd_arb_front_left*zd_arb_front_left + zd_arb_front_left*work.s8_17;
  work.s8_24 = work.w_chassis_z + work.w_chassis_z;
  const double s8_25 = work.zdd_star_rear_axle_tx + zd_rear_axle_tz*work.s8_17;
  work.s8_26 = s6_1*work.s8_24;
  work.s8_27 = s6_4*work.s8_24;
  work.s8_28 = work.s6_12*work.s8_24;
  work.s8_29 = s6_14*work.s8_24;
  work.s8_30 = s6_17*work.s8_24;
  const double s8_31 = work.s6_38*work.s8_24 - s6_42 - work.zdd_star_rear_axle_tx;
  work.s8_32 = work.s6_44*work.s8_24;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  work.s8_33 = zd_bell_crank*zd_bell_crank + zd_bell_crank*work.s8_24;
  work.s8_34 = work.w_chassis_y*work.w_chassis_x;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  work.s8_35 = 0.11250000000000018*R_arb_rear_right_x_z;
  work.s8_36 = 0.11250000000000018*R_arb_rear_left_x_z;
  work.s8_37 = work.w_chassis_z*work.w_chassis_x;
  const double s8_38 = s8_25 - zd_rear_axle_ty*work.s8_24 + z_rear_axle_ty*work.s8_34;
  const double s8_39 = work.s2_59*work.s8_34 - s6_11 - work.zdd_star_rear_axle_tx;
  const double s8_40 = s8_31 - work.s6_45*work.s8_17 - s6_70 - s6_56 - work.s2_105*work.s8_34;
  work.s8_41 = work.w_chassis_y*work.w_chassis_z;
  const double s8_42 = zd_rear_axle_tx*work.s8_24 - work.s6_72 - zd_rear_axle_tz*work.s8_14;
  const double s8_43 = s8_42 + work.r_rear_axle_aux3_z*work.s8_41;
  const double s8_44 = s8_20 - zd_rear_axle_tx*work.s8_17 + z_rear_axle_ty*work.s8_41;
  work.s8_45 = 0.11250000000000018*R_arb_rear_right_x_x;
  const double s8_46 = tau[Coordinate::arb_rear_right] - work.s8_35*work.s8_34;
  const double s8_47 = s8_46 - work.s8_45*work.s8_41;
  work.s8_48 = 0.11250000000000018*R_arb_rear_left_x_x;
  const double s8_49 = tau[Coordinate::arb_rear_left] + work.s8_36*work.s8_34;
  const double s8_50 = s8_49 + work.s8_48*work.s8_41;
  work.s8_51 = 3.25*work.s8_34 - 0.6*work.s8_41;
  const double s8_52 = work.w_chassis_y*work.w_chassis_y;
  const double s8_53 = work.w_chassis_z*work.w_chassis_z;
  work.s8_54 = s8_52 + s8_53;
  const double s8_55 = 3.3000000000000003*work.s8_54 - 0.44999999999999996*work.s8_37;
  const double s8_56 = s8_38 + work.r_rear_axle_aux3_z*work.s8_37;
  const double s8_57 = s8_56 - work.r_rear_axle_aux1_x*work.s8_54;
  const double s8_58 = work.s2_19*work.s8_34 - work.s2_15 - work.zdd_star_rear_axle_tx;
  const double s8_59 = s8_58 + work.s2_18*work.s8_54 - work.s2_20*work.s8_37 + s6_2*work.s8_24;
  work.s8_60 = s8_59 - work.s6_3*work.s8_17 - s6_51 + s6_60;
  const double s8_61 = work.s2_38*work.s8_34 - work.s2_34 - work.zdd_star_rear_axle_tx;
  const double s8_62 = s8_61 + work.s2_37*work.s8_54 - work.s2_39*work.s8_37 + s6_5*work.s8_24;
  work.s8_63 = s8_62 - work.s6_6*work.s8_17 - s6_52 + s6_62;
  const double s8_64 = s8_39 - work.s2_62*work.s8_37 - work.s2_58*work.s8_54;
  work.s8_65 = s8_64 + work.s6_7*work.s8_24 - work.s6_13*work.s8_17 - s6_53 + s6_64;
  const double s8_66 = work.s2_74*work.s8_54 - work.s2_71 - work.zdd_star_rear_axle_tx;
  const double s8_67 = s8_66 - work.s2_76*work.s8_37 - work.s2_75*work.s8_34 + s6_15*work.s8_24;
  work.s8_68 = s8_67 - work.s6_16*work.s8_17 + s6_66 + s6_54;
  const double s8_69 = work.s2_87*work.s8_54 - work.s2_84 - work.zdd_star_rear_axle_tx;
  const double s8_70 = s8_69 - work.s2_90*work.s8_37 - work.s2_88*work.s8_34 + s6_18*work.s8_24;
  work.s8_71 = s8_70 - work.s6_19*work.s8_17 - s6_55 + s6_68;
  work.s8_72 = s8_40 - work.s2_108*work.s8_37 - work.s2_104*work.s8_54;
  work.s8_73 = 0.6*work.s8_37 + 3.25*work.s8_54;
  work.s8_74 = 0.5*work.s8_34 - 0.4*work.s8_37 - 4.4*work.s8_54;
  work.s8_75 = 0.5*work.s8_37 + 3.95*work.s8_54;
  const double s8_76 = work.w_chassis_x*work.w_chassis_x;
  work.s8_77 = s8_76 + s8_53;
  const double s8_78 = s8_43 + work.r_rear_axle_aux1_x*work.s8_34 - z_rear_axle_ty*work.s8_77;
  work.s8_79 = s8_76 + s8_52;
  const double s8_80 = 0.44999999999999996*work.s8_79 - 3.3000000000000003*work.s8_37;
  const double s8_81 = s8_44 + work.r_rear_axle_aux1_x*work.s8_37;
  const double s8_82 = s8_81 - work.r_rear_axle_aux3_z*work.s8_79;
  const double s8_83 = work.s2_19*work.s8_41 - work.s2_17 - work.zdd_star_rear_axle_tz;
  const double s8_84 = s8_83 + work.s2_20*work.s8_79 - work.s2_18*work.s8_37 + s6_1*work.s8_17;
  const double s8_85 = s8_84 - s6_2*work.s8_14 - work.s2_9*work.zdd_star_rear_axle_rz;
  work.s8_86 = s8_85 + work.s2_7*work.zdd_star_rear_axle_ry;
  const double s8_87 = work.s2_38*work.s8_41 - work.s2_36 - work.zdd_star_rear_axle_tz;
  const double s8_88 = s8_87 + work.s2_39*work.s8_79 - work.s2_37*work.s8_37 + s6_4*work.s8_17;
  const double s8_89 = s8_88 - s6_5*work.s8_14 - work.s2_27*work.zdd_star_rear_axle_rz;
  work.s8_90 = s8_89 + work.s2_24*work.zdd_star_rear_axle_ry;
  const double s8_91 = work.s2_76*work.s8_79 - work.s2_73 - work.zdd_star_rear_axle_tz;
  const double s8_92 = s8_91 - work.s2_74*work.s8_37 - work.s2_75*work.s8_41 + s6_14*work.s8_17;
  const double s8_93 = s8_92 - s6_15*work.s8_14 - work.s2_66*work.zdd_star_rear_axle_rz;
  work.s8_94 = s8_93 + work.s2_65*work.zdd_star_rear_axle_ry;
  const double s8_95 = work.s2_90*work.s8_79 - work.s2_86 - work.zdd_star_rear_axle_tz;
  const double s8_96 = s8_95 - work.s2_87*work.s8_37 - work.s2_88*work.s8_41 + s6_17*work.s8_17;
  const double s8_97 = s8_96 - s6_18*work.s8_14 - work.s2_79*work.zdd_star_rear_axle_rz;
  work.s8_98 = s8_97 + work.s2_78*work.zdd_star_rear_axle_ry;
  work.s8_99 = 0.5*work.s8_79 + 3.95*work.s8_37;
  // arb_rear_right: arb_rear_right, revolute, chassis
  work.s8_100 = zd_arb_rear_right*work.s8_14;
  work.s8_101 = work.s7_46*work.s8_100;
  work.s8_102 = zd_arb_rear_right*work.s8_24;
  const double s8_103 = work.s7_48*work.s8_100 - work.s7_49*work.s8_102;
  work.s8_104 = work.s7_47*work.s8_102;
  work.s8_105 = work.s7_49*work.s8_18;
  work.s8_106 = 0.45*work.s8_34;
  work.s8_107 = 0.45*work.s8_41;
  const double s8_108 = s8_47 + work.s7_48*(s8_80 - work.s8_107);
  work.s8_109 = s8_108 + work.s7_49*(s8_55 - work.s8_106);
  // arb_rear_left: arb_rear_left, revolute, chassis
  work.s8_110 = zd_arb_rear_left*work.s8_14;
  work.s8_111 = work.s7_38*work.s8_110;
  work.s8_112 = zd_arb_rear_left*work.s8_24;
  work.s8_113 = s8_103 + work.s7_40*work.s8_110 - work.s7_41*work.s8_112;
  work.s8_114 = work.s7_39*work.s8_112;
  work.s8_115 = work.s7_41*work.s8_19;
  const double s8_116 = work.s7_48 - 14.850000000000001;
  const double s8_117 = work.s7_40 - 14.850000000000001;
  const double s8_118 = s8_116 + s8_117;
  work.s8_119 = work.s7_38 + work.s7_46 - 6.6000000000000005*s8_118;
  const double s8_120 = 2.025 + work.s7_49;
  const double s8_121 = 2.025 + work.s7_41;
  const double s8_122 = s8_120 + s8_121;
  work.s8_123 = work.s7_42 + work.s7_50 + 0.8999999999999999*s8_122;
  work.s8_124 = work.s8_48 - work.s8_45 + 0.45*(s8_117 - s8_116);
  const double s8_125 = work.s7_39 + work.s7_47 - 0.44999999999999996*s8_118;
  work.s8_126 = s8_125 + 3.3000000000000003*s8_122;
  work.s8_127 = work.s8_35 - work.s8_36 + 0.45*(s8_120 - s8_121);
  work.s8_128 = work.s7_40 + work.s7_48 - 59.400000000000006;
  work.s8_129 = 8.1 + (work.s7_41 + work.s7_49);
  const double s8_130 = s8_50 + work.s7_40*(work.s8_107 + s8_80);
  work.s8_131 = s8_130 + work.s7_41*(work.s8_106 + s8_55);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s8_132 = work.w_rear_axle_x*work.w_rear_axle_z;
  const double s8_133 = work.w_rear_axle_y*work.w_rear_axle_z;
  const double s8_134 = work.zdd_star_rear_axle_rx + work.s4_29;
  const double s8_135 = work.w_rear_axle_x*work.w_rear_axle_y;
  const double s8_136 = s8_134 + s8_135;
  const double s8_137 = work.zdd_star_rear_axle_ry + work.s4_33;
  const double s8_138 = s8_132 - s8_137;
  const double s8_139 = s8_135 - s8_134;
  const double s8_140 = work.w_rear_axle_x*work.w_rear_axle_x;
  const double s8_141 = work.w_rear_axle_z*work.w_rear_axle_z;
  work.s8_142 = s8_140 + s8_141;
  const double s8_143 = work.zdd_star_rear_axle_rz + work.s4_32;
  const double s8_144 = s8_143 + s8_133;
  const double s8_145 = s8_137 + s8_132;
  const double s8_146 = work.w_rear_axle_y*work.w_rear_axle_y;
  work.s8_147 = s8_146 + s8_141;
  const double s8_148 = work.s8_4 + work.s7_28*s8_139 + work.s7_29*s8_145 - work.s7_26*s8_144;
  work.s8_149 = s8_148 - work.s7_22*s8_138 + work.s7_34*s8_57 - work.s7_31*s8_82;
  const double s8_150 = s8_133 - s8_143;
  const double s8_151 = work.s8_3 + work.s7_24*s8_144 + work.s7_26*s8_138 - work.s7_29*s8_150;
  work.s8_152 = s8_151 - work.s7_27*s8_136 + work.s7_33*s8_82 - work.s7_34*s8_78;
  const double s8_153 = work.s8_5 + work.s7_27*s8_150 + work.s7_22*s8_136 - work.s7_24*s8_139;
  work.s8_154 = s8_153 - work.s7_28*s8_145 + work.s7_31*s8_78 - work.s7_33*s8_57;
  work.s8_155 = s8_140 + s8_146;
  const double s8_156 = work.s7_33*s8_139 + work.s7_34*s8_145 - work.s7_31*work.s8_147;
  work.f_rear_axle_x = s8_156 + 1186.0*s8_57;
  const double s8_157 = work.s7_34*s8_150 + work.s7_31*s8_136 - work.s7_33*work.s8_142;
  work.f_rear_axle_y = s8_157 + 1186.0*s8_78;
  const double s8_158 = work.s7_33*s8_144 + work.s7_31*s8_138 - work.s7_34*work.s8_155;
  work.f_rear_axle_z = s8_158 + 1186.0*s8_82;
}

/// Part 3 of compute_accelerations: step 8: elimination from the leaves to the root (63),
/// long_rod_left .. arb_link_rear_right; step 9: accelerations from the root to the leaves (63),
/// (62); step 8: elimination from the leaves to the root (63), long_rod_left ..
/// arb_link_rear_right.
[[gnu::noinline]] void compute_accelerations_3(const State& state, const double* tau,
    AccelerationsWork& __restrict work, Accelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  work.s8_159 = work.s7_31 + 1186.0*work.r_rear_axle_aux1_x;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  work.s8_160 = work.s7_33 + 1186.0*z_rear_axle_ty;
  work.s8_161 = work.s7_34 + 1186.0*work.r_rear_axle_aux3_z;
  const double s8_162 = work.s8_6 + 1186.0*work.Rz_rear_axle_tx_0;
  const double s8_163 = work.s8_7 - 1186.0*work.s3_16;
  const double s8_164 = work.s8_8 - 1186.0*work.s3_2;
  const double s8_165 = work.s8_9 + 1186.0*work.Rz_rear_axle_tx_1;
  work.s8_166 = work.s8_10 - 1186.0*work.s3_63;
  const double s8_167 = 1186.0*work.Rz_rear_axle_tz_1 - work.Rz_rear_axle_ry_1*work.s7_31;
  const double s8_168 = s8_167 - work.s3_48*work.s7_33;
  const double s8_169 = work.f_rear_axle_y - tau[Coordinate::rear_axle_ty];
  const double s8_170 = tau[Coordinate::rear_axle_tx] - work.f_rear_axle_x;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double n_rear_axle_x = work.s8_152 + work.s7_28*(work.s8_142 - work.s8_155);
  const double s8_171 = n_rear_axle_x - work.s7_50*work.s8_102 - work.s7_47*work.s8_100;
  const double s8_172 = s8_171 - work.s8_35*work.s8_18 + work.s8_36*work.s8_19;
  const double s8_173 = s8_172 - work.s7_42*work.s8_112 - work.s7_39*work.s8_110;
  const double s8_174 = s8_173 + z_rear_axle_ty*work.f_rear_axle_z;
  const double s8_175 = s8_174 - work.r_rear_axle_aux3_z*work.f_rear_axle_y;
  const double n_rear_axle_y = work.s8_149 + work.s7_27*(work.s8_155 - work.s8_147);
  const double s8_176 = work.s5_53 - n_rear_axle_y;
  const double s8_177 = work.Rz_rear_axle_ry_0*s8_176;
  const double s8_178 = n_rear_axle_y + work.r_rear_axle_aux3_z*work.f_rear_axle_x;
  const double s8_179 = s8_178 - work.r_rear_axle_aux1_x*work.f_rear_axle_z;
  const double n_rear_axle_z = work.s8_154 + work.s7_26*(work.s8_147 - work.s8_142);
  work.s8_180 = work.s1_48*work.s5_45;
  const double s8_181 = tau[Coordinate::rear_axle_rz]*work.s8_180 - n_rear_axle_z;
  const double s8_182 = work.Rz_rear_axle_rx_0*s8_181;
  const double s8_183 = n_rear_axle_z + work.s8_104 + work.s8_101 - work.s8_45*work.s8_18;
  const double s8_184 = s8_183 + work.s8_48*work.s8_19 + work.s8_114 + work.s8_111;
  const double s8_185 = s8_184 + work.r_rear_axle_aux1_x*work.f_rear_axle_y;
  const double s8_186 = s8_185 - z_rear_axle_ty*work.f_rear_axle_x;
  const double s8_187 = work.s7_31 + 593.0*work.r_rear_axle_aux1_x;
  const double s8_188 = work.s7_33 + 593.0*z_rear_axle_ty;
  const double s8_189 = work.s7_34 + 593.0*work.r_rear_axle_aux3_z;
  // arb_link_rear_right
  const double s8_190 = work.s7_26 + work.r_rear_axle_aux1_x*s8_188 + z_rear_axle_ty*s8_187;
  const double s8_191 = work.s7_27 + work.r_rear_axle_aux1_x*s8_189;
  const double s8_192 = s8_191 + work.r_rear_axle_aux3_z*s8_187;
  const double s8_193 = work.s7_28 + z_rear_axle_ty*s8_189 + work.r_rear_axle_aux3_z*s8_188;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s8_194 = work.s7_22 + s8_187*(work.r_rear_axle_aux1_x + work.r_rear_axle_aux1_x);
  const double s8_195 = work.s7_24 + s8_188*(z_rear_axle_ty + z_rear_axle_ty);
  const double s8_196 = work.s7_29 + s8_189*(work.r_rear_axle_aux3_z + work.r_rear_axle_aux3_z);
  const double s8_197 = work.s7_35 - work.s7_22;
  const double s8_198 = work.Rz_rear_axle_rz_0*s8_197 - work.Rz_rear_axle_rx_0*work.s7_27;
  const double s8_199 = s8_198 - work.Rz_rear_axle_ry_0*work.s7_26 + work.s3_16*work.s7_34;
  const double s8_200 = s8_199 - work.s3_2*work.s7_33;
  const double s8_201 = work.s8_13 - work.s3_48*s8_197;
  const double s8_202 = work.s7_35 - work.s7_24;
  const double s8_203 = work.Rz_rear_axle_ry_0*s8_202 - work.Rz_rear_axle_rx_0*work.s7_28;
  const double s8_204 = s8_203 - work.Rz_rear_axle_rz_0*work.s7_26 + work.s3_2*work.s7_31;
  const double s8_205 = s8_204 + work.Rz_rear_axle_tx_0*work.s7_34;
  const double s8_206 = work.Rz_rear_axle_ry_1*s8_202 + work.s3_48*work.s7_26;
  const double s8_207 = s8_206 - work.Rz_rear_axle_rx_1*work.s7_28;
  const double s8_208 = s8_207 + work.Rz_rear_axle_tx_1*work.s7_34;
  const double s8_209 = s8_208 - work.Rz_rear_axle_tz_1*work.s7_31;
  const double s8_210 = work.s7_35 - work.s7_29;
  const double s8_211 = work.Rz_rear_axle_rx_0*s8_210 - work.Rz_rear_axle_rz_0*work.s7_27;
  const double s8_212 = s8_211 - work.Rz_rear_axle_ry_0*work.s7_28;
  const double s8_213 = s8_212 - work.Rz_rear_axle_tx_0*work.s7_33 - work.s3_16*work.s7_31;
  const double s8_214 = work.Rz_rear_axle_rx_1*s8_210 + work.s3_48*work.s7_27;
  const double s8_215 = s8_214 - work.Rz_rear_axle_ry_1*work.s7_28;
  const double s8_216 = s8_215 - work.Rz_rear_axle_tx_1*work.s7_33 - work.s3_63*work.s7_31;
  const double s8_217 = work.s7_43 + work.Rz_rear_axle_ry_0*s8_205;
  const double s8_218 = s8_217 + work.Rz_rear_axle_rx_0*s8_213 + work.Rz_rear_axle_rz_0*s8_200;
  const double s8_219 = s8_218 + work.Rz_rear_axle_tx_0*s8_162 - work.s3_2*s8_164;
  const double s8_220 = s8_219 - work.s3_16*s8_163;
  const double s8_221 = work.Rz_rear_axle_ry_0*s8_209 + work.Rz_rear_axle_rx_0*s8_216;
  const double s8_222 = s8_221 + work.Rz_rear_axle_rz_0*s8_201 + work.Rz_rear_axle_tx_0*s8_165;
  const double s8_223 = s8_222 - work.s3_2*s8_168 - work.s3_16*work.s8_166;
  const double s8_224 = work.s7_51 + work.Rz_rear_axle_ry_1*s8_209;
  const double s8_225 = s8_224 + work.Rz_rear_axle_rx_1*s8_216 - work.s3_48*s8_201;
  const double s8_226 = s8_225 + work.Rz_rear_axle_tz_1*s8_168 + work.Rz_rear_axle_tx_1*s8_165;
  const double s8_227 = s8_226 - work.s3_63*work.s8_166;
  work.s8_228 = s8_165 - work.s7_49;
  work.s8_229 = s8_168 - work.s7_48;
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  work.s8_230 = 0.5*work.s8_41;
  work.s8_231 = work.s8_230 + 0.4*work.s8_79 + 4.4*work.s8_37;
  // arb_link_rear_right
  // long_rod_left
  const double s8_232 = 3.0*work.s2_18;
  const double s8_233 = s8_194 - work.s2_18*s8_232;
  const double s8_234 = s8_190 + work.s2_19*s8_232;
  const double s8_235 = s8_192 - work.s2_20*s8_232;
  const double s8_236 = s8_232*work.s3_20;
  const double s8_237 = 3.0*work.s2_19;
  const double s8_238 = s8_195 - work.s2_19*s8_237;
  const double s8_239 = s8_193 + work.s2_20*s8_237;
  const double s8_240 = s8_237*work.s3_33;
  const double s8_241 = 3.0*work.s2_20;
  const double s8_242 = s8_196 - work.s2_20*s8_241;
  const double s8_243 = s8_241*work.s3_33;
  const double s8_244 = work.s6_72 - work.s2_16 + work.s6_3*work.s8_14 - work.s8_26 - work.s6_61;
  const double s8_245 = s8_244 + work.s2_12*work.zdd_star_rear_axle_rz - work.s2_19*work.s8_77;
  const double s8_246 = 3.0*work.s8_60;
  const double s8_247 = 3.0*(s8_245 - work.s2_20*work.s8_41 - work.s2_18*work.s8_34);
  const double s8_248 = s8_186 + work.s2_19*s8_246 + work.s2_18*s8_247;
  const double s8_249 = 3.0*work.s8_86;
  const double s8_250 = work.s8_109 - s8_247*work.s3_66 - s8_249*work.s3_52 - s8_246*work.s3_73;
  const double s8_251 = work.s8_131 - s8_247*work.s3_20 - s8_249*work.s3_5 - s8_246*work.s3_33;
  const double s8_252 = s8_175 - work.s2_20*s8_247 - work.s2_19*s8_249;
  const double s8_253 = s8_179 + work.s2_20*s8_246 - work.s2_18*s8_249;
  // arb_link_rear_right
  const double s8_254 = s8_220 - 3.0*work.s3_44 - 2.6666666666666665*work.s3_47;
  // diag_rod_left
  const double s8_255 = 2.6666666666666665*work.s2_37;
  const double s8_256 = s8_233 - work.s2_37*s8_255;
  const double s8_257 = s8_234 + work.s2_38*s8_255;
  const double s8_258 = s8_235 - work.s2_39*s8_255;
  const double s8_259 = s8_255*work.s3_22;
  const double s8_260 = 2.6666666666666665*work.s2_38;
  const double s8_261 = s8_238 - work.s2_38*s8_260;
  const double s8_262 = s8_239 + work.s2_39*s8_260;
  const double s8_263 = s8_260*work.s3_35;
  const double s8_264 = 2.6666666666666665*work.s2_39;
  const double s8_265 = s8_242 - work.s2_39*s8_264;
  const double s8_266 = s8_264*work.s3_35;
  const double s8_267 = work.s6_72 - work.s2_35 + work.s6_6*work.s8_14 - work.s8_27 - work.s6_63;
  const double s8_268 = s8_267 + work.s2_31*work.zdd_star_rear_axle_rz - work.s2_38*work.s8_77;
  const double s8_269 = 2.6666666666666665*work.s8_63;
  const double s8_270 = s8_268 - work.s2_39*work.s8_41 - work.s2_37*work.s8_34;
  const double s8_271 = 2.6666666666666665*s8_270;
  const double s8_272 = s8_248 + work.s2_38*s8_269 + work.s2_37*s8_271;
  const double s8_273 = 2.6666666666666665*work.s8_90;
  const double s8_274 = s8_250 - s8_271*work.s3_67 - s8_273*work.s3_54 - s8_269*work.s3_75;
  const double s8_275 = s8_251 - s8_271*work.s3_22 - s8_273*work.s3_7 - s8_269*work.s3_35;
  const double s8_276 = s8_252 - work.s2_39*s8_271 - work.s2_38*s8_273;
  const double s8_277 = s8_253 + work.s2_39*s8_269 - work.s2_37*s8_273;
  // arb_link_rear_left
  const double s8_278 = 0.3333333333333333*work.s2_58;
  const double s8_279 = s8_256 - work.s2_58*s8_278;
  const double s8_280 = s8_257 - work.s2_59*s8_278;
  const double s8_281 = s8_258 + work.s2_62*s8_278;
  const double s8_282 = 0.3333333333333333*work.s2_59;
  const double s8_283 = s8_261 - work.s2_59*s8_282;
  const double s8_284 = s8_262 + work.s2_62*s8_282;
  const double s8_285 = 0.3333333333333333*work.s2_62;
  const double s8_286 = s8_265 - work.s2_62*s8_285;
  const double s8_287 = work.s6_72 - work.s2_55 + work.s2_58*work.s8_34 - work.s2_62*work.s8_41;
  const double s8_288 = s8_287 - work.s2_59*work.s8_77 + work.s6_13*work.s8_14 - work.s8_28;
  const double s8_289 = work.s6_9 - work.zdd_star_rear_axle_tz + work.s2_59*work.s8_41;
  const double s8_290 = s8_289 + work.s2_62*work.s8_79 + work.s2_58*work.s8_37;
  const double s8_291 = s8_290 - work.s2_49*work.zdd_star_rear_axle_rz;
  const double s8_292 = s8_291 + work.s2_47*work.zdd_star_rear_axle_ry + work.s6_12*work.s8_17;
  const double s8_293 = 0.3333333333333333*work.s8_65;
  const double s8_294 = s8_288 - work.s6_65 + work.s2_52*work.zdd_star_rear_axle_rz;
  const double s8_295 = 0.3333333333333333*s8_294;
  const double s8_296 = s8_272 + work.s2_59*s8_293 - work.s2_58*s8_295;
  const double s8_297 = 0.3333333333333333*(s8_292 - work.s6_7*work.s8_14);
  const double s8_298 = s8_274 - s8_295*work.s3_68 - s8_297*work.s3_56 - s8_293*work.s3_77;
  const double s8_299 = s8_276 - work.s2_62*s8_295 - work.s2_59*s8_297;
  const double s8_300 = s8_277 + work.s2_58*s8_297 + work.s2_62*s8_293;
  const double s8_301 = work.s2_60 + work.Rz_rear_axle_tx_0 + work.s2_52*work.Rz_rear_axle_ry_0;
  const double s8_302 = s8_301 - work.s2_49*work.Rz_rear_axle_rx_0;
  const double s8_303 = s8_285*s8_302;
  const double s8_304 = work.s2_57 - work.s3_2 + work.s2_49*work.Rz_rear_axle_rz_0;
  const double s8_305 = s8_304 - work.s2_47*work.Rz_rear_axle_ry_0;
  const double s8_306 = work.s3_24*work.s3_24 + s8_305*s8_305 + s8_302*s8_302;
  const double s8_307 = s8_306 + work.s3_30*work.s3_30 + work.s3_13*work.s3_13;
  const double s8_308 = s8_254 - 0.3333333333333333*(s8_307 + work.s3_41*work.s3_41);
  const double s8_309 = work.s3_24*work.s3_68 + s8_305*work.s3_56 + s8_302*work.s3_77;
  const double s8_310 = s8_282*s8_305;
  const double s8_311 = s8_278*s8_305;
  const double s8_312 = s8_275 - s8_295*work.s3_24 - s8_297*s8_305 - s8_293*s8_302;
  // long_rod_right
  const double s8_313 = 3.0*work.s2_74;
  const double s8_314 = s8_279 - work.s2_74*s8_313;
  const double s8_315 = s8_280 - work.s2_75*s8_313;
  const double s8_316 = s8_281 - work.s2_76*s8_313;
  const double s8_317 = s8_313*work.s3_26;
  const double s8_318 = 3.0*work.s2_75;
  const double s8_319 = s8_283 - work.s2_75*s8_318;
  const double s8_320 = s8_284 - work.s2_76*s8_318;
  const double s8_321 = s8_318*work.s3_37;
  const double s8_322 = 3.0*work.s2_76;
  const double s8_323 = s8_286 - work.s2_76*s8_322;
  const double s8_324 = s8_322*work.s3_37;
  const double s8_325 = work.s2_72 + work.s6_72 + work.s2_75*work.s8_77 - work.s2_76*work.s8_41;
  const double s8_326 = s8_325 - work.s2_74*work.s8_34 - work.s2_68*work.zdd_star_rear_axle_rz;
  const double s8_327 = 3.0*work.s8_68;
  const double s8_328 = 3.0*(s8_326 - work.s6_67 + work.s6_16*work.s8_14 - work.s8_29);
  const double s8_329 = s8_296 + work.s2_74*s8_328 - work.s2_75*s8_327;
  const double s8_330 = 3.0*work.s8_94;
  const double s8_331 = s8_298 - s8_328*work.s3_69 - s8_330*work.s3_58 - s8_327*work.s3_79;
  const double s8_332 = s8_312 - s8_328*work.s3_26 - s8_330*work.s3_9 - s8_327*work.s3_37;
  const double s8_333 = s8_299 + work.s2_75*s8_330 - work.s2_76*s8_328;
  const double s8_334 = s8_300 + work.s2_76*s8_327 - work.s2_74*s8_330;
  // diag_rod_right
  const double s8_335 = 2.6666666666666665*work.s2_87;
  const double s8_336 = s8_314 - work.s2_87*s8_335;
  const double s8_337 = s8_315 - work.s2_88*s8_335;
  const double s8_338 = s8_316 - work.s2_90*s8_335;
  const double s8_339 = s8_335*work.s3_28;
  const double s8_340 = 2.6666666666666665*work.s2_88;
  const double s8_341 = s8_319 - work.s2_88*s8_340;
  const double s8_342 = s8_320 - work.s2_90*s8_340;
  const double s8_343 = s8_340*work.s3_39;
  const double s8_344 = 2.6666666666666665*work.s2_90;
  const double s8_345 = s8_323 - work.s2_90*s8_344;
  const double s8_346 = s8_344*work.s3_39;
  const double s8_347 = work.s6_72 - work.s2_85 + work.s2_88*work.s8_77 - work.s2_90*work.s8_41;
  const double s8_348 = s8_347 - work.s2_87*work.s8_34 + work.s6_19*work.s8_14 - work.s8_30;
  const double s8_349 = 2.6666666666666665*work.s8_71;
  const double s8_350 = s8_348 - work.s6_69 + work.s2_81*work.zdd_star_rear_axle_rz;
  const double s8_351 = 2.6666666666666665*s8_350;
  const double s8_352 = s8_329 + work.s2_87*s8_351 - work.s2_88*s8_349;
  const double s8_353 = 2.6666666666666665*work.s8_98;
  const double s8_354 = s8_331 - s8_351*work.s3_70 - s8_353*work.s3_60 - s8_349*work.s3_81;
  const double s8_355 = s8_332 - s8_351*work.s3_28 - s8_353*work.s3_11 - s8_349*work.s3_39;
  const double s8_356 = s8_333 + work.s2_88*s8_353 - work.s2_90*s8_351;
  const double s8_357 = s8_334 + work.s2_90*s8_349 - work.s2_87*s8_353;
  // arb_link_rear_right
  const double s8_358 = 0.3333333333333333*work.s2_104;
  work.s8_359 = s8_336 - work.s2_104*s8_358;
  work.s8_360 = s8_337 + work.s2_105*s8_358;
  work.s8_361 = s8_338 + work.s2_108*s8_358;
  const double s8_362 = 0.3333333333333333*work.s2_105;
  work.s8_363 = s8_341 - work.s2_105*s8_362;
  work.s8_364 = s8_342 - work.s2_108*s8_362;
  const double s8_365 = 0.3333333333333333*work.s2_108;
  work.s8_366 = s8_345 - work.s2_108*s8_365;
  const double s8_367 = work.s6_72 - work.s2_100 + work.s2_105*work.s8_77;
  const double s8_368 = s8_367 + work.s2_104*work.s8_34 - work.s2_108*work.s8_41;
  const double s8_369 = s8_368 + work.s2_97*work.zdd_star_rear_axle_rz + work.s6_71;
  const double s8_370 = work.s6_40 - work.zdd_star_rear_axle_tz + work.s2_108*work.s8_79;
  const double s8_371 = s8_370 + work.s2_104*work.s8_37 - work.s2_105*work.s8_41;
  const double s8_372 = s8_371 - work.s2_94*work.zdd_star_rear_axle_ry;
  const double s8_373 = s8_372 + work.s2_95*work.zdd_star_rear_axle_rz + work.s6_44*work.s8_17;
  const double s8_374 = 0.3333333333333333*work.s8_72;
  const double s8_375 = 0.3333333333333333*(s8_369 + work.s6_45*work.s8_14 - work.s8_32);
  const double s8_376 = s8_352 - work.s2_105*s8_374 - work.s2_104*s8_375;
  const double s8_377 = 0.3333333333333333*(s8_373 - work.s6_38*work.s8_14);
  const double s8_378 = s8_355 - s8_377*work.s3_13 - s8_374*work.s3_41 + s8_375*work.s3_30;
  const double s8_379 = s8_356 + work.s2_105*s8_377 - work.s2_108*s8_375;
  const double s8_380 = s8_357 + work.s2_104*s8_377 + work.s2_108*s8_374;
  const double s8_381 = work.s2_106 + work.Rz_rear_axle_tx_1 + work.s2_95*work.Rz_rear_axle_rx_1;
  const double s8_382 = s8_381 + work.s2_97*work.Rz_rear_axle_ry_1;
  const double s8_383 = work.s2_103 + work.Rz_rear_axle_tz_1 + work.s2_94*work.Rz_rear_axle_ry_1;
  const double s8_384 = s8_383 + work.s2_95*work.s3_48;
  const double s8_385 = s8_309 + work.s3_13*s8_384 + work.s3_41*s8_382 - work.s3_30*work.s3_71;
  const double s8_386 = s8_223 - 3.0*work.s3_84 - 2.6666666666666665*work.s3_87;
  work.s8_387 = s8_386 - 0.3333333333333333*s8_385;
  const double s8_388 = 0.3333333333333333*(work.s3_95 + s8_384*s8_384 + s8_382*s8_382);
  const double s8_389 = s8_227 - 3.0*work.s3_90 - 2.6666666666666665*work.s3_93 - s8_388;
  const double s8_390 = work.s8_45 + s8_201 + 0.45*work.s7_48 + z_rear_axle_ty*s8_168;
  const double s8_391 = s8_390 - work.r_rear_axle_aux3_z*work.s8_166 + s8_241*work.s3_66;
  const double s8_392 = s8_391 + s8_237*work.s3_52 + s8_264*work.s3_67 + s8_260*work.s3_54;
  const double s8_393 = s8_392 + s8_285*work.s3_68 + s8_282*work.s3_56 + s8_322*work.s3_69;
  const double s8_394 = s8_393 - s8_318*work.s3_58 + s8_344*work.s3_70 - s8_340*work.s3_60;
  work.s8_395 = s8_394 + s8_365*work.s3_71 - s8_362*s8_384;
  const double s8_396 = work.s7_51 + s8_209 + 0.44999999999999996*work.s7_49;
  const double s8_397 = s8_396 - 3.3000000000000003*work.s7_48 + work.r_rear_axle_aux3_z*s8_165;
  const double s8_398 = s8_397 - work.r_rear_axle_aux1_x*s8_168 + s8_232*work.s3_52;
  const double s8_399 = s8_398 - s8_241*work.s3_73 + s8_255*work.s3_54 - s8_264*work.s3_75;
  const double s8_400 = s8_399 - s8_278*work.s3_56 - s8_285*work.s3_77 + s8_313*work.s3_58;
  const double s8_401 = s8_400 - s8_322*work.s3_79 + s8_335*work.s3_60 - s8_344*work.s3_81;
  work.s8_402 = s8_401 - s8_358*s8_384 - s8_365*s8_382;
  const double s8_403 = s8_216 - work.s8_35 + work.r_rear_axle_aux1_x*work.s8_166;
  const double s8_404 = s8_403 - z_rear_axle_ty*s8_165 - 0.45*work.s7_49 - s8_237*work.s3_73;
  const double s8_405 = s8_404 - s8_232*work.s3_66 - s8_260*work.s3_75 - s8_255*work.s3_67;
  const double s8_406 = s8_405 + s8_278*work.s3_68 - s8_282*work.s3_77 + s8_318*work.s3_79;
  const double s8_407 = s8_406 - s8_313*work.s3_69 + s8_340*work.s3_81 - s8_335*work.s3_70;
  work.s8_408 = s8_407 + s8_362*s8_382 + s8_358*work.s3_71;
  const double tau_rear_axle_tz = tau[Coordinate::rear_axle_tz];
  const double s8_409 = work.Rz_rear_axle_tz_1*(tau_rear_axle_tz - work.f_rear_axle_z);
  const double s8_410 = s8_354 - s8_375*work.s3_71 - s8_377*s8_384 - s8_374*s8_382 + s8_409;
  const double s8_411 = s8_410 + work.s3_48*(n_rear_axle_x - work.s5_50);
  const double s8_412 = s8_411 + work.Rz_rear_axle_ry_1*s8_176 + work.Rz_rear_axle_rx_1*s8_181;
  work.s8_413 = work.s8_54 - work.s8_79;
  const double s8_414 = s8_412 + work.s3_63*s8_169 + work.Rz_rear_axle_tx_1*s8_170;
  const double s8_415 = work.s7_39*work.s8_413;
  work.s8_416 = s8_414 + work.s7_47*work.s8_413 + work.s8_37*(work.s7_46 - work.s7_50);
  result.inertia[12] = s8_389 - 1e-12*s8_389;

  // --- step 9: accelerations from the root to the leaves (63), (62) ---
  // chassis: chassis_rx, revolute, chassis_aux5
  work.s9_1 = work.s1_3*work.s1_3 - 1e-12;

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  work.s8_417 = 1.0/s8_389;
  const double s8_418 = work.s8_387*work.s8_417;
  const double s8_419 = s8_308 - work.s8_387*s8_418;
  work.s8_420 = s8_163 - work.s8_166*s8_418;
  result.inertia[11] = s8_419 - 1e-12*s8_308;
  work.s8_421 = s8_162 - work.s7_41 - work.s8_228*s8_418;
  work.s8_422 = s8_164 - work.s7_40 - work.s8_229*s8_418;
  const double s8_423 = s8_200 - work.s8_48 + z_rear_axle_ty*s8_164;
  const double s8_424 = s8_423 - work.r_rear_axle_aux3_z*s8_163 - 0.45*work.s7_40;
  const double s8_425 = s8_424 + s8_241*work.s3_20 + s8_237*work.s3_5 + s8_264*work.s3_22;
  const double s8_426 = s8_425 + s8_260*work.s3_7 + s8_285*work.s3_24 + s8_310;
  const double s8_427 = s8_426 + s8_322*work.s3_26 - s8_318*work.s3_9 + s8_344*work.s3_28;
  const double s8_428 = s8_427 - s8_340*work.s3_11 - s8_365*work.s3_30 - s8_362*work.s3_13;
  work.s8_429 = s8_428 - work.s8_395*s8_418;
  const double s8_430 = work.s7_43 + s8_205 + 0.44999999999999996*work.s7_41;
  const double s8_431 = s8_430 - 3.3000000000000003*work.s7_40 + work.r_rear_axle_aux3_z*s8_162;
  const double s8_432 = s8_431 - work.r_rear_axle_aux1_x*s8_164 + s8_232*work.s3_5 - s8_243;
  const double s8_433 = s8_432 + s8_255*work.s3_7 - s8_266 - s8_311 - s8_303 + s8_313*work.s3_9;
  const double s8_434 = s8_433 - s8_324 + s8_335*work.s3_11 - s8_346 - s8_358*work.s3_13;
  work.s8_435 = s8_434 - s8_365*work.s3_41 - work.s8_402*s8_418;
  const double s8_436 = work.s8_36 + s8_213 + 0.45*work.s7_41 + work.r_rear_axle_aux1_x*s8_163;
  const double s8_437 = s8_436 - z_rear_axle_ty*s8_162 - s8_240 - s8_236 - s8_263 - s8_259;
  const double s8_438 = s8_437 + s8_278*work.s3_24 - s8_282*s8_302 + s8_321 - s8_317 + s8_343;
  const double s8_439 = s8_438 - s8_339 + s8_362*work.s3_41 - s8_358*work.s3_30;
  work.s8_440 = s8_439 - work.s8_408*s8_418;
  const double s8_441 = work.s3_2*(work.f_rear_axle_z - tau_rear_axle_tz);
  const double s8_442 = work.Rz_rear_axle_rz_0*(work.s5_50 - n_rear_axle_x);
  const double s8_443 = s8_378 - work.s8_416*s8_418 + s8_441 + s8_442 + s8_177 + s8_182;
  const double s8_444 = s8_443 + work.s3_16*s8_169 + work.Rz_rear_axle_tx_0*s8_170 + s8_415;
  work.s8_445 = s8_444 + work.s8_37*(work.s7_38 - work.s7_42);
  work.s8_446 = 1.0/s8_419;
  const double s8_447 = work.s8_421*work.s8_446;
  const double s8_448 = work.s8_420*work.s8_446;
  const double s8_449 = work.s8_422*work.s8_446;
  const double s8_450 = work.s8_429*work.s8_446;
  const double s8_451 = work.s8_435*work.s8_446;
  const double s8_452 = work.s8_440*work.s8_446;
  const double s8_453 = work.s8_228*work.s8_417;
  work.s8_454 = work.s8_421*s8_447 + work.s8_228*s8_453;
  work.s8_455 = work.s8_420*s8_447 + work.s8_166*s8_453;
  work.s8_456 = work.s8_422*s8_447 + work.s8_229*s8_453;
  work.s8_457 = work.s8_429*s8_447 + work.s8_395*s8_453;
  work.s8_458 = work.s8_435*s8_447 + work.s8_402*s8_453;
  work.s8_459 = work.s8_440*s8_447 + work.s8_408*s8_453;
  const double s8_460 = work.s8_166*work.s8_417;
  work.s8_461 = work.s8_420*s8_448 + work.s8_166*s8_460;
  work.s8_462 = work.s8_422*s8_448 + work.s8_229*s8_460;
  work.s8_463 = work.s8_429*s8_448 + work.s8_395*s8_460;
  work.s8_464 = work.s8_435*s8_448 + work.s8_402*s8_460;
  work.s8_465 = work.s8_440*s8_448 + work.s8_408*s8_460;
  const double s8_466 = work.s8_229*work.s8_417;
  work.s8_467 = work.s8_422*s8_449 + work.s8_229*s8_466;
  work.s8_468 = work.s8_429*s8_449 + work.s8_395*s8_466;
  work.s8_469 = work.s8_435*s8_449 + work.s8_402*s8_466;
  work.s8_470 = work.s8_440*s8_449 + work.s8_408*s8_466;
  const double s8_471 = work.s8_395*work.s8_417;
  work.s8_472 = work.s8_429*s8_450 + work.s8_395*s8_471;
  work.s8_473 = work.s8_435*s8_450 + work.s8_402*s8_471;
  work.s8_474 = work.s8_440*s8_450 + work.s8_408*s8_471;
  const double s8_475 = s8_379 + work.s8_445*s8_450 + work.s8_416*s8_471;
  const double s8_476 = work.s8_402*work.s8_417;
  work.s8_477 = work.s8_435*s8_451 + work.s8_402*s8_476;
  work.s8_478 = work.s8_440*s8_451 + work.s8_408*s8_476;
  const double s8_479 = work.s8_408*work.s8_417;
  work.s8_480 = work.s8_440*s8_452 + work.s8_408*s8_479;
  const double s8_481 = s8_376 + work.s8_445*s8_452 + work.s8_416*s8_479;
  const double s8_482 = work.s7_48*work.s8_18;
  const double s8_483 = work.s7_40*work.s8_19;
  const double s8_484 = work.f_rear_axle_x - s8_482 - s8_483 + work.s8_445*s8_447;
  work.s8_485 = s8_484 + work.s8_416*s8_453;
  const double s8_486 = work.f_rear_axle_y + work.s8_113 + work.s8_445*s8_448;
  work.s8_487 = s8_486 + work.s8_416*s8_460;
  const double s8_488 = work.s8_105 + work.s8_115;
  work.s8_489 = work.f_rear_axle_z + s8_488 + work.s8_445*s8_449 + work.s8_416*s8_466;
  const double s8_490 = s8_475 + 0.44999999999999996*work.s8_113;
  work.s8_491 = s8_490 + 0.45*(work.s8_115 - work.s8_105);
  const double s8_492 = s8_380 + work.s8_445*s8_451 + work.s8_416*s8_476;
  const double s8_493 = s8_492 + 0.44999999999999996*(s8_482 + s8_483);
  work.s8_494 = s8_493 + 3.3000000000000003*s8_488;
  work.s8_495 = s8_481 - 3.3000000000000003*work.s8_113 + 0.45*(s8_483 - s8_482);
  // operations: 685 add, 701 multiply, 2 divide
}

/// Part 4 of compute_accelerations: step 8: elimination from the leaves to the root (63); step 2:
/// closure Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right; step 6: c and
/// dRz/dt zd (62), upper_ball_left .. tie_rod_right; step 2: closure Jacobian Phi_z and its factors
/// (60), upper_ball_left .. tie_rod_right; step 6: c and dRz/dt zd (62), upper_ball_left ..
/// tie_rod_right; step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left ..
/// tie_rod_right; step 3: Rz (61), upper_ball_left .. tie_rod_right; step 6: c and dRz/dt zd (62),
/// upper_ball_left .. tie_rod_right; step 7: inertias of the bodies and forces on joints,
/// upper_ball_left .. tie_rod_right.
[[gnu::noinline]] void compute_accelerations_4(const State& state, const double* tau,
    AccelerationsWork& __restrict work) noexcept {
  // --- step 8: elimination from the leaves to the root (63), continued ---
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s8_496 = 11.0*work.s4_65;
  const double tau_wheel_front_right = tau[Coordinate::wheel_front_right];
  work.s8_497 = work.s4_67*s8_496 - work.s1_39*tau_wheel_front_right;
  work.s8_498 = work.R_carrier_right_aux2_y_y*tau_wheel_front_right - work.s4_69*s8_496;
  work.s8_499 = work.s4_62*s8_496 + work.R_carrier_right_aux2_z_y*tau_wheel_front_right;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s8_500 = 11.0*work.s4_55;
  const double tau_wheel_front_left = tau[Coordinate::wheel_front_left];
  work.s8_501 = work.s4_57*s8_500 - work.s1_19*tau_wheel_front_left;
  work.s8_502 = work.R_carrier_left_aux2_y_y*tau_wheel_front_left - work.s4_59*s8_500;
  work.s8_503 = work.s4_52*s8_500 + work.R_carrier_left_aux2_z_y*tau_wheel_front_left;

  // --- step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right ---
  // upper_ball_left
  const double s2_168 = 0.04999999999999993*work.s1_19;
  const double s2_169 = s2_168 + 0.36999999999999994*work.R_carrier_left_x_z;
  const double s2_170 = 0.04999999999999993*work.R_carrier_left_aux2_y_y;
  const double s2_171 = 0.36999999999999994*work.R_carrier_left_y_z - s2_170;
  const double s2_172 = work.s4_39*s2_171 - work.s4_8*s2_169;
  const double s2_173 = work.s4_39*s2_172;
  const double s2_174 = 0.04999999999999993*work.R_carrier_left_aux2_z_y;
  const double s2_175 = 0.36999999999999994*work.R_carrier_left_z_z - s2_174;
  const double s2_176 = work.s4_8*s2_175 - work.s4_10*s2_171;
  const double s2_177 = work.s4_10*s2_169 - work.s4_39*s2_175;
  const double s2_178 = work.s4_8*s2_172 - work.s4_10*s2_177;
  const double s2_179 = work.s4_39*s2_177;
  const double s2_180 = work.s4_10*s2_176;
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double R_upper_arm_left_z_y = work.sines[7];
  const double s2_181 = 0.020000000000000018*R_upper_arm_left_z_y;
  const double s2_182 = 0.30000000000000004*R_upper_arm_left_y_y + s2_181;
  const double s2_183 = 0.020000000000000018*R_upper_arm_left_y_y;
  const double s2_184 = 0.30000000000000004*R_upper_arm_left_z_y - s2_183;
  // upper_ball_right
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double R_upper_arm_right_z_y = work.sines[13];
  const double s2_185 = 0.020000000000000018*R_upper_arm_right_z_y;
  const double s2_186 = s2_185 - 0.30000000000000004*R_upper_arm_right_y_y;
  const double s2_187 = 0.020000000000000018*R_upper_arm_right_y_y;
  const double s2_188 = 0.30000000000000004*R_upper_arm_right_z_y + s2_187;
  const double s2_189 = 0.04999999999999993*work.s1_39;
  const double s2_190 = 0.36999999999999994*work.R_carrier_right_x_z - s2_189;
  const double s2_191 = 0.04999999999999993*work.R_carrier_right_aux2_y_y;
  const double s2_192 = s2_191 + 0.36999999999999994*work.R_carrier_right_y_z;
  const double s2_193 = work.s4_47*s2_192 - work.s4_19*s2_190;
  const double s2_194 = work.s4_47*s2_193;
  const double s2_195 = 0.04999999999999993*work.R_carrier_right_aux2_z_y;
  const double s2_196 = s2_195 + 0.36999999999999994*work.R_carrier_right_z_z;
  const double s2_197 = work.s4_19*s2_196 - work.s4_21*s2_192;
  const double s2_198 = work.s4_21*s2_190 - work.s4_47*s2_196;
  const double s2_199 = work.s4_19*s2_193 - work.s4_21*s2_198;
  const double s2_200 = work.s4_47*s2_198;
  const double s2_201 = work.s4_19*s2_197;
  // arb_link_front_left
  const double s2_202 = 0.02999999999999997*work.R_carrier_left_x_z;
  work.s2_203 = 0.030000000000000027*work.s1_19 + s2_202 + 0.1*work.R_carrier_left_x_x;
  const double s2_204 = 0.02999999999999997*work.R_carrier_left_y_z;
  const double s2_205 = 0.030000000000000027*work.R_carrier_left_aux2_y_y;
  work.s2_206 = s2_204 + 0.1*work.R_carrier_left_y_x - s2_205;
  const double s2_207 = 0.02999999999999997*work.R_carrier_left_z_z;
  const double s2_208 = 0.030000000000000027*work.R_carrier_left_aux2_z_y;
  work.s2_209 = s2_207 + 0.1*work.R_carrier_left_z_x - s2_208;
  // arb_link_front_right
  const double s2_210 = 0.02999999999999997*work.R_carrier_right_x_z;
  work.s2_211 = s2_210 + 0.1*work.R_carrier_right_x_x - 0.030000000000000027*work.s1_39;
  const double s2_212 = 0.030000000000000027*work.R_carrier_right_aux2_y_y;
  const double s2_213 = s2_212 + 0.02999999999999997*work.R_carrier_right_y_z;
  work.s2_214 = s2_213 + 0.1*work.R_carrier_right_y_x;
  const double s2_215 = 0.030000000000000027*work.R_carrier_right_aux2_z_y;
  const double s2_216 = s2_215 + 0.02999999999999997*work.R_carrier_right_z_z;
  work.s2_217 = s2_216 + 0.1*work.R_carrier_right_z_x;

  // --- step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right ---
  // arb_link_front_left
  const double s6_76 = work.s4_8*work.s2_209 - work.s4_10*work.s2_206;
  const double s6_77 = work.s4_10*work.s2_203 - work.s4_39*work.s2_209;
  const double s6_78 = work.s4_39*work.s2_206 - work.s4_8*work.s2_203;
  // arb_link_front_right
  const double s6_79 = work.s4_19*work.s2_217 - work.s4_21*work.s2_214;
  const double s6_80 = work.s4_21*work.s2_211 - work.s4_47*work.s2_217;
  const double s6_81 = work.s4_47*work.s2_214 - work.s4_19*work.s2_211;

  // --- step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right,
  // continued ---
  // arb_link_front_left
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s2_218 = 0.09999999999999998*R_arb_front_left_x_z;
  work.s2_219 = s2_218 - 0.24999999999999997*R_arb_front_left_x_x;
  const double s2_220 = 0.09999999999999998*R_arb_front_left_x_x;
  const double s2_221 = s2_220 + 0.24999999999999997*R_arb_front_left_x_z;
  // arb_link_front_right
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s2_222 = 0.09999999999999998*R_arb_front_right_x_z;
  work.s2_223 = s2_222 - 0.24999999999999997*R_arb_front_right_x_x;
  const double s2_224 = 0.09999999999999998*R_arb_front_right_x_x;
  const double s2_225 = s2_224 + 0.24999999999999997*R_arb_front_right_x_z;
  // arb_link_front_left
  work.s2_226 = 0.3500000000000001 + (work.s2_219 - work.s2_203);
  work.r_carrier_left_aux1_y = 0.4 + work.s1_8;
  work.s2_227 = 0.72 - work.r_carrier_left_aux1_y - work.s2_206;
  const double s2_228 = work.s2_203*work.s2_227 - work.s2_206*work.s2_226;
  work.r_carrier_left_aux1_z = work.s1_10 - 0.62;
  work.s2_229 = s2_221 - work.r_carrier_left_aux1_z - work.s2_209 - 0.5;
  const double s2_230 = s2_221*work.s2_226 - work.s2_219*work.s2_229;
  const double s2_231 = work.s2_206*work.s2_229 - work.s2_209*work.s2_227;
  const double s2_232 = work.s2_209*work.s2_226 - work.s2_203*work.s2_229;
  const double s2_233 = s2_231 + work.s1_8*work.s2_229 - work.s1_10*work.s2_227;
  // arb_link_front_right
  work.s2_234 = 0.3500000000000001 + (work.s2_223 - work.s2_211);
  work.r_carrier_right_aux1_y = work.s1_28 - 0.4;
  work.s2_235 = 0.72 + (work.r_carrier_right_aux1_y + work.s2_214);
  const double s2_236 = work.s2_214*work.s2_234 + work.s2_211*work.s2_235;
  work.s2_237 = 0.62 + work.s1_30;
  work.s2_238 = work.s2_237 + s2_225 - work.s2_217 - 0.5;
  const double s2_239 = s2_225*work.s2_234 - work.s2_223*work.s2_238;
  const double s2_240 = work.s2_217*work.s2_235 + work.s2_214*work.s2_238;
  const double s2_241 = work.s2_217*work.s2_234 - work.s2_211*work.s2_238;
  const double s2_242 = s2_240 + work.s1_28*work.s2_238 - work.s1_30*work.s2_235;
  // drag_link
  const double R_bell_crank_y_x = work.sines[16];
  work.s2_243 = 0.3*R_bell_crank_y_x;
  work.s2_244 = 0.21999999999999997*work.sines[15];
  work.s2_245 = 1.1500000000000004 + (work.s2_243 - work.s2_244);
  const double R_bell_crank_x_x = work.cosines[16];
  const double s2_246 = 0.3*R_bell_crank_x_x;
  work.s2_247 = 0.5 - s2_246;
  const double s2_248 = s2_246*work.s2_245 + work.s2_243*work.s2_247;
  const double s2_249 = 0.21999999999999997*work.cosines[15];
  work.s2_250 = 0.19999999999999996 - s2_249;
  const double s2_251 = work.s2_244*work.s2_250 - s2_249*work.s2_245;
  // tie_rod_left
  // tie_rod_right
  // tie_rod_left
  work.s2_252 = s2_168 + 0.07*work.R_carrier_left_x_z - 0.22*work.R_carrier_left_x_x;
  work.s2_253 = 0.07*work.R_carrier_left_y_z - s2_170 - 0.22*work.R_carrier_left_y_x;
  work.s2_254 = 0.07*work.R_carrier_left_z_z - s2_174 - 0.22*work.R_carrier_left_z_x;
  // tie_rod_right
  work.s2_255 = 0.07*work.R_carrier_right_x_z - s2_189 - 0.22*work.R_carrier_right_x_x;
  work.s2_256 = s2_191 + 0.07*work.R_carrier_right_y_z - 0.22*work.R_carrier_right_y_x;
  work.s2_257 = s2_195 + 0.07*work.R_carrier_right_z_z - 0.22*work.R_carrier_right_z_x;

  // --- step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right, continued ---
  // tie_rod_left
  const double s6_82 = work.s4_8*work.s2_254 - work.s4_10*work.s2_253;
  const double s6_83 = work.s4_10*work.s2_252 - work.s4_39*work.s2_254;
  const double s6_84 = work.s4_39*work.s2_253 - work.s4_8*work.s2_252;
  const double s6_85 = work.s4_10*s6_82;
  const double s6_86 = work.s4_39*s6_84;
  // tie_rod_right
  const double s6_87 = work.s4_19*work.s2_257 - work.s4_21*work.s2_256;
  const double s6_88 = work.s4_21*work.s2_255 - work.s4_47*work.s2_257;
  const double s6_89 = work.s4_47*work.s2_256 - work.s4_19*work.s2_255;

  // --- step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right,
  // continued ---
  // tie_rod_left
  const double s2_258 = 0.08*R_bell_crank_y_x;
  const double s2_259 = 0.20000000000000007*R_bell_crank_x_x;
  work.s2_260 = s2_258 + s2_259;
  work.s2_261 = 0.3500000000000001 + (work.s2_252 + work.s2_260);
  const double s2_262 = 0.08*R_bell_crank_x_x;
  const double s2_263 = 0.20000000000000007*R_bell_crank_y_x;
  const double s2_264 = s2_262 - s2_263;
  work.s2_265 = s2_264 - work.r_carrier_left_aux1_y - work.s2_253;
  const double s2_266 = work.s2_260*work.s2_265 - s2_264*work.s2_261;
  const double s2_267 = work.s2_252*work.s2_265 + work.s2_253*work.s2_261;
  work.s2_268 = 0.6 + (work.r_carrier_left_aux1_z + work.s2_254);
  const double s2_269 = work.s2_254*work.s2_265 + work.s2_253*work.s2_268;
  const double s2_270 = work.s2_252*work.s2_268 - work.s2_254*work.s2_261;
  const double s2_271 = s2_269 + work.s1_10*work.s2_265 + work.s1_8*work.s2_268;
  // tie_rod_right
  const double s2_272 = s2_258 - s2_259;
  const double s2_273 = s2_262 + s2_263;
  work.s2_274 = s2_272 - work.s2_255 - 0.3500000000000001;
  work.s2_275 = work.s2_256 + (work.r_carrier_right_aux1_y + s2_273);
  const double s2_276 = s2_273*work.s2_274 - s2_272*work.s2_275;
  const double s2_277 = work.s2_256*work.s2_274 + work.s2_255*work.s2_275;
  work.s2_278 = 0.6 + (work.s2_257 - work.s2_237);
  const double s2_279 = work.s2_257*work.s2_275 - work.s2_256*work.s2_278;
  const double s2_280 = work.s2_255*work.s2_278 + work.s2_257*work.s2_274;
  const double s2_281 = s2_279 - work.s1_30*work.s2_275 - work.s1_28*work.s2_278;
  const double s2_282 = 3.9625229801272064*std::abs(s2_251);
  const double s2_283 = mbgen::min(s2_282, 16.504892200367603*std::abs(s2_239));
  const double s2_284 = mbgen::min(s2_283, 16.679425973935604*std::abs(s2_230));
  const double s2_285 = 1.0/s2_196;
  const double s2_286 = s2_280*s2_285;
  const double s2_287 = s2_277 - s2_192*s2_286;
  const double s2_288 = s2_286*s2_199;
  const double s2_289 = mbgen::min(s2_284, 2.7028647671567816*std::abs(s2_196));
  const double s2_290 = 1.0/s2_287;
  const double s2_291 = s2_190*s2_290;
  const double s2_292 = s2_279*s2_291 - s2_196;
  const double s2_293 = work.s1_30 - s2_196 + s2_281*s2_291;
  const double s2_294 = mbgen::min(s2_289, 6.8514628664707224*std::abs(s2_287));
  const double s2_295 = s2_190*s2_285;
  const double s2_296 = s2_290*(s2_192*s2_295);
  const double s2_297 = 1.0/s2_292;
  const double s2_298 = s2_297*(s2_192 - s2_279*s2_296);
  const double s2_299 = s2_188*s2_298 - s2_186;
  const double s2_300 = s2_276*s2_291;
  const double s2_301 = s2_276*s2_296 + s2_300*s2_298;
  const double s2_302 = work.s1_28 + s2_192 - s2_281*s2_296 - s2_293*s2_298;
  const double s2_303 = mbgen::min(s2_294, 2.7028647671567816*std::abs(s2_292));
  const double s2_304 = mbgen::min(s2_303, 3.405476531191585*std::abs(s2_299));
  const double s2_305 = 1.0/s2_175;
  const double s2_306 = s2_270*s2_305;
  const double s2_307 = s2_267 + s2_171*s2_306;
  const double s2_308 = s2_306*s2_178;
  const double s2_309 = mbgen::min(s2_304, 2.7028219055711094*std::abs(s2_175));
  const double s2_310 = s2_169*s2_305;
  const double s2_311 = 1.0/s2_307;
  const double s2_312 = s2_311*(s2_171*s2_310);
  const double s2_313 = s2_171 - s2_269*s2_312;
  const double s2_314 = work.s1_8 + s2_171 - s2_271*s2_312;
  const double s2_315 = mbgen::min(s2_309, 6.915894223167945*std::abs(s2_307));
  const double s2_316 = s2_169*s2_311;
  const double s2_317 = 1.0/s2_314;
  const double s2_318 = s2_317*(s2_271*s2_316 - work.s1_10 - s2_175);
  const double s2_319 = s2_269*s2_316 - s2_175 - s2_313*s2_318;
  const double s2_320 = s2_184 + s2_182*s2_318;
  const double s2_321 = s2_266*s2_312;
  const double s2_322 = s2_266*s2_316 + s2_321*s2_318;
  const double s2_323 = mbgen::min(s2_315, 2.5101920700758265*std::abs(s2_314));
  work.s2_324 = mbgen::min(s2_323, 3.84681640934729*std::abs(s2_320));
  // operations: 130 add, 177 multiply, 6 divide, 21 other

  // --- step 3: Rz (61), upper_ball_left .. tie_rod_right ---
  const double s3_96 = 1.0/s2_320;
  work.s3_97 = s2_319*s3_96;
  work.s3_98 = s2_317*(s2_313 + s2_182*work.s3_97);
  work.s3_99 = s2_311*(s2_271*work.s3_98 - s2_269);
  work.s3_100 = s2_305*(s2_171*work.s3_99);
  work.s3_101 = work.s2_253*work.s3_99 - work.s2_254*work.s3_100;
  const double s3_102 = 1.0/s2_230;
  const double s3_103 = s2_231 - s2_232*work.s3_100 - s2_228*work.s3_99 - s2_233*work.s3_98;
  work.Rz_arb_front_left_0 = s3_102*s3_103;
  const double s3_104 = s2_221*work.Rz_arb_front_left_0 - work.s2_206*work.s3_99;
  work.s3_105 = s3_104 + work.s2_209*work.s3_100;
  const double s3_106 = 1.0/s2_299;
  work.s3_107 = s2_302*s3_106;
  work.s3_108 = s2_297*(s2_293 + s2_188*work.s3_107);
  work.s3_109 = tau[Coordinate::lower_arm_right] - work.s5_36*work.s3_108;
  work.Rz_carrier_right_ry_1 = s2_290*(s2_281 - s2_279*work.s3_108);
  work.s3_110 = work.s1_30 + work.s2_211*work.Rz_carrier_right_ry_1;
  work.s3_111 = work.s1_30 + work.s2_255*work.Rz_carrier_right_ry_1;
  work.Rz_carrier_right_rx_1 = s2_285*(s2_192*work.Rz_carrier_right_ry_1);
  const double s3_112 = s2_242 + s2_241*work.Rz_carrier_right_rx_1;
  const double s3_113 = work.s2_257*work.Rz_carrier_right_rx_1;
  work.s3_114 = s3_113 - work.s2_256*work.Rz_carrier_right_ry_1;
  const double s3_115 = 1.0/s2_239;
  work.Rz_arb_front_right_1 = s3_115*(s3_112 - s2_236*work.Rz_carrier_right_ry_1 -
      s2_240*work.s3_108);
  const double s3_116 = work.s2_217*work.Rz_carrier_right_rx_1;
  const double s3_117 = s2_225*work.Rz_arb_front_right_1 - s3_116;
  work.s3_118 = s3_117 + work.s2_214*work.Rz_carrier_right_ry_1;
  work.Rz_upper_arm_left_2 = s2_322*s3_96;
  work.Rz_lower_arm_left_2 = s2_317*(s2_182*work.Rz_upper_arm_left_2 - s2_321);
  work.s3_119 = s2_311*(s2_266 - s2_271*work.Rz_lower_arm_left_2);
  work.s3_120 = s2_305*(s2_171*work.s3_119);
  const double s3_121 = s2_233*work.Rz_lower_arm_left_2 - s2_232*work.s3_120;
  work.s3_122 = s2_264 + work.s2_253*work.s3_119 - work.s2_254*work.s3_120;
  work.s3_123 = s2_301*s3_106;
  work.Rz_carrier_right_rz_2 = s2_297*(s2_300 - s2_188*work.s3_123);
  work.Rz_carrier_right_ry_2 = s2_290*(s2_279*work.Rz_carrier_right_rz_2 - s2_276);
  const double s3_124 = work.s2_211*work.Rz_carrier_right_ry_2;
  work.s3_125 = s3_124 - work.s2_217*work.Rz_carrier_right_rz_2;
  const double s3_126 = s2_272 - work.s2_255*work.Rz_carrier_right_ry_2;
  work.s3_127 = s3_126 + work.s2_257*work.Rz_carrier_right_rz_2;
  work.Rz_carrier_right_rx_2 = s2_285*(s2_192*work.Rz_carrier_right_ry_2);
  const double s3_128 = s2_241*work.Rz_carrier_right_rx_2 - s2_236*work.Rz_carrier_right_ry_2;
  const double s3_129 = work.s2_214*work.Rz_carrier_right_rz_2;
  const double s3_130 = work.s2_256*work.Rz_carrier_right_rz_2;
  work.s3_131 = s3_130 - work.s2_255*work.Rz_carrier_right_rx_2;
  const double s3_132 = s2_273 - work.s2_257*work.Rz_carrier_right_rx_2;
  work.s3_133 = s3_132 + work.s2_256*work.Rz_carrier_right_ry_2;
  work.Rz_arb_front_left_2 = s3_102*(s3_121 - s2_228*work.s3_119);
  const double s3_134 = s2_221*work.Rz_arb_front_left_2 - work.s2_206*work.s3_119;
  work.s3_135 = s3_134 + work.s2_209*work.s3_120;
  work.Rz_arb_front_right_2 = s3_115*(s3_128 + s2_240*work.Rz_carrier_right_rz_2);
  const double s3_136 = work.s2_217*work.Rz_carrier_right_rx_2;
  const double s3_137 = s2_225*work.Rz_arb_front_right_2 - s3_136;
  work.s3_138 = s3_137 + work.s2_214*work.Rz_carrier_right_ry_2;
  const double s3_139 = s3_129 - work.s2_211*work.Rz_carrier_right_rx_2;
  work.s3_140 = s3_139 + work.s2_223*work.Rz_arb_front_right_2;
  const double s3_141 = 1.0/s2_251;
  work.s3_142 = s2_248*s3_141;
  work.s3_143 = s2_246 + s2_249*work.s3_142;
  // operations: 42 add, 78 multiply, 5 divide

  // --- step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right, continued ---
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s6_90 = zd_lower_arm_left*zd_lower_arm_left;
  work.s6_91 = s6_90 + zd_lower_arm_left*work.s8_14;
  work.s6_92 = work.s1_8*s6_90;
  work.s6_93 = work.s4_10*s6_76 - work.s6_92 - work.s4_39*s6_78;
  const double s6_94 = s6_85 - work.s6_92 - s6_86;
  work.s6_95 = work.s1_10*s6_90;
  const double s6_96 = work.s4_39*s6_77 - work.s6_95 - work.s4_8*s6_76;
  const double s6_97 = work.s4_39*s6_83 - work.s6_95 - work.s4_8*s6_82;
  work.s6_98 = work.s8_41*work.s2_265 - s6_97;
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double s6_99 = zd_lower_arm_right*zd_lower_arm_right;
  work.s6_100 = s6_99 + zd_lower_arm_right*work.s8_14;
  work.s6_101 = work.s1_28*s6_99;
  const double s6_102 = work.s4_21*s6_79 - work.s6_101 - work.s4_47*s6_81;
  const double s6_103 = work.s8_77*work.s2_235 - s6_102 + work.s8_41*work.s2_238;
  const double s6_104 = s6_103 + work.s8_34*work.s2_234;
  work.s6_105 = work.s1_30*s6_99;
  const double s6_106 = work.s6_105 + work.s4_47*s6_80 - work.s4_19*s6_79;
  const double s6_107 = work.s6_105 + work.s4_47*s6_88 - work.s4_19*s6_87;
  const double s6_108 = work.s6_105 + s2_200 - s2_201;
  const double s6_109 = work.s8_79*work.s2_278 - s6_107 + work.s8_37*work.s2_274;
  const double s6_110 = s6_109 - work.s8_41*work.s2_275;
  // upper_ball_left
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  const double s6_111 = zd_upper_arm_left*(zd_upper_arm_left*s2_184);
  const double s6_112 = zd_upper_arm_left*(zd_upper_arm_left*s2_182) - work.s6_92 + s2_180;
  const double s6_113 = s6_112 - s2_173;
  // upper_ball_right
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  const double s6_114 = s6_108 - zd_upper_arm_right*(zd_upper_arm_right*s2_188) + s2_295*s2_199;
  const double s6_115 = zd_upper_arm_right*(zd_upper_arm_right*s2_186);
  // arb_link_front_left
  work.s6_116 = zd_lower_arm_left*work.s1_10;
  const double s6_117 = s6_77 - work.s6_116;
  work.s6_118 = work.s8_14*s6_117;
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  const double s6_119 = zd_arb_front_left*s2_221;
  const double s6_120 = s6_96 + zd_arb_front_left*s6_119;
  work.s6_121 = work.s8_41*work.s2_227 - s6_120;
  const double s6_122 = zd_arb_front_left*work.s2_219;
  const double s6_123 = work.s4_8*s6_78 - work.s4_10*s6_77 + zd_arb_front_left*s6_122;
  const double s6_124 = work.s8_34*work.s2_227 - s6_123 + work.s8_37*work.s2_229;
  const double s6_125 = s6_124 - work.s8_54*work.s2_226;
  work.s6_126 = s6_119 - s6_76;
  work.s6_127 = work.s8_17*work.s6_126;
  work.s6_128 = zd_lower_arm_left*work.s1_8;
  const double s6_129 = s6_78 + (work.s6_128 + s6_122);
  work.s6_130 = work.s8_14*s6_129;
  // arb_link_front_right
  work.s6_131 = zd_lower_arm_right*work.s1_30;
  const double s6_132 = work.s6_131 + s6_80;
  const double s6_133 = work.s8_14*s6_132;
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  const double s6_134 = zd_arb_front_right*s2_225;
  const double s6_135 = s6_106 + zd_arb_front_right*s6_134;
  const double s6_136 = work.s8_37*work.s2_234 - s6_135 - work.s8_79*work.s2_238;
  const double s6_137 = s6_136 - work.s8_41*work.s2_235;
  const double s6_138 = zd_arb_front_right*work.s2_223;
  const double s6_139 = work.s4_19*s6_81 - work.s4_21*s6_80 + zd_arb_front_right*s6_138;
  const double s6_140 = work.s8_37*work.s2_238 - s6_139 - work.s8_54*work.s2_234;
  const double s6_141 = s6_140 - work.s8_34*work.s2_235;
  const double s6_142 = s6_134 - s6_79;
  const double s6_143 = work.s8_17*s6_142;
  work.s6_144 = zd_lower_arm_right*work.s1_28;
  const double s6_145 = s6_81 + (work.s6_144 + s6_138);
  const double s6_146 = s6_104 + work.s8_14*s6_145 + work.s8_24*s6_142;
  // drag_link
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s6_147 = zd_bell_crank*s2_246;
  const double s6_148 = zd_bell_crank*work.s2_243;
  const double s6_149 = work.s8_14*s6_148;
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double s6_150 = zd_pitman_arm*work.s2_244;
  const double s6_151 = zd_pitman_arm*s6_150 - zd_bell_crank*s6_148;
  const double s6_152 = s6_151 + work.s8_34*work.s2_247 + work.s8_37*work.s2_250;
  const double s6_153 = s6_152 - work.s8_54*work.s2_245;
  const double s6_154 = zd_pitman_arm*s2_249;
  const double s6_155 = s6_147 - s6_154;
  const double s6_156 = work.s8_17*s6_155;
  const double s6_157 = zd_bell_crank*s6_147;
  const double s6_158 = s6_157 + work.s8_41*work.s2_250 + work.s8_34*work.s2_245;
  work.s6_159 = s6_158 - work.s8_77*work.s2_247 + work.s8_24*s6_155 - work.s8_14*s6_150;
  const double s6_160 = zd_pitman_arm*s6_154;
  const double s6_161 = work.s2_247*s6_157 + work.s2_250*s6_160 + work.s2_245*s6_151;
  const double s6_162 = s6_161 + s6_148*s6_148 + s6_150*s6_150 + s6_155*s6_155;
  const double s6_163 = s6_160 + work.s8_41*work.s2_247 + work.s8_37*work.s2_245;
  const double s6_164 = s6_163 - work.s8_79*work.s2_250;
  // tie_rod_left
  const double s6_165 = work.s6_128 + s6_84;
  work.s6_166 = work.s8_14*s6_165;
  const double s6_167 = zd_bell_crank*s2_264;
  work.s6_168 = s6_94 + zd_bell_crank*s6_167;
  const double s6_169 = zd_bell_crank*work.s2_260;
  const double s6_170 = zd_bell_crank*s6_169 - work.s4_8*s6_84 + work.s4_10*s6_83;
  const double s6_171 = s6_170 + work.s8_34*work.s2_265 - work.s8_37*work.s2_268;
  const double s6_172 = s6_171 + work.s8_54*work.s2_261;
  work.s6_173 = s6_82 + s6_167;
  work.s6_174 = work.s8_17*work.s6_173;
  const double s6_175 = s6_83 + s6_169 - work.s6_116;
  const double s6_176 = work.s2_268*s6_97 - work.s2_261*s6_170 - work.s2_265*work.s6_168;
  const double s6_177 = s6_176 + s6_175*s6_175 + s6_165*s6_165 + work.s6_173*work.s6_173;
  const double s6_178 = s6_177 + s2_308;
  const double s6_179 = work.s6_95 + s2_312*s6_178 - s6_111 - s2_179 + work.s4_8*s2_176;
  const double s6_180 = s6_179 - s2_310*s2_178;
  const double s6_181 = s6_113 + s2_316*s6_178 + s2_318*s6_180;
  work.s6_182 = work.s8_14*s6_175;
  // tie_rod_right
  const double s6_183 = work.s6_144 + s6_89;
  const double s6_184 = zd_bell_crank*s2_273;
  const double s6_185 = work.s6_101 + zd_bell_crank*s6_184 - work.s4_21*s6_87 + work.s4_47*s6_89;
  const double s6_186 = s6_185 + work.s8_77*work.s2_275 + work.s8_34*work.s2_274;
  const double s6_187 = zd_bell_crank*s2_272;
  const double s6_188 = work.s4_19*s6_89 - work.s4_21*s6_88 + zd_bell_crank*s6_187;
  const double s6_189 = s6_188 + work.s8_34*work.s2_275 + work.s8_37*work.s2_278;
  const double s6_190 = s6_184 - s6_87;
  const double s6_191 = s6_187 - work.s6_131 - s6_88;
  const double s6_192 = work.s2_278*s6_107 - work.s2_274*s6_188 - work.s2_275*s6_185;
  const double s6_193 = s6_192 + s6_191*s6_191 + s6_183*s6_183 + s6_190*s6_190 + s2_288;
  const double s6_194 = work.s6_101 + s2_291*s6_193 - s6_115 - work.s4_21*s2_197 + s2_194;
  work.s6_195 = s3_96*s6_181;
  work.zdd_star_lower_arm_left = s2_317*(s6_180 - s2_182*work.s6_195);
  work.zdd_star_carrier_left_ry = s2_311*(s6_178 + s2_271*work.zdd_star_lower_arm_left);
  work.zdd_star_carrier_left_rx = s2_305*(s2_171*work.zdd_star_carrier_left_ry - s2_178);
  const double s6_196 = s2_232*work.zdd_star_carrier_left_rx - s6_117*s6_117 - s6_129*s6_129;
  const double s6_197 = s6_196 - work.s6_126*work.s6_126 + work.s2_227*work.s6_93;
  const double s6_198 = s6_197 + work.s2_229*s6_120 + work.s2_226*s6_123;
  const double s6_199 = s6_198 + s2_228*work.zdd_star_carrier_left_ry;
  work.s6_200 = work.s2_203*work.zdd_star_carrier_left_rx;
  const double s6_201 = s6_172 - work.s2_254*work.zdd_star_carrier_left_rx;
  const double s6_202 = s6_201 + work.s2_253*work.zdd_star_carrier_left_ry + work.s8_24*s6_175;
  work.s6_203 = s6_202 - work.s8_17*s6_165;
  work.s6_204 = work.s2_252*work.zdd_star_carrier_left_rx;
  work.s6_205 = s3_106*(s6_114 + s2_296*s6_193 + s2_298*s6_194);
  work.zdd_star_carrier_right_rz = s2_297*(s6_194 - s2_188*work.s6_205);
  const double s6_206 = s6_110 + work.s8_14*s6_191 - work.s8_17*s6_190;
  work.zdd_star_carrier_right_ry = s2_290*(s2_279*work.zdd_star_carrier_right_rz - s6_193);
  const double s6_207 = s6_146 - work.s2_211*work.zdd_star_carrier_right_ry;
  work.s6_208 = s6_207 + work.s2_217*work.zdd_star_carrier_right_rz;
  const double s6_209 = work.s2_255*work.zdd_star_carrier_right_ry;
  const double s6_210 = work.s2_257*work.zdd_star_carrier_right_rz;
  const double s6_211 = s6_186 - work.s8_41*work.s2_278 - s6_209 + s6_210 + work.s8_14*s6_183;
  work.s6_212 = s6_211 + work.s8_24*s6_190;
  work.zdd_star_carrier_right_rx = s2_285*(s2_192*work.zdd_star_carrier_right_ry - s2_199);
  const double s6_213 = s2_241*work.zdd_star_carrier_right_rx - work.s2_235*s6_102;
  const double s6_214 = s6_213 + work.s2_238*s6_135 + work.s2_234*s6_139 - s6_132*s6_132;
  const double s6_215 = s6_214 - s6_145*s6_145 - s6_142*s6_142;
  const double s6_216 = s6_215 - s2_236*work.zdd_star_carrier_right_ry;
  const double s6_217 = s6_137 - work.s2_214*work.zdd_star_carrier_right_rz;
  const double s6_218 = work.s2_257*work.zdd_star_carrier_right_rx;
  const double s6_219 = work.s2_256*work.zdd_star_carrier_right_ry;
  const double s6_220 = s6_189 + work.s8_54*work.s2_274 + s6_218 - s6_219 + work.s8_24*s6_191;
  work.s6_221 = s6_220 + work.s8_17*s6_183;
  const double s6_222 = s6_206 - work.s2_256*work.zdd_star_carrier_right_rz;
  work.s6_223 = s6_222 + work.s2_255*work.zdd_star_carrier_right_rx;
  work.zdd_star_arb_front_left = s3_102*(s6_199 + s2_233*work.zdd_star_lower_arm_left);
  const double s6_224 = s6_125 + s2_221*work.zdd_star_arb_front_left;
  const double s6_225 = s6_224 - work.s2_209*work.zdd_star_carrier_left_rx;
  const double s6_226 = s6_225 + work.s2_206*work.zdd_star_carrier_left_ry + work.s8_24*s6_117;
  work.s6_227 = s6_226 - work.s8_17*s6_129;
  work.s6_228 = work.s2_219*work.zdd_star_arb_front_left;
  work.zdd_star_arb_front_right = s3_115*(s6_216 + s2_240*work.zdd_star_carrier_right_rz);
  const double s6_229 = s6_141 + s2_225*work.zdd_star_arb_front_right;
  const double s6_230 = s6_229 - work.s2_217*work.zdd_star_carrier_right_rx;
  const double s6_231 = s6_230 + work.s2_214*work.zdd_star_carrier_right_ry + work.s8_24*s6_132;
  work.s6_232 = s6_231 - work.s8_17*s6_145;
  const double s6_233 = s6_217 + work.s2_211*work.zdd_star_carrier_right_rx;
  work.s6_234 = s6_233 - work.s2_223*work.zdd_star_arb_front_right - s6_143 - s6_133;
  work.s6_235 = s3_141*s6_162;
  work.s6_236 = s6_153 + s2_249*work.s6_235 + work.s8_17*s6_150 - work.s8_24*s6_148;
  work.s6_237 = s6_164 - work.s2_244*work.s6_235 + s6_149 - s6_156;
  // operations: 197 add, 242 multiply

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right ---
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s7_52 = 1.7849999999999997*R_lower_arm_left_y_y;
  const double s7_53 = s7_52 + 0.1375000000000001*R_lower_arm_left_z_y;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double R_lower_arm_right_z_y = work.sines[9];
  const double s7_54 = 1.7849999999999997*R_lower_arm_right_y_y;
  const double s7_55 = s7_54 - 0.1375000000000001*R_lower_arm_right_z_y;
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s7_56 = 0.04062499999999994*R_lower_arm_left_z_y;
  const double s7_57 = 0.1375000000000001*R_lower_arm_left_y_y + s7_56;
  work.s7_58 = R_lower_arm_left_y_y*s7_53 + R_lower_arm_left_z_y*s7_57;
  work.s7_59 = R_lower_arm_left_z_y*s7_53 - R_lower_arm_left_y_y*s7_57;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double s7_60 = 0.04062499999999994*R_lower_arm_right_z_y;
  const double s7_61 = 0.1375000000000001*R_lower_arm_right_y_y - s7_60;
  work.s7_62 = R_lower_arm_right_y_y*s7_55 - R_lower_arm_right_z_y*s7_61;
  work.s7_63 = R_lower_arm_right_z_y*s7_55 + R_lower_arm_right_y_y*s7_61;
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s7_64 = 0.6250000000000006*R_lower_arm_left_z_y;
  work.s7_65 = 5.499999999999999*R_lower_arm_left_y_y + s7_64;
  const double s7_66 = 0.6250000000000006*R_lower_arm_left_y_y;
  work.s7_67 = 5.499999999999999*R_lower_arm_left_z_y - s7_66;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double s7_68 = 0.6250000000000006*R_lower_arm_right_z_y;
  work.s7_69 = s7_68 - 5.499999999999999*R_lower_arm_right_y_y;
  const double s7_70 = 0.6250000000000006*R_lower_arm_right_y_y;
  work.s7_71 = 5.499999999999999*R_lower_arm_right_z_y + s7_70;
}

/// Part 5 of compute_accelerations: step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 7: inertias of the bodies and forces on joints,
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 7: inertias of the bodies and forces on joints,
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 7: inertias of the bodies and forces on joints,
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 7: inertias of the bodies and forces on joints,
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 7: inertias of the bodies and forces on joints,
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right.
[[gnu::noinline]] void compute_accelerations_5(const State& state, const double* tau,
    AccelerationsWork& __restrict work) noexcept {
  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right ---
  // lower_arm_left: lower_arm_left, revolute, chassis
  work.s8_504 = work.s7_65*work.s6_91 + work.zdd_star_lower_arm_left*work.s7_67;
  work.s8_505 = work.zdd_star_lower_arm_left*work.s7_65 - work.s7_67*work.s6_91;

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right,
  // continued ---
  // lower_arm_left: lower_arm_left, revolute, chassis
  work.s7_72 = 1.8256249999999996 - work.s7_58;
  work.s7_73 = work.s7_58 + work.s7_72;
  work.s7_74 = 0.22499999999999998 + work.s7_73 - 0.22499999999999998;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_75 = 1.4293999999999993*work.R_carrier_left_x_x;
  const double s7_76 = s7_75 - 0.0509*work.R_carrier_left_x_z - 0.03549999999999995*work.s1_19;
  const double s7_77 = 0.03549999999999995*work.R_carrier_left_aux2_y_y;
  const double s7_78 = s7_77 + 1.4293999999999993*work.R_carrier_left_y_x;
  const double s7_79 = s7_78 - 0.0509*work.R_carrier_left_y_z;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_80 = 1.4293999999999993*work.R_carrier_right_x_x;
  const double s7_81 = 0.03549999999999995*work.s1_39 + s7_80 - 0.0509*work.R_carrier_right_x_z;
  const double s7_82 = 1.4293999999999993*work.R_carrier_right_y_x;
  const double s7_83 = 0.03549999999999995*work.R_carrier_right_aux2_y_y;
  const double s7_84 = s7_82 - 0.0509*work.R_carrier_right_y_z - s7_83;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_85 = 0.03549999999999995*work.R_carrier_left_x_x;
  const double s7_86 = 4.6066*work.R_carrier_left_x_z + s7_85 - 11.679274999999999*work.s1_19;
  const double s7_87 = 11.679274999999999*work.R_carrier_left_aux2_y_y;
  const double s7_88 = 0.03549999999999995*work.R_carrier_left_y_x;
  const double s7_89 = s7_87 + 4.6066*work.R_carrier_left_y_z + s7_88;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_90 = 11.679274999999999*work.s1_39 + 4.6066*work.R_carrier_right_x_z;
  const double s7_91 = s7_90 + 0.03549999999999995*work.R_carrier_right_x_x;
  const double s7_92 = 11.679274999999999*work.R_carrier_right_aux2_y_y;
  const double s7_93 = 0.03549999999999995*work.R_carrier_right_y_x;
  const double s7_94 = s7_92 - 4.6066*work.R_carrier_right_y_z - s7_93;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_95 = 7.481549999999999*work.R_carrier_left_x_z;
  const double s7_96 = s7_95 - 0.0509*work.R_carrier_left_x_x - 4.6066*work.s1_19;
  const double s7_97 = 7.481549999999999*work.R_carrier_left_y_z;
  const double s7_98 = 4.6066*work.R_carrier_left_aux2_y_y + s7_97;
  const double s7_99 = s7_98 - 0.0509*work.R_carrier_left_y_x;
  const double s7_100 = work.R_carrier_left_x_z*s7_96 + work.R_carrier_left_x_x*s7_76;
  work.s7_101 = s7_100 - work.s1_19*s7_86;
  const double s7_102 = work.R_carrier_left_aux2_y_y*s7_89 + work.R_carrier_left_y_z*s7_99;
  work.s7_103 = s7_102 + work.R_carrier_left_y_x*s7_79;
  const double s7_104 = work.R_carrier_left_aux2_y_y*s7_86 + work.R_carrier_left_y_z*s7_96;
  work.s7_105 = s7_104 + work.R_carrier_left_y_x*s7_76;
  const double s7_106 = work.R_carrier_left_aux2_z_y*s7_86 + work.R_carrier_left_z_z*s7_96;
  work.s7_107 = s7_106 + work.R_carrier_left_z_x*s7_76;
  const double s7_108 = work.R_carrier_left_aux2_z_y*s7_89 + work.R_carrier_left_z_z*s7_99;
  work.s7_109 = s7_108 + work.R_carrier_left_z_x*s7_79;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_110 = 4.6066*work.s1_39 + 7.481549999999999*work.R_carrier_right_x_z;
  const double s7_111 = s7_110 - 0.0509*work.R_carrier_right_x_x;
  const double s7_112 = 7.481549999999999*work.R_carrier_right_y_z;
  const double s7_113 = s7_112 - 0.0509*work.R_carrier_right_y_x;
  const double s7_114 = s7_113 - 4.6066*work.R_carrier_right_aux2_y_y;
  const double s7_115 = work.s1_39*s7_91 + work.R_carrier_right_x_z*s7_111;
  const double s7_116 = s7_115 + work.R_carrier_right_x_x*s7_81;
  const double s7_117 = work.R_carrier_right_aux2_y_y*s7_94 + work.R_carrier_right_y_z*s7_114;
  const double s7_118 = s7_117 + work.R_carrier_right_y_x*s7_84;
  const double s7_119 = work.R_carrier_right_y_z*s7_111 + work.R_carrier_right_y_x*s7_81;
  const double s7_120 = s7_119 - work.R_carrier_right_aux2_y_y*s7_91;
  const double s7_121 = work.R_carrier_right_z_z*s7_111 + work.R_carrier_right_z_x*s7_81;
  const double s7_122 = s7_121 - work.R_carrier_right_aux2_z_y*s7_91;
  const double s7_123 = work.R_carrier_right_aux2_z_y*s7_94 + work.R_carrier_right_z_z*s7_114;
  const double s7_124 = s7_123 + work.R_carrier_right_z_x*s7_84;

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_506 = work.s3_100*work.s7_105 + work.s3_99*work.s7_107;
  work.s8_507 = work.s3_120*work.s7_105 + work.s3_119*work.s7_107;
  work.s8_508 = work.s3_119*work.s7_109 - work.Rz_lower_arm_left_2*work.s7_105;
  work.s8_509 = s7_116 + (work.s8_359 + work.s7_101);
  const double s8_510 = s7_118 + (work.s8_363 + work.s7_103);
  const double s8_511 = s7_120 + (work.s8_360 + work.s7_105);
  const double s8_512 = s7_122 + (work.s8_361 + work.s7_107);

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right,
  // continued ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s7_125 = 20.590224999999997 - work.s7_101 - work.s7_103;
  const double s7_126 = work.s8_366 + work.s7_125;
  const double s7_127 = 26.970000000000002*work.R_carrier_left_aux2_y_y;
  const double s7_128 = 26.970000000000002*work.R_carrier_left_aux2_z_y;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_129 = 0.6700000000000002*work.R_carrier_left_x_x;
  work.s7_130 = 36.825*work.R_carrier_left_x_z - s7_129 - 26.970000000000002*work.s1_19;
  const double s7_131 = 0.6700000000000002*work.R_carrier_left_y_x;
  work.s7_132 = s7_127 + 36.825*work.R_carrier_left_y_z - s7_131;
  const double s7_133 = 0.6700000000000002*work.R_carrier_left_z_x;
  work.s7_134 = s7_128 + 36.825*work.R_carrier_left_z_z - s7_133;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_135 = 26.970000000000002*work.s1_39 + 36.825*work.R_carrier_right_x_z;
  const double s7_136 = s7_135 - 0.6700000000000002*work.R_carrier_right_x_x;
  const double s7_137 = 0.6700000000000002*work.R_carrier_right_y_x;
  const double s7_138 = 26.970000000000002*work.R_carrier_right_aux2_y_y;
  const double s7_139 = 36.825*work.R_carrier_right_y_z - s7_137 - s7_138;
  const double s7_140 = 0.6700000000000002*work.R_carrier_right_z_x;
  const double s7_141 = 26.970000000000002*work.R_carrier_right_aux2_z_y;
  const double s7_142 = 36.825*work.R_carrier_right_z_z - s7_140 - s7_141;

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s8_513 = work.Rz_carrier_right_rx_1*s7_142 - work.Rz_carrier_right_ry_1*s7_139;
  work.s8_514 = work.Rz_carrier_right_rx_2*s7_142 - work.Rz_carrier_right_ry_2*s7_139;
  work.s8_515 = work.Rz_carrier_right_ry_2*s7_136 - work.Rz_carrier_right_rz_2*s7_142;
  work.s8_516 = work.Rz_carrier_right_rz_2*s7_139 - work.Rz_carrier_right_rx_2*s7_136;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_517 = work.s3_99*work.s7_132 - work.s3_100*work.s7_134;
  work.s8_518 = work.s3_119*work.s7_132 - work.s3_120*work.s7_134;
  work.s8_519 = s7_136 + (work.s8_159 + work.s7_130);
  work.s8_520 = s7_139 + (work.s8_160 + work.s7_132);
  work.s8_521 = s7_142 + (work.s8_161 + work.s7_134);

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right,
  // continued ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s7_143 = work.s7_125 + (work.s7_101 + work.s7_103);
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double R_upper_arm_left_z_y = work.sines[7];
  const double s7_144 = 0.022500000000000023*R_upper_arm_left_z_y;
  const double s7_145 = 0.5125000000000002*R_upper_arm_left_y_y + s7_144;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double R_upper_arm_right_z_y = work.sines[13];
  const double s7_146 = 0.022500000000000023*R_upper_arm_right_z_y;
  const double s7_147 = 0.5125000000000002*R_upper_arm_right_y_y - s7_146;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double s7_148 = 0.022500000000000023*R_upper_arm_left_y_y;
  const double s7_149 = s7_148 + 0.026500000000000024*R_upper_arm_left_z_y;
  work.s7_150 = R_upper_arm_left_y_y*s7_145 + R_upper_arm_left_z_y*s7_149;
  work.s7_151 = R_upper_arm_left_z_y*s7_145 - R_upper_arm_left_y_y*s7_149;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double s7_152 = 0.022500000000000023*R_upper_arm_right_y_y;
  const double s7_153 = s7_152 - 0.026500000000000024*R_upper_arm_right_z_y;
  work.s7_154 = R_upper_arm_right_y_y*s7_147 - R_upper_arm_right_z_y*s7_153;
  work.s7_155 = R_upper_arm_right_z_y*s7_147 + R_upper_arm_right_y_y*s7_153;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double s7_156 = 0.15000000000000013*R_upper_arm_left_z_y;
  work.s7_157 = 2.2500000000000004*R_upper_arm_left_y_y + s7_156;
  const double s7_158 = 0.15000000000000013*R_upper_arm_left_y_y;
  work.s7_159 = 2.2500000000000004*R_upper_arm_left_z_y - s7_158;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double s7_160 = 0.15000000000000013*R_upper_arm_right_z_y;
  work.s7_161 = s7_160 - 2.2500000000000004*R_upper_arm_right_y_y;
  const double s7_162 = 0.15000000000000013*R_upper_arm_right_y_y;
  work.s7_163 = 2.2500000000000004*R_upper_arm_right_z_y + s7_162;

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  // upper_arm_right: upper_arm_right, revolute, chassis
  work.s8_522 = work.s7_161*work.s8_15 + work.s6_205*work.s7_163;
  work.s8_523 = work.s7_163*work.s8_15 - work.s6_205*work.s7_161;
  // upper_arm_left: upper_arm_left, revolute, chassis
  work.s8_524 = work.s6_195*work.s7_159 - work.s7_157*work.s8_16;
  work.s8_525 = work.s6_195*work.s7_157 + work.s7_159*work.s8_16;

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right,
  // continued ---
  // upper_arm_left: upper_arm_left, revolute, chassis
  work.s7_164 = 0.5390000000000001 - work.s7_150;
  const double s7_165 = work.s7_150 + work.s7_164;
  const double s7_166 = 0.07500000000000001 + s7_165 - 0.07500000000000001;
  // arb_front_left: arb_front_left, revolute, chassis
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s7_167 = 0.07700000000000003*R_arb_front_left_x_z;
  const double s7_168 = 0.2826999999999999*R_arb_front_left_x_x - s7_167;
  // arb_front_right: arb_front_right, revolute, chassis
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s7_169 = 0.07700000000000003*R_arb_front_right_x_z;
  const double s7_170 = 0.2826999999999999*R_arb_front_right_x_x - s7_169;
  // arb_front_left: arb_front_left, revolute, chassis
  work.s7_171 = 0.047*R_arb_front_left_x_z - 0.11949999999999995*R_arb_front_left_x_x;
  work.s7_172 = 0.047*R_arb_front_left_x_x + 0.11949999999999995*R_arb_front_left_x_z;
  // arb_front_right: arb_front_right, revolute, chassis
  work.s7_173 = 0.11949999999999995*R_arb_front_right_x_x - 0.047*R_arb_front_right_x_z;
  work.s7_174 = 0.047*R_arb_front_right_x_x + 0.11949999999999995*R_arb_front_right_x_z;
  // arb_front_left: arb_front_left, revolute, chassis
  const double s7_175 = 0.06500000000000002*R_arb_front_left_x_z;
  const double s7_176 = s7_175 - 0.07700000000000003*R_arb_front_left_x_x;
  work.s7_177 = R_arb_front_left_x_z*s7_176 + R_arb_front_left_x_x*s7_168;
  work.s7_178 = R_arb_front_left_x_x*s7_176 - R_arb_front_left_x_z*s7_168;
  // arb_front_right: arb_front_right, revolute, chassis
  const double s7_179 = 0.06500000000000002*R_arb_front_right_x_z;
  const double s7_180 = s7_179 - 0.07700000000000003*R_arb_front_right_x_x;
  work.s7_181 = R_arb_front_right_x_z*s7_180 + R_arb_front_right_x_x*s7_170;
  work.s7_182 = R_arb_front_right_x_x*s7_180 - R_arb_front_right_x_z*s7_170;
  // arb_front_left: arb_front_left, revolute, chassis
  const double s7_183 = 0.5000000000000002*R_arb_front_left_x_z;
  work.s7_184 = s7_183 - 1.2899999999999996*R_arb_front_left_x_x;
  const double s7_185 = 0.5000000000000002*R_arb_front_left_x_x;
  work.s7_186 = s7_185 + 1.2899999999999996*R_arb_front_left_x_z;
  // arb_front_right: arb_front_right, revolute, chassis
  const double s7_187 = 0.5000000000000002*R_arb_front_right_x_z;
  work.s7_188 = s7_187 - 1.2899999999999996*R_arb_front_right_x_x;
  const double s7_189 = 0.5000000000000002*R_arb_front_right_x_x;
  work.s7_190 = s7_189 + 1.2899999999999996*R_arb_front_right_x_z;

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  // arb_front_right: arb_front_right, revolute, chassis
  work.s8_526 = work.zdd_star_arb_front_right*work.s7_190 - work.s7_188*work.s8_22;
  work.s8_527 = work.s7_190*work.s8_22 + work.zdd_star_arb_front_right*work.s7_188;
  // arb_front_left: arb_front_left, revolute, chassis
  work.s8_528 = work.zdd_star_arb_front_left*work.s7_186 - work.s7_184*work.s8_23;
  work.s8_529 = work.s7_186*work.s8_23 + work.zdd_star_arb_front_left*work.s7_184;

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right,
  // continued ---
  // arb_front_left: arb_front_left, revolute, chassis
  work.s7_191 = 0.3476999999999999 - work.s7_177;
  const double s7_192 = work.s7_177 + work.s7_191;
  const double s7_193 = 0.20789999999999997 + s7_192 - 0.20789999999999997;
  // lower_arm_right: lower_arm_right, revolute, chassis
  work.s7_194 = 1.8256249999999996 - work.s7_62;
  work.s7_195 = 0.22499999999999998 + (work.s7_62 + work.s7_194) - 0.22499999999999998;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_196 = 20.590224999999997 - s7_116 - s7_118;
  const double s7_197 = s7_196 + s7_126;
  const double s7_198 = s7_196 + (s7_116 + s7_118);
  // upper_arm_right: upper_arm_right, revolute, chassis
  work.s7_199 = 0.5390000000000001 - work.s7_154;
  const double s7_200 = work.s7_154 + work.s7_199;
  const double s7_201 = 0.07500000000000001 + s7_200 - 0.07500000000000001;
  // arb_front_right: arb_front_right, revolute, chassis
  work.s7_202 = 0.3476999999999999 - work.s7_181;
  const double s7_203 = work.s7_181 + work.s7_202;
  const double s7_204 = 0.20789999999999997 + s7_203 - 0.20789999999999997;
  // pitman_arm: pitman_arm, revolute, chassis
  const double R_pitman_arm_x_x = work.cosines[15];
  const double s7_205 = 0.01999999999999999*R_pitman_arm_x_x;
  const double R_pitman_arm_x_z = work.sines[15];
  const double s7_206 = 0.3303999999999999*R_pitman_arm_x_z;
  work.s7_207 = R_pitman_arm_x_z*s7_206 + R_pitman_arm_x_x*s7_205;
  work.s7_208 = R_pitman_arm_x_x*s7_206 - R_pitman_arm_x_z*s7_205;
  work.s7_209 = 1.65*R_pitman_arm_x_z;
  const double s7_210 = work.s7_209*work.s8_231;
  work.s7_211 = 1.65*R_pitman_arm_x_x;
  work.s7_212 = work.s6_235*work.s7_211 + work.s7_209*work.s8_21;
  work.s7_213 = work.s7_211*work.s8_21 - work.s6_235*work.s7_209;
  const double s7_214 = work.s7_211*work.s8_74;
  work.s7_215 = 0.3503999999999999 - work.s7_207;
  const double s7_216 = work.s7_207 + work.s7_215;
  const double s7_217 = 0.009999999999999995 + s7_216 - 0.009999999999999995;
  // bell_crank: bell_crank, revolute, chassis
  const double R_bell_crank_y_x = work.sines[16];
  const double s7_218 = 0.05040000000000004*R_bell_crank_y_x;
  const double R_bell_crank_x_x = work.cosines[16];
  const double s7_219 = s7_218 + 0.37410000000000015*R_bell_crank_x_x;
  const double s7_220 = 0.05040000000000004*R_bell_crank_x_x;
  const double s7_221 = s7_220 + 0.5773999999999999*R_bell_crank_y_x;
  work.s7_222 = R_bell_crank_y_x*s7_221 + R_bell_crank_x_x*s7_219;
  const double s7_223 = R_bell_crank_y_x*(0.37410000000000015*R_bell_crank_y_x - s7_220);
  work.s7_224 = R_bell_crank_x_x*(0.5773999999999999*R_bell_crank_x_x - s7_218) + s7_223;
  work.s7_225 = R_bell_crank_y_x*s7_219 - R_bell_crank_x_x*s7_221;
  work.s7_226 = 0.9615 - work.s7_222 - work.s7_224;
  const double s7_227 = 2.0700000000000003*R_bell_crank_y_x;
  work.s7_228 = s7_227 + 2.0300000000000007*R_bell_crank_x_x;
  const double s7_229 = 2.0700000000000003*R_bell_crank_x_x;
  work.s7_230 = s7_229 - 2.0300000000000007*R_bell_crank_y_x;
  const double s8_530 = tau[Coordinate::bell_crank] - work.s7_230*work.s8_73;
  work.s8_531 = s8_530 + work.s7_228*work.s8_51;
  work.s7_231 = work.s7_226 + (work.s7_222 + work.s7_224) - work.s7_226;
  // operations: 152 add, 194 multiply

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  work.s8_532 = work.s1_8*work.s3_98;
  work.s8_533 = 1.0 - work.s3_98;
  const double s8_534 = work.s3_100*work.s7_130 + work.s7_132*work.s8_533;
  work.s8_535 = work.s3_99*work.s7_109 - work.s7_105*work.s8_533;
  work.s8_536 = work.s1_10*work.s3_98;
  work.s8_537 = work.s8_536 - work.s2_209*work.s8_533 - work.s2_203*work.s3_99;
  const double s8_538 = work.s2_203*work.s3_100 - work.s8_532 + work.s2_206*work.s8_533;
  work.s8_539 = s8_538 + work.s2_219*work.Rz_arb_front_left_0;
  const double s8_540 = work.s8_537*work.s8_537 + work.s8_539*work.s8_539;
  work.s8_541 = work.s8_536 - work.s2_254*work.s8_533 - work.s2_252*work.s3_99;
  work.s8_542 = work.s2_252*work.s3_100 - work.s8_532 + work.s2_253*work.s8_533;
  const double s8_543 = work.s8_541*work.s8_541 + work.s8_542*work.s8_542;
  work.s8_544 = s8_543 + work.s3_101*work.s3_101;
  work.s8_545 = 0.3333333333333333*(s8_540 + work.s3_105*work.s3_105);
  work.s8_546 = 1.0 - work.s3_108;
  const double s8_547 = work.Rz_carrier_right_ry_1*s7_136 - s7_142*work.s8_546;
  const double s8_548 = s7_139*work.s8_546 - work.Rz_carrier_right_rx_1*s7_136;
  work.s8_549 = work.s3_110 - work.s2_217*work.s8_546;
  const double s8_550 = work.s2_211*work.Rz_carrier_right_rx_1;
  const double s8_551 = work.s1_28 + work.s2_214*work.s8_546 - s8_550;
  work.s8_552 = s8_551 + work.s2_223*work.Rz_arb_front_right_1;
  const double s8_553 = work.s8_549*work.s8_549 + work.s8_552*work.s8_552;
  const double s8_554 = work.s8_549*work.s3_125 + work.s8_552*work.s3_140;
  work.s8_555 = work.s3_111 - work.s2_257*work.s8_546;
  const double s8_556 = work.s2_255*work.Rz_carrier_right_rx_1;
  work.s8_557 = work.s1_28 + work.s2_256*work.s8_546 - s8_556;
  const double s8_558 = work.s8_555*work.s8_555 + work.s8_557*work.s8_557;
  work.s8_559 = s8_558 + work.s3_114*work.s3_114;
  const double s8_560 = 0.3333333333333333*(s8_553 + work.s3_118*work.s3_118);
  const double s8_561 = work.s8_557*work.s3_131 - work.s3_114*work.s3_133;
  work.s8_562 = s8_561 - work.s8_555*work.s3_127;
  const double s8_563 = 0.3333333333333333*(s8_554 + work.s3_118*work.s3_138);
  work.s8_564 = work.s1_10*work.Rz_lower_arm_left_2;
  const double s8_565 = work.s8_564 + work.s2_209*work.Rz_lower_arm_left_2;
  work.s8_566 = s8_565 + work.s2_203*work.s3_119;
  work.s8_567 = work.s1_8*work.Rz_lower_arm_left_2;
  const double s8_568 = work.s8_567 + work.s2_203*work.s3_120;
  const double s8_569 = s8_568 + work.s2_206*work.Rz_lower_arm_left_2;
  work.s8_570 = s8_569 + work.s2_219*work.Rz_arb_front_left_2;
  const double s8_571 = work.s8_539*work.s8_570 + work.s3_105*work.s3_135;
  const double s8_572 = work.s8_567 + work.s2_252*work.s3_120;
  work.s8_573 = s8_572 + work.s2_253*work.Rz_lower_arm_left_2;
  work.s8_574 = work.s8_542*work.s8_573 + work.s3_101*work.s3_122;
  work.s8_575 = 0.3333333333333333*(s8_571 - work.s8_537*work.s8_566);
  const double s8_576 = work.s8_566*work.s8_566 + work.s8_570*work.s8_570;
  const double s8_577 = s8_576 + work.s3_135*work.s3_135 + work.s3_125*work.s3_125;
  const double s8_578 = s8_577 + work.s3_140*work.s3_140 + work.s3_138*work.s3_138;
  work.s8_579 = 0.3333333333333333*s8_578;
  work.s8_580 = work.s1_10*work.zdd_star_lower_arm_left;
  const double s8_581 = work.s1_8*work.zdd_star_lower_arm_left;
  const double s8_582 = work.s6_121 - s8_581 + work.s8_37*work.s2_226 - work.s8_79*work.s2_229;
  const double s8_583 = s8_582 - work.s2_206*work.zdd_star_lower_arm_left + work.s6_200;
  work.s8_584 = s8_583 - work.s6_228 - work.s6_127 - work.s6_118;
  const double s8_585 = work.s6_98 - s8_581 + work.s8_79*work.s2_268 - work.s8_37*work.s2_261;
  const double s8_586 = work.s2_253*work.zdd_star_lower_arm_left;
  work.s8_587 = s8_585 + work.s6_174 - work.s6_182 - s8_586 + work.s6_204;
  // bell_crank: bell_crank, revolute, chassis
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  work.s8_588 = zd_bell_crank*work.s8_14;
  work.s8_589 = work.s7_222*work.s8_588;
  work.s8_590 = zd_bell_crank*work.s8_17;
  work.s8_591 = work.s7_230*work.s8_590 - work.s7_228*work.s8_588;
  work.s8_592 = work.s7_225*work.s8_590;
  work.s8_593 = work.s7_230*work.s8_33;
  work.s8_594 = 33.31250000000001 - work.s7_228;
  work.s8_595 = 6.5*work.s8_594;
  // pitman_arm: pitman_arm, revolute, chassis
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  work.s8_596 = zd_pitman_arm*work.s8_14;
  work.s8_597 = work.s7_207*work.s8_596;
  work.s8_598 = zd_pitman_arm*work.s8_24;
  work.s8_599 = work.s7_211*work.s8_598 + work.s7_209*work.s8_596;
  work.s8_600 = work.s7_208*work.s8_598;
  work.s8_601 = work.s6_235*s7_216;
  work.s8_602 = 23.1 - work.s7_209;
  work.s8_603 = 8.8*work.s8_602;
  // pitman_arm: pitman_arm, revolute, chassis
  const double s8_604 = s7_210 - work.s8_601 - tau[Coordinate::pitman_arm] - s7_214;
  const double s8_605 = work.s8_79 - work.s8_54;
  const double s8_606 = s8_604 + work.s8_37*(work.s7_215 - work.s7_207) + work.s7_208*s8_605;
  work.s8_607 = work.s3_142*s8_606;
  work.s8_608 = work.s3_142*s7_217;
  const double s8_609 = work.s7_231 + work.s3_142*work.s8_608;
  // arb_front_right: arb_front_right, revolute, chassis
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  work.s8_610 = zd_arb_front_right*work.s8_14;
  work.s8_611 = work.s7_181*work.s8_610;
  work.s8_612 = zd_arb_front_right*work.s8_24;
  work.s8_613 = work.s7_190*work.s8_612 + work.s7_188*work.s8_610;
  work.s8_614 = work.s7_182*work.s8_612;
  work.s8_615 = work.zdd_star_arb_front_right*s7_203;
  const double s8_616 = tau[Coordinate::arb_front_right] - work.s8_615 + work.s8_34*work.s7_174;
  const double s8_617 = s8_616 + work.s8_41*work.s7_173 + work.s7_188*(work.s8_99 - work.s8_107);
  const double s8_618 = s8_617 + work.s7_190*(work.s8_106 + work.s8_75);
  work.s8_619 = s8_618 - work.s8_37*(work.s7_202 - work.s7_181) - work.s7_182*s8_605;
  work.s8_620 = work.Rz_arb_front_right_1*work.s8_619;
  work.s8_621 = work.Rz_arb_front_right_1*s7_204;
  const double s8_622 = work.s7_195 + work.Rz_arb_front_right_1*work.s8_621;
  work.s8_623 = work.Rz_arb_front_right_2*s7_204;
  const double s8_624 = s8_609 + work.Rz_arb_front_right_2*work.s8_623;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  work.s8_625 = zd_upper_arm_right*work.s8_17;
  work.s8_626 = work.s7_154*work.s8_625;
  work.s8_627 = zd_upper_arm_right*work.s8_24;
  work.s8_628 = work.s7_161*work.s8_625 - work.s7_163*work.s8_627;
  work.s8_629 = work.s7_155*work.s8_627;
  work.s8_630 = work.s6_205*s7_200;
  const double s8_631 = 3.6*work.s8_54;
  const double s8_632 = work.s6_144*work.s8_17 - s8_631 - work.s6_131*work.s8_24;
  const double s8_633 = s8_632 + work.r_carrier_right_aux1_y*work.s8_34 - work.s2_237*work.s8_37;
  const double s8_634 = work.s6_116*work.s8_24 - s8_631 + work.s6_128*work.s8_17;
  const double s8_635 = s8_634 + work.r_carrier_left_aux1_y*work.s8_34;
  work.s8_636 = s8_635 + work.r_carrier_left_aux1_z*work.s8_37;
  const double s8_637 = 3.6*work.s8_34;
  const double s8_638 = s8_637 - 0.28*work.s8_41;
  work.s8_639 = s8_637 - 0.62*work.s8_41;
  const double s8_640 = 0.5*work.s8_77;
  const double s8_641 = work.s7_163*(s8_640 + s8_638) - work.s8_630;
  const double s8_642 = 3.6*work.s8_37;
  const double s8_643 = s8_642 + 0.28*work.s8_79;
  work.s8_644 = s8_642 + 0.62*work.s8_79;
  const double s8_645 = s8_641 - tau[Coordinate::upper_arm_right];
  const double s8_646 = s8_645 + work.s7_161*(s8_643 - work.s8_230);
  work.s8_647 = work.s8_77 - work.s8_79;
  const double s8_648 = s8_646 + work.s8_41*(work.s7_154 - work.s7_199);
  work.s8_649 = s8_648 + work.s7_155*work.s8_647;
  work.s8_650 = work.s3_107*work.s8_649;
  work.s8_651 = work.s3_107*s7_201;
  const double s8_652 = s8_622 + work.s3_107*work.s8_651;
  work.s8_653 = work.s3_123*s7_201;
  const double s8_654 = work.Rz_arb_front_right_1*work.s8_623 + work.s3_107*work.s8_653;
  const double s8_655 = s8_624 + work.s3_123*work.s8_653;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s8_656 = s8_637 - work.s6_101 - work.s2_237*work.s8_41;
  const double s8_657 = s8_656 - work.r_carrier_right_aux1_y*work.s8_77 - work.s6_144*work.s8_14;
  const double s8_658 = work.s6_105 + s8_642 + work.s6_131*work.s8_14;
  const double s8_659 = s8_658 + work.r_carrier_right_aux1_y*work.s8_41 + work.s2_237*work.s8_79;
  const double s8_660 = work.w_carrier_right_x*work.w_carrier_right_z;
  const double s8_661 = work.w_carrier_right_y*work.w_carrier_right_z;
  const double s8_662 = work.zdd_star_carrier_right_ry + work.s4_49;
  const double s8_663 = work.w_carrier_right_x*work.w_carrier_right_y;
  const double s8_664 = s8_662 + s8_663;
  const double s8_665 = work.zdd_star_carrier_right_rx + work.s4_48;
  const double s8_666 = s8_660 - s8_665;
  const double s8_667 = s8_663 - s8_662;
  const double s8_668 = work.w_carrier_right_x*work.w_carrier_right_x;
  const double s8_669 = work.w_carrier_right_z*work.w_carrier_right_z;
  const double s8_670 = s8_668 + s8_669;
  const double s8_671 = work.zdd_star_carrier_right_rz + work.s4_22;
  const double s8_672 = s8_671 + s8_661;
  const double s8_673 = s8_665 + s8_660;
  const double s8_674 = work.w_carrier_right_y*work.w_carrier_right_y;
  const double s8_675 = s8_674 + s8_669;
  const double s8_676 = work.s8_498 + s7_124*s8_667 + s7_196*s8_673 - s7_120*s8_672;
  const double s8_677 = s8_661 - s8_671;
  const double s8_678 = work.s8_497 + s7_118*s8_672 + s7_120*s8_666 - s7_196*s8_677;
  const double s8_679 = work.s8_499 + s7_122*s8_677 + s7_116*s8_664 - s7_118*s8_667;
  const double s8_680 = s8_668 + s8_674;
  work.f_carrier_right_x = s7_139*s8_667 + s7_142*s8_673 - s7_136*s8_675 + 219.5*s8_633;
  work.f_carrier_right_y = s7_142*s8_677 + s7_136*s8_664 - s7_139*s8_670 + 219.5*s8_657;
  work.f_carrier_right_z = s7_139*s8_672 + s7_136*s8_666 - s7_142*s8_680 + 219.5*s8_659;
  work.s8_681 = s8_547 + 219.5*work.s1_30;
  work.s8_682 = s8_548 + 219.5*work.s1_28;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_683 = 219.5*work.s8_636;
  work.s8_684 = 219.5*work.s8_536 - work.s7_134*work.s8_533 - work.s3_99*work.s7_130;
  work.s8_685 = s8_534 - 219.5*work.s8_532;
  const double s8_686 = work.Rz_lower_arm_left_2*work.s7_134 + work.s3_119*work.s7_130;
  work.s8_687 = s8_686 + 219.5*work.s8_564;
  const double s8_688 = work.s3_120*work.s7_130 + work.Rz_lower_arm_left_2*work.s7_132;
  work.s8_689 = s8_688 + 219.5*work.s8_567;
  const double s8_690 = work.s1_30*work.f_carrier_right_y;
  const double s8_691 = work.s1_28*work.f_carrier_right_z;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s8_692 = s8_678 - s7_122*s8_664 + s7_139*s8_659 - s7_142*s8_657;
  work.n_carrier_right_x = s8_692 + s7_124*(s8_670 - s8_680);
  const double s8_693 = work.s3_109 - work.s8_546*work.n_carrier_right_x - s8_690 - s8_691;
  const double s8_694 = s8_676 - s7_116*s8_666 + s7_142*s8_633 - s7_136*s8_659;
  work.n_carrier_right_y = s8_694 + s7_122*(s8_680 - s8_675);
  work.s8_695 = work.s5_40 - work.n_carrier_right_y;
  work.s8_696 = work.Rz_carrier_right_rx_1*work.s8_695;
  const double s8_697 = s8_679 - s7_124*s8_673 + s7_136*s8_657 - s7_139*s8_633;
  work.n_carrier_right_z = s8_697 + s7_120*(s8_675 - s8_670);
  work.s8_698 = work.s5_44 - work.n_carrier_right_z;
  work.s8_699 = work.Rz_carrier_right_ry_1*work.s8_698;
  work.s8_700 = s7_139 + 109.75*work.r_carrier_right_aux1_y;
  work.s8_701 = s7_142 - 109.75*work.s2_237;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_702 = work.s7_132 + 109.75*work.r_carrier_left_aux1_y;
  work.s8_703 = work.s7_134 + 109.75*work.r_carrier_left_aux1_z;
  const double s8_704 = work.r_carrier_right_aux1_y*work.s8_701;
  const double s8_705 = s7_124 + (work.s8_364 + work.s7_109) + s8_704 - work.s2_237*work.s8_700;
  const double s8_706 = s8_705 + work.r_carrier_left_aux1_y*work.s8_703;
  work.s8_707 = s8_706 + work.r_carrier_left_aux1_z*work.s8_702;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s8_708 = 395.1 + s7_136;
  work.s8_709 = s8_511 + work.r_carrier_right_aux1_y*work.s8_708;
  work.s8_710 = s8_512 - work.s2_237*work.s8_708;
  const double s8_711 = work.s8_700*(work.r_carrier_right_aux1_y + work.r_carrier_right_aux1_y);
  work.s8_712 = s8_510 + s8_711;
  work.s8_713 = s7_197 - work.s8_701*(work.s2_237 + work.s2_237);
  const double s8_714 = s7_198 - s7_116;
  const double s8_715 = work.s8_546*s8_714 - work.Rz_carrier_right_ry_1*s7_122;
  const double s8_716 = s8_715 - work.Rz_carrier_right_rx_1*s7_120 + work.s1_28*s7_139;
  work.s8_717 = s8_716 - work.s1_30*s7_142;
  const double s8_718 = work.Rz_carrier_right_rz_2*s8_714 - work.Rz_carrier_right_ry_2*s7_122;
  work.s8_719 = s8_718 - work.Rz_carrier_right_rx_2*s7_120;
  const double s8_720 = s7_198 - s7_118;
  const double s8_721 = work.Rz_carrier_right_rx_1*s8_720 - work.Rz_carrier_right_ry_1*s7_124;
  work.s8_722 = s8_721 - s7_120*work.s8_546 - work.s1_28*s7_136;
  const double s8_723 = work.Rz_carrier_right_rx_2*s8_720 - work.Rz_carrier_right_ry_2*s7_124;
  work.s8_724 = s8_723 - work.Rz_carrier_right_rz_2*s7_120;
  const double s8_725 = s7_198 - s7_196;
  const double s8_726 = work.Rz_carrier_right_ry_1*s8_725 - s7_122*work.s8_546;
  const double s8_727 = s8_726 - work.Rz_carrier_right_rx_1*s7_124 + work.s1_30*s7_136;
  const double s8_728 = work.Rz_carrier_right_ry_2*s8_725 - work.Rz_carrier_right_rz_2*s7_122;
  work.s8_729 = s8_728 - work.Rz_carrier_right_rx_2*s7_124;
  const double s8_730 = s8_652 + work.Rz_carrier_right_rx_1*work.s8_722;
  const double s8_731 = s8_730 + work.Rz_carrier_right_ry_1*s8_727 + work.s8_546*work.s8_717;
  work.s8_732 = s8_731 + work.s1_30*work.s8_681 + work.s1_28*work.s8_682 - s8_560;
  const double s8_733 = s8_654 + work.Rz_carrier_right_rx_1*work.s8_724;
  const double s8_734 = s8_733 + work.Rz_carrier_right_ry_1*work.s8_729;
  const double s8_735 = s8_734 + work.s8_546*work.s8_719 + work.s1_30*work.s8_515;
  work.s8_736 = s8_735 + work.s1_28*work.s8_516 - s8_563;
  const double s8_737 = s8_655 + work.Rz_carrier_right_rx_2*work.s8_724;
  const double s8_738 = s8_737 + work.Rz_carrier_right_ry_2*work.s8_729;
  const double s8_739 = s8_738 + work.Rz_carrier_right_rz_2*work.s8_719;
  work.s8_740 = work.Rz_arb_front_right_1*work.s7_190;
  const double s8_741 = s8_727 + work.Rz_arb_front_right_1*work.s7_174 + 0.45*work.s8_740;
  work.s8_742 = s8_741 - work.r_carrier_right_aux1_y*work.s8_513;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  work.s8_743 = zd_lower_arm_right*work.s8_17;
  work.s8_744 = work.s7_62*work.s8_743;
  work.s8_745 = zd_lower_arm_right*work.s8_24;
  work.s8_746 = work.s7_69*work.s8_743 - work.s7_71*work.s8_745;
  work.s8_747 = work.s7_63*work.s8_745;
  work.s8_748 = work.s7_71*work.s6_100;
  work.s8_749 = 0.4*work.s8_77;
  work.s8_750 = 0.4*work.s8_41;
  const double s8_751 = s8_693 - work.s7_71*(work.s8_749 + work.s8_639);
  work.s8_752 = s8_751 - work.s7_69*(work.s8_644 - work.s8_750);
  // arb_front_left: arb_front_left, revolute, chassis
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  work.s8_753 = zd_arb_front_left*work.s8_14;
  work.s8_754 = work.s7_177*work.s8_753;
  work.s8_755 = zd_arb_front_left*work.s8_24;
  work.s8_756 = work.s7_186*work.s8_755 + work.s7_184*work.s8_753;
  work.s8_757 = work.s7_178*work.s8_755;
  work.s8_758 = work.zdd_star_arb_front_left*s7_192;
  const double s8_759 = tau[Coordinate::arb_front_left] - work.s8_758 - work.s8_34*work.s7_172;
  const double s8_760 = s8_759 + work.s8_41*work.s7_171 - work.s7_186*(work.s8_106 - work.s8_75);
  const double s8_761 = s8_760 + work.s7_184*(work.s8_107 + work.s8_99);
  work.s8_762 = s8_761 - work.s8_37*(work.s7_191 - work.s7_177) - work.s7_178*s8_605;
  work.s8_763 = work.Rz_arb_front_left_0*work.s8_762;
  work.s8_764 = work.Rz_arb_front_left_2*s7_193;
  const double s8_765 = s8_739 + work.Rz_arb_front_left_2*work.s8_764;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  work.s8_766 = zd_upper_arm_left*work.s8_17;
  work.s8_767 = work.s7_150*work.s8_766;
  work.s8_768 = zd_upper_arm_left*work.s8_24;
  work.s8_769 = work.s7_157*work.s8_766 + work.s7_159*work.s8_768;
  work.s8_770 = work.s7_151*work.s8_768;
  work.s8_771 = work.s6_195*s7_165;
  const double s8_772 = work.s7_157*(work.s8_230 + s8_643) - work.s8_771;
  const double s8_773 = s8_772 - work.s7_159*(s8_638 - s8_640);
  const double s8_774 = s8_773 + work.s8_41*(work.s7_150 - work.s7_164);
  work.s8_775 = s8_774 + work.s7_151*work.s8_647;
  work.s8_776 = work.Rz_arb_front_left_0*s7_193;
  work.s8_777 = work.s3_97*s7_166;
  work.s8_778 = work.Rz_arb_front_left_0*work.s8_776 + work.s3_97*work.s8_777;
  work.s8_779 = work.Rz_upper_arm_left_2*s7_166;
  work.s8_780 = work.Rz_arb_front_left_0*work.s8_764 - work.s3_97*work.s8_779;
  work.s8_781 = s8_765 + work.Rz_upper_arm_left_2*work.s8_779;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s8_782 = work.r_carrier_left_aux1_z*work.s8_41;
  const double s8_783 = s8_637 - work.s6_92 - work.s8_580 + s8_782;
  work.s8_784 = s8_783 - work.r_carrier_left_aux1_y*work.s8_77 - work.s6_128*work.s8_14;
  work.s8_785 = work.s7_130*work.s8_784;
  const double s8_786 = s8_581 + s8_642 - work.s6_95 + work.r_carrier_left_aux1_y*work.s8_41;
  work.s8_787 = s8_786 - work.r_carrier_left_aux1_z*work.s8_79 - work.s6_116*work.s8_14;
  work.s8_788 = work.s7_130*work.s8_787;
  work.s8_789 = work.w_carrier_left_x*work.w_carrier_left_z;
  work.s8_790 = work.w_carrier_left_y*work.w_carrier_left_z;
}

/// Part 6 of compute_accelerations: step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right.
[[gnu::noinline]] void compute_accelerations_6(const State& state, const double* tau,
    AccelerationsWork& __restrict work, Accelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s8_791 = work.zdd_star_carrier_left_ry + work.s4_41;
  const double s8_792 = work.w_carrier_left_x*work.w_carrier_left_y;
  const double s8_793 = s8_791 + s8_792;
  const double s8_794 = work.zdd_star_carrier_left_rx + work.s4_40;
  const double s8_795 = work.s8_789 - s8_794;
  const double s8_796 = s8_792 - s8_791;
  const double s8_797 = work.w_carrier_left_x*work.w_carrier_left_x;
  const double s8_798 = work.w_carrier_left_z*work.w_carrier_left_z;
  const double s8_799 = s8_797 + s8_798;
  const double s8_800 = work.zdd_star_lower_arm_left + work.s4_11;
  const double s8_801 = s8_800 + work.s8_790;
  const double s8_802 = s8_794 + work.s8_789;
  const double s8_803 = work.w_carrier_left_y*work.w_carrier_left_y;
  const double s8_804 = s8_803 + s8_798;
  const double s8_805 = work.s7_132*s8_796 + work.s7_134*s8_802 - work.s7_130*s8_804;
  work.f_carrier_left_x = s8_805 + work.s8_683;
  const double s8_806 = work.s8_502 + work.s7_109*s8_796 + work.s7_125*s8_802;
  const double s8_807 = s8_806 - work.s7_105*s8_801 - work.s7_101*s8_795;
  const double s8_808 = work.s8_790 - s8_800;
  const double s8_809 = work.s7_134*s8_808 + work.s7_130*s8_793 - work.s7_132*s8_799;
  work.f_carrier_left_y = s8_809 + 219.5*work.s8_784;
  const double s8_810 = work.s8_501 + work.s7_103*s8_801 + work.s7_105*s8_795;
  const double s8_811 = s8_810 - work.s7_125*s8_808 - work.s7_107*s8_793;
  const double s8_812 = work.s8_503 + work.s7_107*s8_808 + work.s7_101*s8_793;
  const double s8_813 = s8_812 - work.s7_103*s8_796 - work.s7_109*s8_802 + work.s8_785;
  const double s8_814 = s8_797 + s8_803;
  const double s8_815 = work.s7_132*s8_801 + work.s7_130*s8_795 - work.s7_134*s8_814;
  work.f_carrier_left_z = s8_815 + 219.5*work.s8_787;
  const double s8_816 = work.s8_531 - work.s8_567*work.f_carrier_left_z;
  const double s8_817 = s8_816 + work.s8_564*work.f_carrier_left_y;
  const double s8_818 = s8_811 + work.s7_132*work.s8_787 - work.s7_134*work.s8_784;
  work.n_carrier_left_x = s8_818 + work.s7_109*(s8_799 - s8_814);
  const double s8_819 = work.s5_22 - work.s8_533*work.n_carrier_left_x;
  const double s8_820 = s8_819 - work.s8_536*work.f_carrier_left_y;
  const double s8_821 = s8_820 + work.s8_532*work.f_carrier_left_z;
  const double s8_822 = s8_807 + work.s7_134*work.s8_636 - work.s8_788;
  work.n_carrier_left_y = s8_822 + work.s7_107*(s8_814 - s8_804);
  const double s8_823 = work.n_carrier_left_y - work.s5_25;
  const double s8_824 = work.s3_100*s8_823;
  const double n_carrier_left_z = s8_813 - work.s7_132*work.s8_636 + work.s7_105*(s8_804 - s8_799);
  const double s8_825 = n_carrier_left_z - work.s5_28;
  const double s8_826 = work.s3_99*s8_825;
  const double s8_827 = work.n_carrier_right_z + (work.s8_495 + n_carrier_left_z) + work.s8_600;
  const double s8_828 = s8_827 + work.s8_597 - 4.4*work.s8_599 - 3.25*work.s8_593;
  const double s8_829 = s8_828 + work.zdd_star_arb_front_right*work.s7_174;
  const double s8_830 = s8_829 + work.s7_173*work.s8_22 + work.s8_614 + work.s8_611;
  const double s8_831 = work.r_carrier_right_aux1_y*work.f_carrier_right_x;
  const double s8_832 = s8_830 - work.s8_626 - work.s8_629 - s8_831 - work.s8_744 - work.s8_747;
  const double s8_833 = work.zdd_star_arb_front_left*work.s7_172;
  const double s8_834 = s8_832 + work.s8_757 + work.s8_754 - s8_833 + work.s7_171*work.s8_23;
  const double s8_835 = work.r_carrier_left_aux1_y*work.f_carrier_left_x;
  const double s8_836 = s8_834 - work.s8_767 - work.s8_770 - s8_835;
  work.s8_837 = 395.1 + work.s7_130;
  const double s8_838 = work.s8_709 + work.r_carrier_left_aux1_y*work.s8_837;
  const double s8_839 = work.s8_710 + work.r_carrier_left_aux1_z*work.s8_837;
  const double s8_840 = work.s8_702*(work.r_carrier_left_aux1_y + work.r_carrier_left_aux1_y);
  const double s8_841 = work.s8_712 + s8_840;
  const double s8_842 = work.s8_703*(work.r_carrier_left_aux1_z + work.r_carrier_left_aux1_z);
  const double s8_843 = work.s8_713 + s8_842;
  const double s8_844 = work.s7_143 - work.s7_101;
  const double s8_845 = work.s8_506 + work.s8_533*s8_844 - work.s7_134*work.s8_536;
  const double s8_846 = s8_845 - work.s7_132*work.s8_532;
  const double s8_847 = work.s8_507 + work.Rz_lower_arm_left_2*s8_844 + work.s7_134*work.s8_564;
  const double s8_848 = s8_847 + work.s7_132*work.s8_567;
  const double s8_849 = work.s7_143 - work.s7_103;
  const double s8_850 = work.s8_535 - work.s3_100*s8_849 + work.s7_130*work.s8_532;
  const double s8_851 = work.s8_508 - work.s3_120*s8_849 - work.s7_130*work.s8_567;
  const double s8_852 = work.s7_143 - work.s7_125;
  const double s8_853 = work.s3_100*work.s7_109 - work.s3_99*s8_852 - work.s7_107*work.s8_533;
  const double s8_854 = s8_853 + work.s7_130*work.s8_536;
  const double s8_855 = work.s3_120*work.s7_109 - work.s3_119*s8_852;
  const double s8_856 = s8_855 - work.Rz_lower_arm_left_2*work.s7_107 - work.s7_130*work.s8_564;
  const double s8_857 = work.s8_778 + work.s8_533*s8_846 - work.s3_99*s8_854;
  const double s8_858 = s8_857 - work.s3_100*s8_850 + work.s8_536*work.s8_684;
  const double s8_859 = s8_858 - work.s8_532*work.s8_685;
  const double s8_860 = work.s8_780 + work.s8_533*s8_848 - work.s3_99*s8_856;
  const double s8_861 = s8_860 - work.s3_100*s8_851 - work.s8_536*work.s8_687;
  const double s8_862 = s8_861 - work.s8_532*work.s8_689;
  const double s8_863 = work.s8_781 - work.s3_119*s8_856 - work.s3_120*s8_851;
  const double s8_864 = s8_863 + work.s8_564*work.s8_687 + work.s8_567*work.s8_689;
  const double s8_865 = work.Rz_arb_front_left_0*work.s7_186;
  const double s8_866 = s8_854 - work.Rz_arb_front_left_0*work.s7_172 - 0.45*s8_865;
  const double s8_867 = s8_866 - work.r_carrier_left_aux1_y*work.s8_517;
  const double s8_868 = work.Rz_arb_front_left_2*work.s7_186;
  const double s8_869 = work.Rz_arb_front_right_2*work.s7_190;
  const double s8_870 = work.s3_142*work.s7_211;
  work.s8_871 = s8_870 + (s8_869 + (work.s8_514 + (s8_868 + work.s8_518))) - work.s7_230;
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  work.s8_872 = zd_lower_arm_left*work.s8_17;
  work.s8_873 = zd_lower_arm_left*work.s8_24;
  work.s8_874 = work.s7_65*work.s8_872 + work.s7_67*work.s8_873;
  const double s8_875 = s8_836 - work.s7_58*work.s8_872 - work.s7_59*work.s8_873;
  work.s8_876 = work.zdd_star_lower_arm_left*work.s7_73;
  const double s8_877 = work.s7_230 + (work.s7_161 + (work.s7_69 + (work.s7_65 + work.s7_157)));
  work.s8_878 = 5.25 + s8_877;
  const double s8_879 = work.s8_876 + work.s7_65*(work.s8_750 + work.s8_644);
  const double s8_880 = s8_879 - work.s7_67*(work.s8_639 - work.s8_749);
  const double s8_881 = s8_880 + work.s8_41*(work.s7_58 - work.s7_72) + work.s7_59*work.s8_647;
  const double s8_882 = work.s3_98*work.s7_74;
  const double s8_883 = s8_859 + work.s3_98*s8_882 - work.s8_545;
  const double s8_884 = work.Rz_lower_arm_left_2*work.s7_65;
  const double s8_885 = work.Rz_lower_arm_left_2*work.s7_74;
  const double s8_886 = s8_862 - work.s3_98*s8_885 - work.s8_575;
  const double s8_887 = work.s3_123*work.s7_163;
  const double s8_888 = work.Rz_upper_arm_left_2*work.s7_159;
  const double s8_889 = work.Rz_lower_arm_left_2*work.s7_67;
  work.s8_890 = work.s8_515 - work.s7_228 - s8_887 - s8_888 - work.s8_687 - s8_889;
  const double s8_891 = work.Rz_upper_arm_left_2*work.s7_157;
  const double s8_892 = work.s3_142*work.s7_209;
  const double s8_893 = work.Rz_arb_front_right_2*work.s7_188;
  const double s8_894 = work.s3_123*work.s7_161;
  const double s8_895 = work.s8_516 + (s8_891 + (work.s8_689 + s8_884)) - s8_892 - s8_893;
  const double s8_896 = work.Rz_arb_front_left_2*work.s7_184;
  work.s8_897 = s8_895 - s8_894 - s8_896;
  // arb_link_front_left
  const double s8_898 = 0.3333333333333333*work.s2_226;
  const double s8_899 = work.s8_509 - work.s2_226*s8_898;
  const double s8_900 = s8_838 - work.s2_227*s8_898;
  const double s8_901 = s8_839 - work.s2_229*s8_898;
  const double s8_902 = 0.3333333333333333*work.s2_227;
  const double s8_903 = s8_867 + s8_902*work.s3_105 + s8_898*work.s8_537;
  const double s8_904 = s8_841 - work.s2_227*s8_902;
  const double s8_905 = work.s8_707 - work.s2_229*s8_902;
  const double s8_906 = 0.3333333333333333*work.s2_229;
  const double s8_907 = s8_843 - work.s2_229*s8_906;
  const double s8_908 = work.s8_580 - work.s6_93 + work.s8_41*work.s2_229;
  const double s8_909 = s8_908 + work.s8_34*work.s2_226 - work.s8_77*work.s2_227 + work.s6_130;
  const double s8_910 = work.s2_203*work.zdd_star_carrier_left_ry;
  const double s8_911 = s8_909 + work.s8_24*work.s6_126 - s8_910;
  work.s8_912 = 0.3333333333333333*work.s6_227;
  const double s8_913 = 0.3333333333333333*(s8_911 + work.s2_209*work.zdd_star_lower_arm_left);
  work.s8_914 = work.s2_229*s8_913;
  const double s8_915 = s8_875 + work.s2_227*work.s8_912 - work.s2_226*s8_913;
  const double s8_916 = 0.3333333333333333*work.s8_584;
  const double s8_917 = s8_817 - s8_916*work.s8_570 + work.s8_912*work.s3_135;
  const double s8_918 = s8_917 + s8_913*work.s8_566;
  const double s8_919 = s8_821 - s8_913*work.s8_537 - s8_916*work.s8_539;
  const double s8_920 = s8_919 + work.s8_912*work.s3_105;
  work.s8_921 = work.s2_227*s8_916;
  work.s8_922 = work.s2_226*s8_916;
  // arb_link_front_right
  const double s8_923 = 0.3333333333333333*work.s2_234;
  const double s8_924 = s8_899 - work.s2_234*s8_923;
  const double s8_925 = s8_900 + work.s2_235*s8_923;
  const double s8_926 = s8_901 - work.s2_238*s8_923;
  const double s8_927 = 0.3333333333333333*work.s2_235;
  const double s8_928 = work.s8_742 + s8_923*work.s8_549 - s8_927*work.s3_118;
  const double s8_929 = s8_904 - work.s2_235*s8_927;
  const double s8_930 = s8_905 + work.s2_238*s8_927;
  const double s8_931 = 0.3333333333333333*work.s2_238;
  const double s8_932 = s8_907 - work.s2_238*s8_931;
  work.s8_933 = 0.3333333333333333*work.s6_232;
  const double s8_934 = 0.3333333333333333*work.s6_208;
  work.s8_935 = work.s2_238*s8_934;
  const double s8_936 = s8_915 - work.s2_235*work.s8_933 - work.s2_234*s8_934;
  const double s8_937 = 0.3333333333333333*work.s6_234;
  const double s8_938 = s8_918 - s8_934*work.s3_125 - s8_937*work.s3_140;
  const double s8_939 = s8_938 + work.s8_933*work.s3_138;
  const double s8_940 = work.s8_752 - s8_934*work.s8_549 - s8_937*work.s8_552;
  const double s8_941 = s8_940 + work.s8_933*work.s3_118;
  work.s8_942 = work.s2_235*s8_937;
  work.s8_943 = work.s2_234*s8_937;
  // drag_link
  const double s8_944 = 1.5*work.s2_245;
  const double s8_945 = s8_924 - work.s2_245*s8_944;
  const double s8_946 = s8_925 - work.s2_247*s8_944;
  const double s8_947 = s8_926 - work.s2_250*s8_944;
  const double s8_948 = 1.5*work.s2_247;
  const double s8_949 = s8_929 - work.s2_247*s8_948;
  const double s8_950 = s8_930 - work.s2_250*s8_948;
  const double s8_951 = 1.5*work.s2_250;
  const double s8_952 = s8_932 - work.s2_250*s8_951;
  work.s8_953 = 1.5*work.s6_236;
  const double s8_954 = 1.5*work.s6_159;
  work.s8_955 = work.s2_250*s8_954;
  const double s8_956 = s8_936 + work.s2_247*work.s8_953 - work.s2_245*s8_954;
  const double s8_957 = 1.5*work.s6_237;
  work.s8_958 = work.s2_247*s8_957;
  work.s8_959 = work.s2_245*s8_957;
  const double s8_960 = work.s2_244*work.s3_142;
  const double s8_961 = 1.5*(work.s2_243*work.s2_243 + s8_960*s8_960 + work.s3_143*work.s3_143);
  const double s8_962 = s8_864 - s8_961 - work.s8_579;
  const double s8_963 = s8_948*s8_960;
  const double s8_964 = s8_944*s8_960;
  const double s8_965 = s8_939 - s8_957*s8_960 + work.s8_953*work.s3_143 + work.s2_243*s8_954;
  // tie_rod_left
  const double s8_966 = s8_883 - 1.1666666666666667*work.s8_544;
  // tie_rod_right
  const double s8_967 = work.s8_732 - 1.1666666666666667*work.s8_559;
  work.s8_968 = work.s8_736 - 1.1666666666666667*work.s8_562;
  // tie_rod_left
  const double s8_969 = 1.1666666666666667*work.s2_261;
  const double s8_970 = s8_945 - work.s2_261*s8_969;
  const double s8_971 = s8_946 + work.s2_265*s8_969;
  const double s8_972 = s8_947 - work.s2_268*s8_969;
  const double s8_973 = 1.1666666666666667*work.s2_265;
  const double s8_974 = s8_903 - s8_969*work.s8_541 - s8_973*work.s3_101;
  const double s8_975 = s8_949 - work.s2_265*s8_973;
  const double s8_976 = s8_950 + work.s2_268*s8_973;
  const double s8_977 = 1.1666666666666667*work.s2_268;
  const double s8_978 = s8_952 - work.s2_268*s8_977;
  const double s8_979 = work.s8_580 - work.s6_168 - work.s8_34*work.s2_261;
  const double s8_980 = s8_979 - work.s8_41*work.s2_268 - work.s8_77*work.s2_265 + work.s6_166;
  const double s8_981 = work.s2_252*work.zdd_star_carrier_left_ry;
  const double s8_982 = s8_980 - work.s8_24*work.s6_173 - s8_981;
  work.s8_983 = 1.1666666666666667*work.s6_203;
  const double s8_984 = 1.1666666666666667*(s8_982 + work.s2_254*work.zdd_star_lower_arm_left);
  work.s8_985 = work.s2_268*s8_984;
  const double s8_986 = s8_956 + work.s2_265*work.s8_983 + work.s2_261*s8_984;
  const double s8_987 = 1.1666666666666667*work.s8_587;
  const double s8_988 = s8_920 - s8_984*work.s8_541 - s8_987*work.s8_542;
  const double s8_989 = s8_988 - work.s8_983*work.s3_101;
  work.s8_990 = work.s2_265*s8_987;
  work.s8_991 = work.s2_261*s8_987;
  const double s8_992 = work.s8_564 - work.s2_260 + work.s2_254*work.Rz_lower_arm_left_2;
  const double s8_993 = s8_992 + work.s2_252*work.s3_119;
  work.s8_994 = s8_886 - 1.1666666666666667*(work.s8_574 - work.s8_541*s8_993);
  const double s8_995 = s8_993*s8_993 + work.s8_573*work.s8_573 + work.s3_122*work.s3_122;
  const double s8_996 = s8_995 + work.s3_127*work.s3_127 + work.s3_131*work.s3_131;
  const double s8_997 = 1.1666666666666667*(s8_996 + work.s3_133*work.s3_133);
  const double s8_998 = s8_977*s8_993;
  const double s8_999 = s8_969*s8_993;
  const double s8_1000 = s8_965 - s8_987*work.s8_573 - work.s8_983*work.s3_122 + s8_984*s8_993;
  // tie_rod_right
  const double s8_1001 = 1.1666666666666667*work.s2_274;
  work.s8_1002 = s8_970 - work.s2_274*s8_1001;
  work.s8_1003 = s8_971 + work.s2_275*s8_1001;
  work.s8_1004 = s8_972 + work.s2_278*s8_1001;
  const double s8_1005 = 1.1666666666666667*work.s2_275;
  const double s8_1006 = s8_928 + s8_1005*work.s3_114 + s8_1001*work.s8_555;
  work.s8_1007 = s8_975 - work.s2_275*s8_1005;
  work.s8_1008 = s8_976 - work.s2_278*s8_1005;
  const double s8_1009 = 1.1666666666666667*work.s2_278;
  work.s8_1010 = s8_978 - work.s2_278*s8_1009;
  work.s8_1011 = 1.1666666666666667*work.s6_221;
  const double s8_1012 = 1.1666666666666667*work.s6_212;
  work.s8_1013 = work.s2_278*s8_1012;
  const double s8_1014 = s8_986 + work.s2_275*work.s8_1011 - work.s2_274*s8_1012;
  const double s8_1015 = 1.1666666666666667*work.s6_223;
  const double s8_1016 = s8_1000 - s8_1015*work.s3_131 - work.s8_1011*work.s3_133;
  const double s8_1017 = s8_941 - s8_1012*work.s8_555 - s8_1015*work.s8_557;
  const double s8_1018 = s8_1017 + work.s8_1011*work.s3_114;
  work.s8_1019 = work.s2_275*s8_1015;
  work.s8_1020 = work.s2_274*s8_1015;
  const double s8_1021 = s8_848 + s8_885;
  const double s8_1022 = s8_962 + work.Rz_lower_arm_left_2*s8_1021 - s8_997;
  result.inertia[8] = s8_1022 - 1e-12*s8_1022;
  const double s8_1023 = work.s8_719 + (work.s8_779 + s8_1021) - work.s8_653;
  const double s8_1024 = s8_1023 - work.Rz_arb_front_right_2*work.s7_173 - 0.6*work.s7_228;
  const double s8_1025 = work.r_carrier_right_aux1_y*work.s8_516;
  const double s8_1026 = s8_1024 + work.s2_237*work.s8_515 + s8_1025;
  const double s8_1027 = s8_1026 - work.Rz_arb_front_left_2*work.s7_171;
  const double s8_1028 = s8_1027 + work.r_carrier_left_aux1_z*work.s8_687;
  const double s8_1029 = s8_1028 + work.r_carrier_left_aux1_y*work.s8_689 + 0.4*s8_884;
  const double s8_1030 = s8_1029 - 0.62*s8_889 + s8_906*work.s8_566 + s8_902*work.s8_570;
  const double s8_1031 = s8_1030 - s8_931*work.s3_125 - s8_927*work.s3_140 + work.s2_243*s8_951;
  const double s8_1032 = s8_1031 + s8_963 + s8_973*work.s8_573 - s8_998 - s8_1009*work.s3_127;
  const double s8_1033 = s8_1032 - s8_1005*work.s3_131 + 0.5*(s8_894 + s8_891 - s8_892);
  work.s8_1034 = s8_1033 - 0.28*(s8_887 + s8_888) + 0.45*(s8_893 - s8_896);
  work.s8_1035 = 0.6*work.s7_230;
  const double s8_1036 = work.s8_1035 + (work.s8_623 + (work.s8_724 + (work.s8_764 + s8_851)));
  const double s8_1037 = s8_1036 - work.s8_608 + 4.4*s8_892 - 0.4*s8_870;
  const double s8_1038 = work.r_carrier_left_aux1_z*work.s8_518;
  const double s8_1039 = s8_1037 - work.s2_237*work.s8_514 + s8_1038 - s8_898*work.s8_570;
  const double s8_1040 = s8_1039 - s8_906*work.s3_135 - s8_923*work.s3_140 - s8_931*work.s3_138;
  const double s8_1041 = s8_1040 - s8_964 - s8_951*work.s3_143 + s8_969*work.s8_573;
  const double s8_1042 = s8_1041 - s8_977*work.s3_122 + s8_1009*work.s3_133 - s8_1001*work.s3_131;
  const double s8_1043 = s8_1042 + 3.6*(s8_894 - work.s8_516 - s8_891 - work.s8_689 - s8_884);
  work.s8_1044 = s8_1043 - 0.5*(s8_869 + s8_868) + 3.95*(s8_893 + s8_896);
  const double s8_1045 = work.s8_729 + (work.s7_231 + s8_856) - 3.25*work.s7_228 - 0.5*s8_870;
  const double s8_1046 = s8_1045 + work.Rz_arb_front_right_2*work.s7_174;
  const double s8_1047 = s8_1046 - work.r_carrier_right_aux1_y*work.s8_514;
  const double s8_1048 = s8_1047 - work.Rz_arb_front_left_2*work.s7_172;
  const double s8_1049 = s8_1048 - work.r_carrier_left_aux1_y*work.s8_518 + s8_902*work.s3_135;
  const double s8_1050 = s8_1049 - s8_898*work.s8_566 + s8_923*work.s3_125 - s8_927*work.s3_138;
  const double s8_1051 = s8_1050 + s8_948*work.s3_143 - work.s2_243*s8_944 - s8_973*work.s3_122;
  const double s8_1052 = s8_1051 + s8_999 - s8_1005*work.s3_133 - s8_1001*work.s3_127;
  const double s8_1053 = s8_1052 + 3.6*(work.s8_515 - s8_887 - s8_888 - work.s8_687 - s8_889);
  work.s8_1054 = s8_1053 + 0.45*(s8_869 - s8_868);
  const double tau_lower_arm_left = tau[Coordinate::lower_arm_left];
  const double s8_1055 = tau_lower_arm_left - work.n_carrier_left_x - s8_881;
  const double s8_1056 = s8_1016 + s8_1012*work.s3_127 + work.Rz_lower_arm_left_2*s8_1055;
  const double tau_upper_arm_left = tau[Coordinate::upper_arm_left];
  const double s8_1057 = work.Rz_upper_arm_left_2*(tau_upper_arm_left - work.s8_775);
  const double s8_1058 = s8_1056 + work.s8_34*(work.s7_224 - work.s7_222) + s8_1057;
  const double s8_1059 = s8_1058 + work.s3_119*s8_825 + work.s3_120*s8_823;
  const double s8_1060 = work.Rz_carrier_right_rz_2*(work.s5_36 - work.n_carrier_right_x);
  const double s8_1061 = s8_1059 + work.s3_123*work.s8_649 + s8_1060;
  const double s8_1062 = s8_1061 + work.Rz_carrier_right_ry_2*work.s8_698;
  const double s8_1063 = s8_1062 + work.Rz_carrier_right_rx_2*work.s8_695;
  const double s8_1064 = s8_1063 + work.Rz_arb_front_left_2*work.s8_762;
  work.s8_1065 = work.s8_77 - work.s8_54;
  const double s8_1066 = s8_1064 + work.Rz_arb_front_right_2*work.s8_619 + work.s8_607;
  work.s8_1067 = s8_1066 + work.s7_225*work.s8_1065;
  work.s8_1068 = 1.0/s8_1022;
  const double s8_1069 = work.s8_994*work.s8_1068;
  const double s8_1070 = work.s8_968*work.s8_1068;
  const double s8_1071 = s8_967 - work.s8_968*s8_1070;
  result.inertia[7] = s8_1071 - 1e-12*s8_967;
  work.s8_1072 = work.s8_994*s8_1070;
  work.s8_1073 = work.s8_740 + work.s8_513 - work.s8_871*s8_1070;
  const double s8_1074 = work.s3_107*work.s7_163;
  const double s8_1075 = work.s7_71 + work.s8_681 - s8_1074;
  work.s8_1076 = s8_1075 - work.s8_890*s8_1070;
  work.s8_1077 = s8_1006 - work.s8_1054*s8_1070 + 3.6*s8_1075;
  const double s8_1078 = work.Rz_arb_front_right_1*work.s7_188;
  const double s8_1079 = work.s3_107*work.s7_161;
  work.s8_1080 = work.s7_69 + work.s8_682 - s8_1078 - s8_1079 - work.s8_897*s8_1070;
  const double s8_1081 = work.s8_717 + work.s7_195 - work.s8_651 + 0.45*s8_1078;
  const double s8_1082 = s8_1081 - work.Rz_arb_front_right_1*work.s7_173 + 0.5*s8_1079;
  const double s8_1083 = s8_1082 - 0.28*s8_1074 + work.s2_237*work.s8_681;
  const double s8_1084 = s8_1083 + work.r_carrier_right_aux1_y*work.s8_682 + 0.62*work.s7_71;
  const double s8_1085 = s8_1084 - 0.4*work.s7_69 - s8_931*work.s8_549 - s8_927*work.s8_552;
  const double s8_1086 = s8_1085 + s8_1009*work.s8_555 - s8_1005*work.s8_557;
  work.s8_1087 = s8_1086 - work.s8_1034*s8_1070;
  const double s8_1088 = work.s8_621 + work.s8_722 + 3.95*s8_1078 - 0.5*work.s8_740;
  const double s8_1089 = s8_1088 - work.s2_237*work.s8_513 - s8_923*work.s8_552;
  const double s8_1090 = s8_1089 - s8_931*work.s3_118 - s8_1001*work.s8_557 - s8_1009*work.s3_114;
  const double s8_1091 = 3.6*(s8_1079 - work.s8_682 - work.s7_69);
  work.s8_1092 = s8_1090 - work.s8_1044*s8_1070 + s8_1091;
  const double s8_1093 = s8_1018 - work.s8_1067*s8_1070 + work.s8_41*(work.s7_194 - work.s7_62);
  work.s8_1094 = work.s8_79 - work.s8_77;
  const double s8_1095 = s8_1093 + work.s8_650 + work.s8_699 + work.s8_696 + work.s8_620;
  work.s8_1096 = s8_1095 + work.s7_63*work.s8_1094;
  work.s8_1097 = 1.0/s8_1071;
  const double s8_1098 = work.s8_1072*work.s8_1097;
  const double s8_1099 = s8_966 - work.s8_994*s8_1069 - work.s8_1072*s8_1098;
  result.inertia[6] = s8_1099 - 1e-12*s8_966;
  work.s8_1100 = s8_865 + work.s8_517 - work.s8_871*s8_1069 + work.s8_1073*s8_1098;
  const double s8_1101 = work.s3_97*work.s7_159;
  const double s8_1102 = work.s3_98*work.s7_67;
  const double s8_1103 = work.s8_684 + (s8_1101 + s8_1102);
  work.s8_1104 = s8_1103 - work.s8_890*s8_1069 + work.s8_1076*s8_1098;
  work.s8_1105 = s8_974 - work.s8_1054*s8_1069 + work.s8_1077*s8_1098 + 3.6*s8_1103;
  const double s8_1106 = work.Rz_arb_front_left_0*work.s7_184;
  const double s8_1107 = work.s3_97*work.s7_157;
  const double s8_1108 = work.s3_98*work.s7_65;
  const double s8_1109 = work.s8_685 - s8_1106 - s8_1107 - s8_1108 - work.s8_897*s8_1069;
  work.s8_1110 = s8_1109 + work.s8_1080*s8_1098;
  const double s8_1111 = s8_846 - work.s8_777 - s8_882 + 0.28*s8_1101 - 0.5*s8_1107;
  const double s8_1112 = s8_1111 - work.Rz_arb_front_left_0*work.s7_171 - 0.45*s8_1106;
  const double s8_1113 = s8_1112 + work.r_carrier_left_aux1_y*work.s8_685;
  const double s8_1114 = s8_1113 - work.r_carrier_left_aux1_z*work.s8_684 + 0.62*s8_1102;
  const double s8_1115 = s8_1114 - 0.4*s8_1108 + s8_902*work.s8_539 - s8_906*work.s8_537;
  const double s8_1116 = s8_1115 + s8_977*work.s8_541 + s8_973*work.s8_542 - work.s8_1034*s8_1069;
  work.s8_1117 = s8_1116 + work.s8_1087*s8_1098;
  const double s8_1118 = work.s8_776 + s8_850 + 3.95*s8_1106 - 0.5*s8_865;
  const double s8_1119 = s8_1118 + work.r_carrier_left_aux1_z*work.s8_517 - s8_898*work.s8_539;
  const double s8_1120 = s8_1119 - s8_906*work.s3_105 + s8_969*work.s8_542 - s8_977*work.s3_101;
  const double s8_1121 = s8_1120 - work.s8_1044*s8_1069 + work.s8_1092*s8_1098;
  work.s8_1122 = s8_1121 + 3.6*(s8_1107 + s8_1108 - work.s8_685);
  const double s8_1123 = s8_989 - work.s8_1067*s8_1069 + work.s8_1096*s8_1098;
  const double s8_1124 = s8_1123 + work.s3_97*(work.s8_775 - tau_upper_arm_left);
  const double s8_1125 = s8_1124 + work.s3_98*(s8_881 - tau_lower_arm_left) + s8_826 + s8_824;
  work.s8_1126 = s8_1125 + work.s8_763;
  work.s8_1127 = 1.0/s8_1099;
  const double s8_1128 = work.s8_1100*work.s8_1127;
  work.s8_1129 = work.s8_1126*s8_1128;
  const double s8_1130 = work.s8_1104*work.s8_1127;
  work.s8_1131 = work.s8_1126*s8_1130;
  const double s8_1132 = work.s8_1110*work.s8_1127;
  work.s8_1133 = work.s8_1126*s8_1132;
  const double s8_1134 = work.s8_1117*work.s8_1127;
  work.s8_1135 = work.s8_1126*s8_1134;
  const double s8_1136 = work.s8_1122*work.s8_1127;
  work.s8_1137 = work.s8_478 + work.s8_1105*s8_1136;
  work.s8_1138 = work.s8_1126*s8_1136;
  const double s8_1139 = work.s8_1105*work.s8_1127;
  work.s8_1140 = work.s8_480 + work.s8_1105*s8_1139;
  work.s8_1141 = s8_1014 + work.s8_1126*s8_1139;
  const double s8_1142 = work.s8_1073*work.s8_1097;
  work.s8_1143 = work.s8_454 + work.s8_1100*s8_1128 + work.s8_1073*s8_1142;
  work.s8_1144 = work.s8_455 + work.s8_1104*s8_1128 + work.s8_1076*s8_1142;
  work.s8_1145 = work.s8_456 + work.s8_1110*s8_1128 + work.s8_1080*s8_1142;
  work.s8_1146 = work.s8_457 + work.s8_1117*s8_1128 + work.s8_1087*s8_1142;
  work.s8_1147 = work.s8_458 + work.s8_1122*s8_1128 + work.s8_1092*s8_1142;
  work.s8_1148 = work.s8_459 + work.s8_1105*s8_1128 + work.s8_1077*s8_1142;
  work.s8_1149 = work.s8_1096*s8_1142;
  const double s8_1150 = work.s8_1076*work.s8_1097;
  work.s8_1151 = work.s8_461 + work.s8_1104*s8_1130 + work.s8_1076*s8_1150;
  work.s8_1152 = work.s8_462 + work.s8_1110*s8_1130 + work.s8_1080*s8_1150;
  work.s8_1153 = work.s8_463 + work.s8_1117*s8_1130 + work.s8_1087*s8_1150;
  work.s8_1154 = work.s8_464 + work.s8_1122*s8_1130 + work.s8_1092*s8_1150;
  work.s8_1155 = work.s8_465 + work.s8_1105*s8_1130 + work.s8_1077*s8_1150;
  work.s8_1156 = work.s8_1096*s8_1150;
  const double s8_1157 = work.s8_1080*work.s8_1097;
  work.s8_1158 = work.s8_467 + work.s8_1110*s8_1132 + work.s8_1080*s8_1157;
  work.s8_1159 = work.s8_468 + work.s8_1117*s8_1132 + work.s8_1087*s8_1157;
  work.s8_1160 = work.s8_469 + work.s8_1122*s8_1132 + work.s8_1092*s8_1157;
  work.s8_1161 = work.s8_470 + work.s8_1105*s8_1132 + work.s8_1077*s8_1157;
  work.s8_1162 = work.s8_1096*s8_1157;
  const double s8_1163 = work.s8_1087*work.s8_1097;
  work.s8_1164 = work.s8_472 + work.s8_1117*s8_1134 + work.s8_1087*s8_1163;
  work.s8_1165 = work.s8_473 + work.s8_1122*s8_1134 + work.s8_1092*s8_1163;
  work.s8_1166 = work.s8_474 + work.s8_1105*s8_1134 + work.s8_1077*s8_1163;
  work.s8_1167 = work.s8_1096*s8_1163;
  work.s8_1168 = work.s8_1092*work.s8_1097;
  work.s8_1169 = work.s8_477 + work.s8_1122*s8_1136 + work.s8_1092*work.s8_1168;
  work.s8_1170 = work.s8_1077*work.s8_1168;
}

/// Part 7 of compute_accelerations: step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63); step 9:
/// accelerations from the root to the leaves (63), (62).
[[gnu::noinline]] void compute_accelerations_7(const State& state, const double* tau,
    AccelerationsWork& __restrict work, Accelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  const double s8_1171 = work.s8_1077*work.s8_1097;
  const double s8_1172 = work.s8_871*work.s8_1068;
  const double s8_1173 = work.s8_1143 + work.s8_871*s8_1172;
  const double s8_1174 = work.s8_1144 + work.s8_890*s8_1172;
  const double s8_1175 = work.s8_1145 + work.s8_897*s8_1172;
  const double s8_1176 = work.s8_1146 + work.s8_1034*s8_1172;
  const double s8_1177 = work.s8_1147 + work.s8_1044*s8_1172;
  const double s8_1178 = work.s8_890*work.s8_1068;
  const double s8_1179 = work.s8_1151 + work.s8_890*s8_1178;
  const double s8_1180 = work.s8_1152 + work.s8_897*s8_1178;
  const double s8_1181 = work.s8_1153 + work.s8_1034*s8_1178;
  const double s8_1182 = work.s8_1154 + work.s8_1044*s8_1178;
  const double s8_1183 = work.s8_1155 + work.s8_1054*s8_1178;
  const double s8_1184 = work.s8_897*work.s8_1068;
  const double s8_1185 = work.s8_1158 + work.s8_897*s8_1184;
  const double s8_1186 = work.s8_1160 + work.s8_1044*s8_1184;
  const double s8_1187 = work.s8_1161 + work.s8_1054*s8_1184;
  const double s8_1188 = work.s8_1034*work.s8_1068;
  const double s8_1189 = work.s8_1164 + work.s8_1034*s8_1188;
  const double s8_1190 = work.s8_1165 + work.s8_1044*s8_1188;
  const double s8_1191 = work.s8_1166 + work.s8_1054*s8_1188;
  const double s8_1192 = work.s8_1044*work.s8_1068;
  const double s8_1193 = work.s8_1169 + work.s8_1044*s8_1192;
  const double s8_1194 = work.s8_1137 + work.s8_1170 + work.s8_1054*s8_1192;
  const double s8_1195 = work.s8_1054*work.s8_1068;
  const double s8_1196 = work.s8_1140 + work.s8_1077*s8_1171 + work.s8_1054*s8_1195;
  const double s8_1197 = 17.775000000000002 + work.s7_188;
  const double s8_1198 = 17.775000000000002 + work.s7_184;
  const double s8_1199 = s8_1197 + s8_1198;
  const double s8_1200 = work.s8_119 + (work.s7_207 + (work.s7_177 + work.s7_181));
  const double s8_1201 = 1037.4 + (work.s7_222 + s8_1200) + work.s8_595 + work.s8_603;
  const double s8_1202 = s8_1201 + 7.9*s8_1199;
  const double s8_1203 = work.s7_69 - 5.0;
  const double s8_1204 = 5.0 + work.s7_65;
  const double s8_1205 = 3.75 + work.s7_157;
  const double s8_1206 = work.s7_154 + (work.s7_62 + (work.s7_150 + (work.s7_58 + s8_1205)));
  const double s8_1207 = work.s7_161 - 3.75;
  const double s8_1208 = 12.851799999999999 + (work.s7_224 + s8_1206 - s8_1207);
  const double s8_1209 = s8_1208 + 0.8*(s8_1204 - s8_1203);
  const double s8_1210 = 2.1 + work.s7_163;
  const double s8_1211 = work.s7_159 - 2.1;
  const double s8_1212 = 7.75 + work.s7_71;
  const double s8_1213 = work.s7_67 - 7.75;
  const double s8_1214 = work.s7_199 + (work.s7_194 + (work.s7_191 + (work.s7_72 + work.s7_164)));
  const double s8_1215 = work.s7_190 - 2.25;
  const double s8_1216 = work.s7_226 + (work.s8_123 + (work.s7_215 + (work.s7_202 + s8_1214)));
  const double s8_1217 = work.s7_186 - 2.25;
  const double s8_1218 = 2.1 + work.s7_211;
  const double s8_1219 = 7.380000000000001 + (s8_1216 - s8_1215 - s8_1217) + 0.8*s8_1218;
  const double s8_1220 = s8_1219 + 0.56*(s8_1210 - s8_1211) + 1.24*(s8_1212 - s8_1213);
  const double s8_1221 = 11.55 + (work.s7_225 + (work.s8_124 + (work.s7_171 + work.s7_173)));
  const double s8_1222 = 3.6*(s8_1203 + (s8_1207 + (s8_1205 + s8_1204)));
  const double s8_1223 = s8_1221 + 3.25*work.s7_230 + 0.5*work.s8_602 + s8_1222;
  const double s8_1224 = s8_1223 + 0.45*(s8_1198 - s8_1197);
  const double s8_1225 = work.s7_208 + (work.s8_126 + (work.s7_178 + work.s7_182)) - 90.9075;
  const double s8_1226 = s8_1225 - 4.4*s8_1218 - 0.4*work.s8_602 - 0.6*work.s8_594;
  const double s8_1227 = s8_1226 + 3.6*(s8_1211 + s8_1213 - s8_1210 - s8_1212) - 0.5*s8_1199;
  const double s8_1228 = s8_1227 + 3.95*(s8_1215 + s8_1217);
  const double s8_1229 = work.s7_155 + (work.s7_63 + (work.s7_172 + (work.s7_59 + work.s7_151)));
  const double s8_1230 = work.s8_127 + s8_1229 - work.s7_174 - work.s8_1035 - 1.05;
  const double s8_1231 = s8_1230 + 0.5*(s8_1210 + s8_1211 - s8_1218) + 0.4*(s8_1212 + s8_1213);
  const double s8_1232 = s8_1231 - 0.62*(s8_1203 + s8_1204) - 0.28*(s8_1207 + s8_1205);
  const double s8_1233 = s8_1232 + 0.45*(s8_1217 - s8_1215);
  const double s8_1234 = work.s8_128 + (work.s7_184 + work.s7_188) - work.s7_228 - work.s7_209;
  const double s8_1235 = 471.925 + s8_1234;
  const double s8_1236 = work.s7_190 + (work.s7_186 + (work.s7_67 + work.s7_159)) - work.s7_211;
  const double s8_1237 = s8_1236 - work.s7_163 - work.s7_71 - work.s8_129 - 64.9;
  const double s8_1238 = work.s8_1002 + 7.2*(work.s8_708 + work.s8_837);
  const double s8_1239 = work.s8_1003 + 3.6*(work.s8_700 + work.s8_702);
  const double s8_1240 = work.s8_1004 + 3.6*(work.s8_701 + work.s8_703);
  const double s8_1241 = 1580.4 + work.s8_519;
  const double s8_1242 = 219.5*(work.r_carrier_left_aux1_y + work.r_carrier_right_aux1_y);
  const double s8_1243 = work.s8_878 + (work.s8_520 + s8_1242);
  const double s8_1244 = work.s8_1148 + work.s8_1054*s8_1172 + s8_1243;
  const double s8_1245 = s8_1243 - (work.s8_1159 + work.s8_1034*s8_1184);
  const double s8_1246 = work.s8_521 + 219.5*(work.r_carrier_left_aux1_z - work.s2_237);
  const double s8_1247 = work.s8_528 + (work.s8_769 + (work.f_carrier_left_x + work.s8_874));
  const double s8_1248 = work.s8_628 + (work.f_carrier_right_x + (work.s8_746 + s8_1247));
  const double s8_1249 = work.s7_228*work.s8_33;
  const double s8_1250 = s8_1249 + (work.s8_485 + (work.s7_212 + (work.s8_526 + s8_1248)));
  const double s8_1251 = s8_1250 + work.s8_1129 + work.s8_1149 + work.s8_1067*s8_1172;
  const double s8_1252 = work.s7_2 - s8_1251 - work.s8_34*work.s8_878;
  const double s8_1253 = work.s8_524 + work.f_carrier_left_y;
  const double s8_1254 = work.s8_487 + (work.f_carrier_right_y + (work.s8_756 + s8_1253));
  const double s8_1255 = work.s7_69*work.s6_100;
  const double s8_1256 = work.s8_613 + s8_1254 - work.s8_593 - work.s8_599 - work.s8_522;
  const double s8_1257 = s8_1256 - s8_1255 - work.s8_504 + work.s8_1131 + work.s8_1156;
  const double s8_1258 = work.s7_4 - (s8_1257 + work.s8_1067*s8_1178);
  const double s8_1259 = work.s8_748 + (work.f_carrier_left_z + work.s8_505);
  const double s8_1260 = work.s7_213 + (work.s8_523 + (work.f_carrier_right_z + s8_1259));
  const double s8_1261 = work.s8_591 + (work.s8_489 + s8_1260) - work.s8_527 - work.s8_529;
  const double s8_1262 = s8_1261 - work.s8_525 + work.s8_1133 + work.s8_1162;
  const double s8_1263 = work.s7_6 - (s8_1262 + work.s8_1067*s8_1184) - work.s8_41*work.s8_878;
  const double s8_1264 = work.s8_613 + (work.s7_213 + work.s8_756) - work.s8_523 - work.s8_525;
  const double s8_1265 = work.n_carrier_right_x + (work.n_carrier_left_x + work.s8_876);
  const double s8_1266 = work.s8_491 + s8_1265 - work.s8_630 - work.s8_771;
  const double s8_1267 = s8_1266 + work.s7_224*work.s8_590 + work.s7_225*work.s8_588;
  const double s8_1268 = s8_1267 - 0.6*work.s8_593 - work.s7_215*work.s8_598;
  const double s8_1269 = s8_1268 - work.s7_208*work.s8_596 + work.s7_174*work.s8_22;
  const double s8_1270 = s8_1269 - work.zdd_star_arb_front_right*work.s7_173;
  const double s8_1271 = s8_1270 - work.s7_202*work.s8_612 - work.s7_182*work.s8_610;
  const double s8_1272 = work.r_carrier_right_aux1_y*work.f_carrier_right_z;
  const double s8_1273 = s8_1271 + work.s2_237*work.f_carrier_right_y + s8_1272;
  const double s8_1274 = s8_1273 - work.s7_191*work.s8_755 - work.s7_178*work.s8_753;
  const double s8_1275 = work.zdd_star_arb_front_left*work.s7_171;
  const double s8_1276 = work.r_carrier_left_aux1_y*work.f_carrier_left_z;
  const double s8_1277 = s8_1274 - work.s7_172*work.s8_23 - s8_1275 + s8_1276;
  const double s8_1278 = s8_1277 - work.r_carrier_left_aux1_z*work.f_carrier_left_y + work.s8_914;
  const double s8_1279 = s8_1278 - work.s8_921 + work.s8_935 + work.s8_942 + work.s8_955;
  const double s8_1280 = s8_1279 - work.s8_958 - work.s8_985 - work.s8_990 + work.s8_1019;
  const double s8_1281 = s8_1280 - work.s8_1013 + work.s8_1135 + work.s8_1167;
  const double s8_1282 = 0.4*(work.s8_505 - work.s8_599 - work.s8_748);
  const double s8_1283 = s8_1281 + work.s8_1067*s8_1188 + 0.5*s8_1264 + s8_1282;
  const double s8_1284 = s8_1283 - 0.62*(s8_1255 + work.s8_504);
  const double s8_1285 = s8_1284 + 0.28*(work.s8_524 - work.s8_522);
  const double s8_1286 = s8_1285 + 0.45*(work.s8_527 - work.s8_529);
  const double s8_1287 = tau[Coordinate::chassis_rx]*work.s5_7 - s8_1286;
  const double s8_1288 = work.s8_525 - work.s8_523 - work.f_carrier_right_z - work.s8_748;
  const double s8_1289 = work.n_carrier_right_y + (work.s8_758 + work.n_carrier_left_y);
  const double s8_1290 = work.s8_615 + (work.s8_494 + s8_1289) - work.s8_601 - work.s8_592;
  const double s8_1291 = s8_1290 - work.s8_589 - 3.25*work.s8_591 - 0.6*s8_1249 - 4.4*work.s7_213;
  const double s8_1292 = s8_1291 - 0.4*work.s7_212 + work.s7_155*work.s8_625;
  const double s8_1293 = s8_1292 + work.s7_199*work.s8_627 - work.s2_237*work.f_carrier_right_x;
  const double s8_1294 = s8_1293 + work.s7_63*work.s8_743 + work.s7_194*work.s8_745;
  const double s8_1295 = s8_1294 + work.s7_151*work.s8_766 + work.s7_164*work.s8_768;
  const double s8_1296 = s8_1295 + work.r_carrier_left_aux1_z*work.f_carrier_left_x;
  const double s8_1297 = s8_1296 + work.s7_59*work.s8_872 + work.s7_72*work.s8_873 + work.s8_922;
  const double s8_1298 = s8_1297 - work.s2_229*work.s8_912 + work.s8_943;
  const double s8_1299 = s8_1298 - work.s2_238*work.s8_933 + work.s8_959;
  const double s8_1300 = s8_1299 - work.s2_250*work.s8_953 - work.s8_991;
  const double s8_1301 = s8_1300 + work.s2_268*work.s8_983 + work.s8_1020;
  const double s8_1302 = s8_1301 - work.s2_278*work.s8_1011 + work.s8_1138;
  const double s8_1303 = s8_1302 + work.s8_1096*work.s8_1168 + work.s8_1067*s8_1192;
  const double s8_1304 = s8_1303 + 3.6*(s8_1288 - work.f_carrier_left_z - work.s8_505);
  const double s8_1305 = s8_1304 - 0.62*(work.s8_746 + work.s8_874);
  const double s8_1306 = s8_1305 - 0.5*(work.s8_526 + work.s8_528);
  const double s8_1307 = s8_1306 - 0.28*(work.s8_628 + work.s8_769);
  const double s8_1308 = work.s5_11 - (s8_1307 + 3.95*(work.s8_527 + work.s8_529));
  const double s8_1309 = work.f_carrier_right_y + s8_1253 - work.s8_522 - s8_1255 - work.s8_504;
  const double s8_1310 = work.s8_1141 + work.s8_1096*s8_1171 + work.s8_1067*s8_1195 + 3.6*s8_1309;
  const double s8_1311 = s8_1310 + 0.5*(work.s8_628 - work.s7_212 - work.s8_769);
  const double s8_1312 = s8_1311 + 0.4*(work.s8_746 - work.s8_874);
  const double s8_1313 = s8_1312 + 3.95*(work.s8_613 + work.s8_756);
  const double s8_1314 = work.s5_15 - (s8_1313 + 0.45*(work.s8_526 - work.s8_528));
  // operations: 1122 add, 963 multiply, 3 divide

  // --- step 8: elimination from the leaves to the root (63), continued ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s8_1315 = 140092.31999999998 + s8_1202;
  const double s8_1316 = s8_1238 + s8_1315;
  const double s8_1317 = 5008.005000000032 + s8_1209;
  const double s8_1318 = work.s8_1007 + s8_1317;
  const double s8_1319 = 10849.555000000006 + s8_1220;
  const double s8_1320 = work.s8_1010 + s8_1319;
  const double s8_1321 = 4.440892098500626e-16 + s8_1224;
  const double s8_1322 = 19.919999999999998 + s8_1228;
  const double s8_1323 = s8_1191 + (s8_1240 + s8_1322);
  const double s8_1324 = s8_1233 - 1.1102230246251565e-16;
  const double s8_1325 = s8_1194 + (work.s8_1008 + s8_1324);
  const double s8_1326 = s8_1235 - 56.0;
  const double s8_1327 = s8_1241 + s8_1326;
  const double s8_1328 = s8_1327 - s8_1183;
  const double s8_1329 = 3362.7 + s8_1237;
  const double s8_1330 = s8_1246 + s8_1329;
  const double s8_1331 = s8_1258 - work.s8_41*s8_1329 - work.s8_34*s8_1326;
  const double s8_1332 = s8_1320 + (s8_1316 + s8_1318);
  const double s8_1333 = 15306.0 - s8_1173;
  const double s8_1334 = 15306.0 - s8_1179;
  const double s8_1335 = 15306.0 - s8_1185;
  const double s8_1336 = s8_1332 - s8_1316 - s8_1189;
  const double s8_1337 = s8_1332 - s8_1318 - s8_1193;
  const double s8_1338 = s8_1332 - s8_1320 - s8_1196;
  result.inertia[5] = s8_1338 - 1e-12*s8_1338;
  const double s8_1339 = s8_1314 - work.s8_41*s8_1322 + work.s8_37*s8_1324;
  const double s8_1340 = s8_1339 + work.s8_34*(s8_1317 - s8_1315) + work.s8_1065*s8_1321;
  const double s8_1341 = 1.0/s8_1338;
  const double s8_1342 = s8_1244*s8_1341;
  const double s8_1343 = s8_1328*s8_1341;
  const double s8_1344 = s8_1187*s8_1341;
  const double s8_1345 = s8_1323*s8_1341;
  const double s8_1346 = s8_1325*s8_1341;
  const double s8_1347 = s8_1330 - s8_1177 - s8_1244*s8_1346;
  const double s8_1348 = s8_1328*s8_1346 - s8_1182;
  const double s8_1349 = s8_1186 + s8_1327 + s8_1187*s8_1346;
  const double s8_1350 = s8_1190 + (s8_1239 + s8_1321) + s8_1323*s8_1346;
  const double s8_1351 = s8_1337 - s8_1325*s8_1346;
  const double s8_1352 = s8_1351 - 1e-12*s8_1337;
  const double s8_1353 = s8_1308 - work.s8_34*s8_1324 + work.s8_41*s8_1321 + s8_1340*s8_1346;
  const double s8_1354 = s8_1353 + work.s8_37*(s8_1315 - s8_1319) + work.s8_413*s8_1322;
  const double s8_1355 = 1.0/s8_1351;
  const double s8_1356 = s8_1347*s8_1355;
  const double s8_1357 = s8_1252 - work.s8_37*s8_1329 + work.s8_54*s8_1326 + s8_1340*s8_1342;
  const double s8_1358 = s8_1348*s8_1355;
  const double s8_1359 = s8_1349*s8_1355;
  const double s8_1360 = s8_1263 - work.s8_37*s8_1326 + work.s8_79*s8_1329 + s8_1340*s8_1344;
  const double s8_1361 = s8_1350*s8_1355;
  const double s8_1362 = s8_1347*s8_1361 - s8_1176 - s8_1244*s8_1345;
  const double s8_1363 = s8_1328*s8_1345 - s8_1181 - s8_1330 + s8_1348*s8_1361;
  const double s8_1364 = s8_1245 - s8_1187*s8_1345 - s8_1349*s8_1361;
  const double s8_1365 = s8_1336 - s8_1323*s8_1345 - s8_1350*s8_1361;
  const double s8_1366 = s8_1287 - work.s8_37*s8_1321 + work.s8_34*s8_1322 + s8_1340*s8_1345;
  result.inertia[3] = s8_1365 - 1e-12*s8_1336;
  const double s8_1367 = s8_1366 + s8_1354*s8_1361 + work.s8_41*(s8_1319 - s8_1317);
  const double s8_1368 = s8_1367 + work.s8_1094*s8_1324;
  const double s8_1369 = 1.0/s8_1365;
  const double s8_1370 = s8_1362*s8_1369;
  const double s8_1371 = s8_1363*s8_1369;
  const double s8_1372 = s8_1331 + work.s8_77*work.s8_878 - s8_1340*s8_1343 - s8_1354*s8_1358;
  const double s8_1373 = s8_1364*s8_1369;
  const double s8_1374 = s8_1347*s8_1359 - s8_1175 - s8_1244*s8_1344 - s8_1362*s8_1373;
  const double s8_1375 = s8_1328*s8_1344 - s8_1180 + s8_1348*s8_1359 - s8_1363*s8_1373;
  const double s8_1376 = s8_1335 - s8_1187*s8_1344 - s8_1349*s8_1359 - s8_1364*s8_1373;
  const double s8_1377 = s8_1360 + s8_1354*s8_1359 - s8_1368*s8_1373;
  result.inertia[2] = s8_1376 - 1e-12*s8_1335;
  const double s8_1378 = 1.0/s8_1376;
  const double s8_1379 = s8_1374*s8_1378;
  const double s8_1380 = s8_1333 - s8_1244*s8_1342 - s8_1347*s8_1356 - s8_1362*s8_1370;
  const double s8_1381 = s8_1375*s8_1378;
  const double s8_1382 = s8_1244*s8_1343 - s8_1174 - s8_1347*s8_1358 - s8_1362*s8_1371;
  const double s8_1383 = s8_1382 - s8_1374*s8_1381;
  const double s8_1384 = s8_1334 - s8_1328*s8_1343 - s8_1348*s8_1358 - s8_1363*s8_1371;
  const double s8_1385 = s8_1384 - s8_1375*s8_1381;
  const double s8_1386 = s8_1372 - s8_1368*s8_1371 - s8_1377*s8_1381;
  result.inertia[1] = s8_1385 - 1e-12*s8_1334;
  const double s8_1387 = 1.0/s8_1385;
  const double s8_1388 = s8_1383*s8_1387;
  const double s8_1389 = s8_1380 - s8_1374*s8_1379 - s8_1383*s8_1388;
  const double s8_1390 = s8_1357 - s8_1354*s8_1356 - s8_1368*s8_1370 - s8_1377*s8_1379;
  const double s8_1391 = s8_1390 - s8_1386*s8_1388;
  result.inertia[0] = s8_1389 - 1e-12*s8_1333;
  const double s8_1392 = 1.0/s8_1389;
  // operations: 122 add, 111 multiply, 6 divide

  // --- step 9: accelerations from the root to the leaves (63), (62), continued ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double a_chassis_x = s8_1391*s8_1392;
  const double s1_4 = work.sines[1];
  const double s9_2 = a_chassis_x + 9.81*s1_4;
  const double a_chassis_y = s8_1387*(s8_1386 - s8_1383*a_chassis_x);
  const double s9_3 = a_chassis_y - 9.81*work.R_chassis_z_y;
  const double a_chassis_z = s8_1378*(s8_1377 - s8_1374*a_chassis_x - s8_1375*a_chassis_y);
  const double s9_4 = s8_1368 - s8_1362*a_chassis_x - s8_1363*a_chassis_y;
  const double s9_5 = s8_1354 - s8_1347*a_chassis_x - s8_1348*a_chassis_y;
  const double s9_6 = s8_1340 + s8_1244*a_chassis_x - s8_1328*a_chassis_y;
  const double s9_7 = a_chassis_z - 9.81*work.R_chassis_z_z;
  const double s9_8 = work.R_chassis_x_y*s9_3 + work.R_chassis_x_z*s9_7;
  result.zdd[Coordinate::chassis_tx] = s9_8 + work.R_chassis_aux5_x_x*s9_2;
  const double s9_9 = work.R_chassis_y_y*s9_3 + work.R_chassis_y_z*s9_7;
  result.zdd[Coordinate::chassis_ty] = s9_9 + work.R_chassis_aux5_y_x*s9_2;
  result.zdd[Coordinate::chassis_tz] = work.R_chassis_z_y*s9_3 + work.R_chassis_z_z*s9_7 -
      s1_4*s9_2;
  const double alpha_chassis_x = s8_1369*(s9_4 - s8_1364*a_chassis_z);
  const double alpha_chassis_y = s8_1355*(s9_5 + s8_1349*a_chassis_z + s8_1350*alpha_chassis_x);
  const double s9_10 = s9_6 + s8_1187*a_chassis_z + s8_1323*alpha_chassis_x;
  const double zd_chassis_rx = state.zd[Coordinate::chassis_rx];
  const double s9_11 = alpha_chassis_y + work.s5_5*work.s5_4 - zd_chassis_rx*work.w_chassis_z;
  const double alpha_chassis_z = s8_1341*(s9_10 + s8_1325*alpha_chassis_y);
  const double s9_12 = alpha_chassis_z + work.s5_5*work.s5_2 + zd_chassis_rx*work.w_chassis_y;
  result.zdd[Coordinate::chassis_rz] = work.s5_9*s9_11 + work.s5_13*s9_12;
  result.zdd[Coordinate::chassis_ry] = work.cosines[2]*s9_11 - work.sines[2]*s9_12;
  const double s9_13 = work.s5_7*(alpha_chassis_x + work.s5_3*work.s5_2 + work.s5_1*work.s5_4);
  result.zdd[Coordinate::chassis_rx] = work.s5_8*s9_11 + work.s5_12*s9_12 + s9_13;
  const double s9_14 = work.s8_1126 - work.s8_1122*alpha_chassis_y;
  const double s9_15 = s9_14 - work.s8_1105*alpha_chassis_z - work.s8_1117*alpha_chassis_x;
  const double s9_16 = s9_15 - work.s8_1104*a_chassis_y - work.s8_1110*a_chassis_z;
  const double s9_17 = s9_16 - work.s8_1100*a_chassis_x;
  const double s9_18 = work.s8_1096 - work.s8_1092*alpha_chassis_y;
  const double s9_19 = s9_18 - work.s8_1077*alpha_chassis_z - work.s8_1087*alpha_chassis_x;
  const double s9_20 = s9_19 - work.s8_1076*a_chassis_y - work.s8_1080*a_chassis_z;
  const double s9_21 = s9_20 - work.s8_1073*a_chassis_x;
  const double s9_22 = work.s8_1067 - work.s8_1044*alpha_chassis_y;
  const double s9_23 = s9_22 - work.s8_1054*alpha_chassis_z - work.s8_1034*alpha_chassis_x;
  const double s9_24 = s9_23 - work.s8_890*a_chassis_y - work.s8_897*a_chassis_z;
  const double s9_25 = s9_24 - work.s8_871*a_chassis_x;
  const double s9_26 = work.s8_445 - work.s8_435*alpha_chassis_y - work.s8_440*alpha_chassis_z;
  const double s9_27 = s9_26 - work.s8_429*alpha_chassis_x - work.s8_420*a_chassis_y;
  const double s9_28 = s9_27 - work.s8_422*a_chassis_z - work.s8_421*a_chassis_x;
  const double s9_29 = work.s8_416 - work.s8_402*alpha_chassis_y - work.s8_408*alpha_chassis_z;
  const double s9_30 = s9_29 - work.s8_395*alpha_chassis_x - work.s8_166*a_chassis_y;
  const double s9_31 = s9_30 - work.s8_229*a_chassis_z - work.s8_228*a_chassis_x;
  result.inertia[4] = mbgen::min(s8_1352, work.s9_1);
  // bell_crank: bell_crank, revolute, chassis
  const double s9_32 = work.s8_1127*s9_17;
  const double s9_33 = s9_32 + work.s4_1*work.s4_5 + work.s4_4*work.s4_2 - work.s4_9*work.s4_7;
  const double s9_34 = s9_33 + work.s4_6*work.s4_3;
  const double s9_35 = work.s5_17*s9_34;
  const double s9_36 = work.cosines[4]*s9_34;
  const double s9_37 = work.s5_21*s9_34;
  const double s9_38 = work.s8_533*s9_32;
  const double s9_39 = work.s8_1097*(s9_21 + work.s8_1072*s9_32);
  result.zdd[Coordinate::lower_arm_right] = s9_39;
  const double s9_40 = work.s8_546*s9_39;
  const double s9_41 = work.s8_1068*(s9_25 - work.s8_994*s9_32 - work.s8_968*s9_39);
  result.zdd[Coordinate::bell_crank] = s9_41;
  const double s9_42 = work.zdd_star_lower_arm_left + work.Rz_lower_arm_left_2*s9_41;
  result.zdd[Coordinate::lower_arm_left] = s9_42 - work.s3_98*s9_32;
  const double s9_43 = work.zdd_star_carrier_left_rx - work.s3_100*s9_32 - work.s3_120*s9_41;
  const double s9_44 = work.zdd_star_carrier_left_ry - work.s3_99*s9_32 - work.s3_119*s9_41;
  result.zdd[Coordinate::upper_arm_left] = work.Rz_upper_arm_left_2*s9_41 - work.s6_195 -
      work.s3_97*s9_32;
  const double s9_45 = work.zdd_star_arb_front_left + work.Rz_arb_front_left_0*s9_32;
  result.zdd[Coordinate::arb_front_left] = s9_45 + work.Rz_arb_front_left_2*s9_41;
  const double s9_46 = work.zdd_star_carrier_right_rx + work.Rz_carrier_right_rx_1*s9_39;
  const double s9_47 = s9_46 + work.Rz_carrier_right_rx_2*s9_41;
  const double s9_48 = work.zdd_star_carrier_right_ry + work.Rz_carrier_right_ry_1*s9_39;
  const double s9_49 = s9_48 + work.Rz_carrier_right_ry_2*s9_41;
  const double s9_50 = work.zdd_star_arb_front_right + work.Rz_arb_front_right_1*s9_39;
  result.zdd[Coordinate::arb_front_right] = s9_50 + work.Rz_arb_front_right_2*s9_41;
  const double s9_51 = s9_43 - work.s4_1*work.s4_34 + work.s4_36;
  const double s9_52 = s9_44 - work.s4_4*work.s4_34 - work.s4_38*work.s4_7 - work.s4_37;
  const double s9_53 = work.zdd_star_carrier_right_rz + work.Rz_carrier_right_rz_2*s9_41;
  const double s9_54 = s9_53 - work.s3_108*s9_39 + work.s4_12*work.s4_16;
  const double s9_55 = s9_54 + work.s4_15*work.s4_13 - work.s4_20*work.s4_18;
  const double s9_56 = s9_55 + work.s4_17*work.s4_14;
  const double s9_57 = s9_47 - work.s4_12*work.s4_42 + work.s4_44;
  const double s9_58 = s9_49 - work.s4_15*work.s4_42 - work.s4_46*work.s4_18 - work.s4_45;
  const double s9_59 = work.s5_30*s9_56;
  const double s9_60 = work.cosines[10]*s9_56;
  const double s9_61 = work.s5_34*s9_56;
  result.zdd[Coordinate::upper_arm_right] = -(work.s6_205 + work.s3_107*s9_39 + work.s3_123*s9_41);
  result.zdd[Coordinate::pitman_arm] = -(work.s6_235 + work.s3_142*s9_41);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s9_62 = s9_51 + work.s4_3*(zd_lower_arm_left + work.s4_38);
  const double s9_63 = s9_52 + zd_lower_arm_left*(work.s4_4 - work.s4_5);
  result.zdd[Coordinate::carrier_left_rz] = work.s5_20*s9_63 + s9_35 - work.s5_19*s9_62;
  const double s9_64 = work.R_carrier_left_aux1_y_x*s9_62 + work.R_carrier_left_aux1_z_x*s9_63;
  result.zdd[Coordinate::carrier_left_rx] = s9_64 + s9_36;
  result.zdd[Coordinate::carrier_left_ry] = work.s5_23*s9_62 + work.s5_26*s9_63 - s9_37;
  const double alpha_carrier_left_x = alpha_chassis_x + (work.s4_11 + s9_42) + s9_38;
  const double s9_65 = work.s1_19*alpha_carrier_left_x;
  const double alpha_carrier_left_y = alpha_chassis_y + (work.s4_40 + s9_43);
  const double s9_66 = work.R_carrier_left_aux2_y_y*alpha_carrier_left_y;
  const double alpha_carrier_left_z = alpha_chassis_z + (work.s4_41 + s9_44);
  const double s9_67 = work.R_carrier_left_aux2_z_y*alpha_carrier_left_z;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double s9_68 = s9_57 + work.s4_14*(zd_lower_arm_right + work.s4_46);
  const double s9_69 = s9_58 + zd_lower_arm_right*(work.s4_15 - work.s4_16);
  result.zdd[Coordinate::carrier_right_rz] = work.s5_33*s9_69 + s9_59 - work.s5_32*s9_68;
  const double s9_70 = work.R_carrier_right_aux1_y_x*s9_68;
  result.zdd[Coordinate::carrier_right_rx] = s9_70 + work.R_carrier_right_aux1_z_x*s9_69 + s9_60;
  result.zdd[Coordinate::carrier_right_ry] = work.s5_37*s9_68 + work.s5_41*s9_69 - s9_61;
  const double alpha_carrier_right_x = alpha_chassis_x + (work.s4_22 + s9_53) + s9_40;
  const double s9_71 = work.s1_39*alpha_carrier_right_x;
  const double alpha_carrier_right_y = alpha_chassis_y + (work.s4_48 + s9_47);
  const double s9_72 = work.R_carrier_right_aux2_y_y*alpha_carrier_right_y;
  const double alpha_carrier_right_z = alpha_chassis_z + (work.s4_49 + s9_49);
  const double s9_73 = work.R_carrier_right_aux2_z_y*alpha_carrier_right_z;
  // bell_crank: bell_crank, revolute, chassis
  const double s9_74 = mbgen::min(work.s2_324, std::abs(work.s1_24));
  result.pivot[0] = mbgen::min(s9_74, std::abs(work.s1_44));
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s9_75 = 0.09090909090909091*tau[Coordinate::wheel_front_left] - s9_66 - s9_67;
  result.zdd[Coordinate::wheel_front_left] = s9_75 + s9_65;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s9_76 = 0.09090909090909091*tau[Coordinate::wheel_front_right] - s9_72 - s9_73;
  result.zdd[Coordinate::wheel_front_right] = s9_76 + s9_71;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s9_77 = work.s8_446*s9_28;
  result.zdd[Coordinate::arb_rear_left] = s9_77;
  const double s9_78 = work.s8_417*(s9_31 - work.s8_387*s9_77);
  result.zdd[Coordinate::arb_rear_right] = s9_78;
  const double s9_79 = work.zdd_star_rear_axle_tx + work.Rz_rear_axle_tx_0*s9_77;
  result.zdd[Coordinate::rear_axle_tx] = s9_79 + work.Rz_rear_axle_tx_1*s9_78;
  const double s9_80 = work.zdd_star_rear_axle_tz - work.s3_2*s9_77;
  result.zdd[Coordinate::rear_axle_tz] = s9_80 + work.Rz_rear_axle_tz_1*s9_78;
  const double s9_81 = work.zdd_star_rear_axle_rz + work.Rz_rear_axle_rz_0*s9_77;
  const double s9_82 = s9_81 - work.s3_48*s9_78;
  const double s9_83 = work.zdd_star_rear_axle_ry + work.Rz_rear_axle_ry_0*s9_77;
  const double s9_84 = s9_83 + work.Rz_rear_axle_ry_1*s9_78;
  const double s9_85 = work.zdd_star_rear_axle_rx + work.Rz_rear_axle_rx_0*s9_77;
  const double s9_86 = s9_85 + work.Rz_rear_axle_rx_1*s9_78;
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  const double s9_87 = s9_82 + work.s4_23*work.s4_30 + zd_rear_axle_rz*work.s4_25;
  const double s9_88 = s9_84 + work.s4_26*work.s4_30;
  const double s9_89 = work.s8_180*(s9_86 + work.s4_23*work.s4_27 + work.s4_26*work.s4_24);
  const double s9_90 = work.s5_46*s9_87;
  const double s9_91 = work.sines[17]*s9_87;
  const double s9_92 = work.s5_48*s9_87;
  result.zdd[Coordinate::rear_axle_ty] = -(work.s6_72 + work.s3_16*s9_77 + work.s3_63*s9_78);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s9_93 = s9_88 + zd_rear_axle_rz*(work.s4_26 - work.s4_27);
  result.zdd[Coordinate::rear_axle_rz] = work.s5_47*s9_93 + s9_89 + s9_90;
  result.zdd[Coordinate::rear_axle_ry] = work.cosines[17]*s9_93 - s9_91;
  result.zdd[Coordinate::rear_axle_rx] = work.s5_51*s9_93 + s9_92;
  const double alpha_rear_axle_x = alpha_chassis_x + (work.s4_32 + s9_82);
  const double alpha_rear_axle_y = alpha_chassis_y + (work.s4_33 + s9_84);
  const double alpha_rear_axle_z = alpha_chassis_z + (work.s4_29 + s9_86);
  const double s9_94 = work.R_rear_axle_y_y*alpha_rear_axle_y;
  const double s9_95 = s9_94 + work.R_rear_axle_z_y*alpha_rear_axle_z;
  const double s9_96 = s9_95 + work.R_rear_axle_x_y*alpha_rear_axle_x;
  // arb_rear_right: arb_rear_right, revolute, chassis
  result.pivot[1] = mbgen::min(work.s2_167, std::abs(work.s1_48));
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  result.zdd[Coordinate::wheel_rear_left] = 0.045454545454545456*tau[Coordinate::wheel_rear_left] -
      s9_96;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  result.zdd[Coordinate::wheel_rear_right] = 0.045454545454545456*tau[Coordinate::wheel_rear_right]
      - s9_96;
  // operations: 181 add, 183 multiply, 7 other
  result.inertia[9] = 10.999999999989;
  result.inertia[10] = 10.999999999989;
  result.inertia[13] = 21.999999999978;
  result.inertia[14] = 21.999999999978;
}

/// All accelerations with the frozen partition of the loop blocks.
void compute_accelerations(const Parameters& /*parameters*/, const Inputs& /*inputs*/,
    const State& state, const double* tau, Accelerations& __restrict result) noexcept {
  AccelerationsWork work;
  compute_accelerations_1(state, tau, work);
  compute_accelerations_2(state, tau, work);
  compute_accelerations_3(state, tau, work, result);
  compute_accelerations_4(state, tau, work);
  compute_accelerations_5(state, tau, work);
  compute_accelerations_6(state, tau, work, result);
  compute_accelerations_7(state, tau, work, result);
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
      sines[19], cosines[19], r_rear_axle_aux1_x, r_rear_axle_aux3_z, R_rear_axle_aux5_x_x,
      R_rear_axle_aux5_y_x, s1_36, s1_37, b_rear_axle_ry_z, R_rear_axle_x_y, R_rear_axle_y_y,
      R_rear_axle_z_y, R_rear_axle_x_z, R_rear_axle_y_z, R_rear_axle_z_z, s1_41, b_rear_axle_rx_y,
      b_rear_axle_rx_z, s2_11, s2_12, s2_13, J_upper_ball_left_carrier_left_rz,
      J_upper_ball_left_carrier_left_rx, J_upper_ball_left_carrier_left_ry, s2_17,
      J_upper_ball_left_carrier_left_rz_2, J_upper_ball_left_carrier_left_rx_2,
      J_upper_ball_left_carrier_left_ry_2, J_upper_ball_left_upper_arm_left,
      J_upper_ball_left_lower_arm_left, J_upper_ball_left_carrier_left_rz_3,
      J_upper_ball_left_carrier_left_rx_3, J_upper_ball_left_carrier_left_ry_3, s2_20, s2_31, s2_32,
      s2_33, J_upper_ball_right_carrier_right_rz, J_upper_ball_right_carrier_right_rx,
      J_upper_ball_right_carrier_right_ry, s2_37, J_upper_ball_right_carrier_right_rz_2,
      J_upper_ball_right_carrier_right_rx_2, J_upper_ball_right_carrier_right_ry_2, s2_38,
      J_upper_ball_right_lower_arm_right, J_upper_ball_right_carrier_right_rz_3,
      J_upper_ball_right_carrier_right_rx_3, J_upper_ball_right_carrier_right_ry_3, s2_40, s2_59,
      s2_63, s2_65, s2_68, s2_71, J_arb_link_front_left_arb_front_left, s2_90, s2_94, s2_96, s2_99,
      s2_102, J_arb_link_front_right_arb_front_right, s2_113, J_drag_link_pitman_arm, s2_114,
      s2_130, s2_134, s2_136, s2_139, s2_142, J_tie_rod_left_bell_crank, s2_154, s2_158, s2_160,
      s2_163, s2_166, J_tie_rod_right_bell_crank;
};

/// Part 1 of compute_closure: step 1: poses, axes b, accumulated inertias MR (50); step 2: closure
/// Jacobian Phi_z and its factors (60).
[[gnu::noinline]] void compute_closure_1(const State& state, ClosureWork& __restrict work,
    Closure& __restrict result) noexcept {
  // --- step 1: poses, axes b, accumulated inertias MR (50) ---
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
  const double R_lower_arm_left_z_y = work.sines[0];
  const double s1_1 = 0.4 + 0.44999999999999996*R_lower_arm_left_y_y;
  const double r_carrier_left_aux1_y = s1_1 + 0.04999999999999999*R_lower_arm_left_z_y;
  const double s1_2 = 0.44999999999999996*R_lower_arm_left_z_y - 0.62;
  const double r_carrier_left_aux1_z = s1_2 - 0.04999999999999999*R_lower_arm_left_y_y;
  const double s1_3 = work.sines[1];
  const double R_carrier_left_aux1_y_x = R_lower_arm_left_y_y*s1_3;
  const double R_carrier_left_aux1_z_x = R_lower_arm_left_z_y*s1_3;
  const double R_carrier_left_aux1_x_x = work.cosines[1];
  const double R_carrier_left_aux1_y_y = R_lower_arm_left_y_y*R_carrier_left_aux1_x_x;
  const double R_carrier_left_aux1_z_y = R_lower_arm_left_z_y*R_carrier_left_aux1_x_x;
  const double s1_4 = R_lower_arm_left_z_y*r_carrier_left_aux1_z;
  const double b_carrier_left_rz_x = s1_4 + R_lower_arm_left_y_y*r_carrier_left_aux1_y;
  const double s1_5 = 3.6*R_lower_arm_left_y_y;
  const double s1_6 = 3.6*R_lower_arm_left_z_y;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_7 = work.cosines[2];
  const double s1_8 = s1_3*s1_7;
  const double s1_9 = work.sines[2];
  const double R_carrier_left_aux2_y_y = R_carrier_left_aux1_y_y*s1_7 - R_lower_arm_left_z_y*s1_9;
  const double R_carrier_left_aux2_z_y = R_carrier_left_aux1_z_y*s1_7 + R_lower_arm_left_y_y*s1_9;
  const double R_carrier_left_aux2_x_z = s1_3*s1_9;
  const double s1_10 = R_carrier_left_aux1_y_y*s1_9 + R_lower_arm_left_z_y*s1_7;
  const double R_carrier_left_aux2_z_z = R_lower_arm_left_y_y*s1_7 - R_carrier_left_aux1_z_y*s1_9;
  const double s1_11 = r_carrier_left_aux1_y*R_carrier_left_aux1_z_x;
  const double b_carrier_left_rx_x = s1_11 - r_carrier_left_aux1_z*R_carrier_left_aux1_y_x;
  const double s1_12 = r_carrier_left_aux1_z*R_carrier_left_aux1_x_x;
  const double b_carrier_left_rx_y = s1_12 - 3.6*R_carrier_left_aux1_z_x;
  const double s1_13 = r_carrier_left_aux1_y*R_carrier_left_aux1_x_x;
  const double b_carrier_left_rx_z = 3.6*R_carrier_left_aux1_y_x - s1_13;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_14 = work.cosines[3];
  const double s1_15 = work.sines[3];
  const double R_carrier_left_x_x = R_carrier_left_aux1_x_x*s1_14 - R_carrier_left_aux2_x_z*s1_15;
  const double R_carrier_left_y_x = s1_10*s1_15 + R_carrier_left_aux1_y_x*s1_14;
  const double R_carrier_left_z_x = R_carrier_left_aux1_z_x*s1_14 - R_carrier_left_aux2_z_z*s1_15;
  const double R_carrier_left_x_z = R_carrier_left_aux2_x_z*s1_14 + R_carrier_left_aux1_x_x*s1_15;
  const double R_carrier_left_y_z = R_carrier_left_aux1_y_x*s1_15 - s1_10*s1_14;
  const double R_carrier_left_z_z = R_carrier_left_aux2_z_z*s1_14 + R_carrier_left_aux1_z_x*s1_15;
  const double s1_16 = r_carrier_left_aux1_y*R_carrier_left_aux2_z_y;
  const double b_carrier_left_ry_x = s1_16 - r_carrier_left_aux1_z*R_carrier_left_aux2_y_y;
  const double s1_17 = 3.6*R_carrier_left_aux2_z_y + r_carrier_left_aux1_z*s1_8;
  const double b_carrier_left_ry_z = r_carrier_left_aux1_y*s1_8 + 3.6*R_carrier_left_aux2_y_y;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_z_y = work.sines[6];
  const double R_lower_arm_right_y_y = work.cosines[6];
  const double s1_18 = 0.04999999999999999*R_lower_arm_right_z_y - 0.4;
  const double r_carrier_right_aux1_y = s1_18 - 0.44999999999999996*R_lower_arm_right_y_y;
  const double s1_19 = 0.62 + 0.44999999999999996*R_lower_arm_right_z_y;
  const double s1_20 = s1_19 + 0.04999999999999999*R_lower_arm_right_y_y;
  const double s1_21 = work.sines[7];
  const double R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_21;
  const double R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_21;
  const double R_carrier_right_aux1_x_x = work.cosines[7];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  const double s1_22 = R_lower_arm_right_y_y*r_carrier_right_aux1_y;
  const double b_carrier_right_rz_x = s1_22 - R_lower_arm_right_z_y*s1_20;
  const double s1_23 = 3.6*R_lower_arm_right_y_y;
  const double s1_24 = 3.6*R_lower_arm_right_z_y;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_25 = work.cosines[8];
  const double s1_26 = s1_21*s1_25;
  const double s1_27 = work.sines[8];
  const double R_carrier_right_aux2_y_y = R_carrier_right_aux1_y_y*s1_25 -
      R_lower_arm_right_z_y*s1_27;
  const double R_carrier_right_aux2_z_y = R_carrier_right_aux1_z_y*s1_25 +
      R_lower_arm_right_y_y*s1_27;
  const double R_carrier_right_aux2_x_z = s1_21*s1_27;
  const double s1_28 = R_carrier_right_aux1_y_y*s1_27 + R_lower_arm_right_z_y*s1_25;
  const double R_carrier_right_aux2_z_z = R_lower_arm_right_y_y*s1_25 -
      R_carrier_right_aux1_z_y*s1_27;
  const double s1_29 = r_carrier_right_aux1_y*R_carrier_right_aux1_z_x;
  const double b_carrier_right_rx_x = s1_20*R_carrier_right_aux1_y_x + s1_29;
  const double s1_30 = 3.6*R_carrier_right_aux1_z_x + s1_20*R_carrier_right_aux1_x_x;
  const double s1_31 = r_carrier_right_aux1_y*R_carrier_right_aux1_x_x;
  const double b_carrier_right_rx_z = 3.6*R_carrier_right_aux1_y_x - s1_31;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_32 = work.cosines[9];
  const double s1_33 = work.sines[9];
  const double R_carrier_right_x_x = R_carrier_right_aux1_x_x*s1_32 -
      R_carrier_right_aux2_x_z*s1_33;
  const double R_carrier_right_y_x = s1_28*s1_33 + R_carrier_right_aux1_y_x*s1_32;
  const double R_carrier_right_z_x = R_carrier_right_aux1_z_x*s1_32 -
      R_carrier_right_aux2_z_z*s1_33;
  const double R_carrier_right_x_z = R_carrier_right_aux2_x_z*s1_32 +
      R_carrier_right_aux1_x_x*s1_33;
  const double R_carrier_right_y_z = R_carrier_right_aux1_y_x*s1_33 - s1_28*s1_32;
  const double R_carrier_right_z_z = R_carrier_right_aux2_z_z*s1_32 +
      R_carrier_right_aux1_z_x*s1_33;
  const double s1_34 = r_carrier_right_aux1_y*R_carrier_right_aux2_z_y;
  const double b_carrier_right_ry_x = s1_20*R_carrier_right_aux2_y_y + s1_34;
  const double b_carrier_right_ry_y = s1_20*s1_26 - 3.6*R_carrier_right_aux2_z_y;
  const double b_carrier_right_ry_z = r_carrier_right_aux1_y*s1_26 + 3.6*R_carrier_right_aux2_y_y;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - 2.4999999999999996;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  work.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] - 0.5;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[14];
  const double R_rear_axle_aux5_z_z = work.cosines[15];
  work.R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double R_rear_axle_aux4_y_x = work.sines[14];
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double s1_35 = work.sines[15];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_35;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_35;
  work.s1_36 = work.r_rear_axle_aux3_z*R_rear_axle_aux4_x_x;
  work.s1_37 = work.r_rear_axle_aux3_z*R_rear_axle_aux4_y_x;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s1_38 = work.r_rear_axle_aux1_x*R_rear_axle_aux4_x_x;
  work.b_rear_axle_ry_z = z_rear_axle_ty*R_rear_axle_aux4_y_x + s1_38;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_39 = work.sines[16];
  const double s1_40 = work.cosines[16];
  work.R_rear_axle_x_y = R_rear_axle_aux5_x_z*s1_39 - R_rear_axle_aux4_y_x*s1_40;
  work.R_rear_axle_y_y = R_rear_axle_aux4_x_x*s1_40 + R_rear_axle_aux5_y_z*s1_39;
  work.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_39;
  work.R_rear_axle_x_z = R_rear_axle_aux4_y_x*s1_39 + R_rear_axle_aux5_x_z*s1_40;
  work.R_rear_axle_y_z = R_rear_axle_aux5_y_z*s1_40 - R_rear_axle_aux4_x_x*s1_39;
  work.R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_40;
  work.s1_41 = work.r_rear_axle_aux3_z*work.R_rear_axle_aux5_y_x + z_rear_axle_ty*s1_35;
  const double s1_42 = work.r_rear_axle_aux3_z*work.R_rear_axle_aux5_x_x;
  work.b_rear_axle_rx_y = work.r_rear_axle_aux1_x*s1_35 + s1_42;
  const double s1_43 = work.r_rear_axle_aux1_x*work.R_rear_axle_aux5_y_x;
  work.b_rear_axle_rx_z = s1_43 - z_rear_axle_ty*work.R_rear_axle_aux5_x_x;
  // operations: 52 add, 116 multiply, 38 sin cos

  // --- step 2: closure Jacobian Phi_z and its factors (60) ---
  // upper_ball_left
  const double s2_1 = 3.6 + 0.04999999999999993*s1_8;
  const double s2_2 = s2_1 + 0.36999999999999994*R_carrier_left_x_z;
  const double s2_3 = r_carrier_left_aux1_y - 0.04999999999999993*R_carrier_left_aux2_y_y;
  const double s2_4 = s2_3 + 0.36999999999999994*R_carrier_left_y_z;
  const double s2_5 = r_carrier_left_aux1_z - 0.04999999999999993*R_carrier_left_aux2_z_y;
  const double s2_6 = s2_5 + 0.36999999999999994*R_carrier_left_z_z;
  const double R_upper_arm_left_y_y = work.cosines[4];
  const double R_upper_arm_left_z_y = work.sines[4];
  const double s2_7 = 0.5 + 0.30000000000000004*R_upper_arm_left_y_y;
  const double s2_8 = s2_7 + 0.020000000000000018*R_upper_arm_left_z_y;
  const double s2_9 = 0.30000000000000004*R_upper_arm_left_z_y - 0.28;
  const double s2_10 = s2_9 - 0.020000000000000018*R_upper_arm_left_y_y;
  work.s2_11 = s2_2 - 3.6;
  result.residual[0] = work.s2_11;
  work.s2_12 = s2_4 - s2_8;
  result.residual[1] = work.s2_12;
  work.s2_13 = s2_6 - s2_10;
  result.residual[2] = work.s2_13;
  const double s2_14 = b_carrier_left_rz_x - R_lower_arm_left_z_y*s2_6;
  work.J_upper_ball_left_carrier_left_rz = s2_14 - R_lower_arm_left_y_y*s2_4;
  const double s2_15 = b_carrier_left_rx_x + R_carrier_left_aux1_y_x*s2_6;
  work.J_upper_ball_left_carrier_left_rx = s2_15 - R_carrier_left_aux1_z_x*s2_4;
  const double s2_16 = b_carrier_left_ry_x + R_carrier_left_aux2_y_y*s2_6;
  work.J_upper_ball_left_carrier_left_ry = s2_16 - R_carrier_left_aux2_z_y*s2_4;
  work.s2_17 = 0.62 + s2_6;
  work.J_upper_ball_left_carrier_left_rz_2 = R_lower_arm_left_y_y*s2_2 - s1_5;
  const double s2_18 = b_carrier_left_rx_y + R_carrier_left_aux1_z_x*s2_2;
  work.J_upper_ball_left_carrier_left_rx_2 = s2_18 - R_carrier_left_aux1_x_x*s2_6;
  work.J_upper_ball_left_carrier_left_ry_2 = R_carrier_left_aux2_z_y*s2_2 - s1_17 + s1_8*s2_6;
  work.J_upper_ball_left_upper_arm_left = 0.28 + s2_10;
  work.J_upper_ball_left_lower_arm_left = s2_4 - 0.4;
  work.J_upper_ball_left_carrier_left_rz_3 = R_lower_arm_left_z_y*s2_2 - s1_6;
  const double s2_19 = b_carrier_left_rx_z + R_carrier_left_aux1_x_x*s2_4;
  work.J_upper_ball_left_carrier_left_rx_3 = s2_19 - R_carrier_left_aux1_y_x*s2_2;
  work.J_upper_ball_left_carrier_left_ry_3 = b_carrier_left_ry_z - R_carrier_left_aux2_y_y*s2_2 -
      s1_8*s2_4;
  work.s2_20 = s2_8 - 0.5;
  // upper_ball_right
  const double s2_21 = 3.6 - 0.04999999999999993*s1_26;
  const double s2_22 = s2_21 + 0.36999999999999994*R_carrier_right_x_z;
  const double s2_23 = r_carrier_right_aux1_y + 0.04999999999999993*R_carrier_right_aux2_y_y;
  const double s2_24 = s2_23 + 0.36999999999999994*R_carrier_right_y_z;
  const double s2_25 = 0.04999999999999993*R_carrier_right_aux2_z_y - s1_20;
  const double s2_26 = s2_25 + 0.36999999999999994*R_carrier_right_z_z;
  const double R_upper_arm_right_z_y = work.sines[10];
  const double R_upper_arm_right_y_y = work.cosines[10];
  const double s2_27 = 0.020000000000000018*R_upper_arm_right_z_y - 0.5;
  const double s2_28 = s2_27 - 0.30000000000000004*R_upper_arm_right_y_y;
  const double s2_29 = 0.28 + 0.30000000000000004*R_upper_arm_right_z_y;
  const double s2_30 = s2_29 + 0.020000000000000018*R_upper_arm_right_y_y;
  work.s2_31 = s2_22 - 3.6;
  result.residual[3] = work.s2_31;
  work.s2_32 = s2_24 - s2_28;
  result.residual[4] = work.s2_32;
  work.s2_33 = s2_26 + s2_30;
  result.residual[5] = work.s2_33;
  const double s2_34 = b_carrier_right_rz_x - R_lower_arm_right_z_y*s2_26;
  work.J_upper_ball_right_carrier_right_rz = s2_34 - R_lower_arm_right_y_y*s2_24;
  const double s2_35 = b_carrier_right_rx_x + R_carrier_right_aux1_y_x*s2_26;
  work.J_upper_ball_right_carrier_right_rx = s2_35 - R_carrier_right_aux1_z_x*s2_24;
  const double s2_36 = b_carrier_right_ry_x + R_carrier_right_aux2_y_y*s2_26;
  work.J_upper_ball_right_carrier_right_ry = s2_36 - R_carrier_right_aux2_z_y*s2_24;
  work.s2_37 = 0.62 + s2_26;
  work.J_upper_ball_right_carrier_right_rz_2 = R_lower_arm_right_y_y*s2_22 - s1_23;
  work.J_upper_ball_right_carrier_right_rx_2 = R_carrier_right_aux1_z_x*s2_22 - s1_30 -
      R_carrier_right_aux1_x_x*s2_26;
  work.J_upper_ball_right_carrier_right_ry_2 = b_carrier_right_ry_y + R_carrier_right_aux2_z_y*s2_22
      + s1_26*s2_26;
  work.s2_38 = s2_30 - 0.28;
  work.J_upper_ball_right_lower_arm_right = 0.4 + s2_24;
  work.J_upper_ball_right_carrier_right_rz_3 = R_lower_arm_right_z_y*s2_22 - s1_24;
  const double s2_39 = b_carrier_right_rx_z + R_carrier_right_aux1_x_x*s2_24;
  work.J_upper_ball_right_carrier_right_rx_3 = s2_39 - R_carrier_right_aux1_y_x*s2_22;
  work.J_upper_ball_right_carrier_right_ry_3 = b_carrier_right_ry_z - R_carrier_right_aux2_y_y*s2_22
      - s1_26*s2_24;
  work.s2_40 = 0.5 + s2_28;
  // arb_link_front_left
  const double s2_41 = 3.6 + 0.030000000000000027*s1_8 + 0.02999999999999997*R_carrier_left_x_z;
  const double s2_42 = s2_41 + 0.1*R_carrier_left_x_x;
  const double s2_43 = r_carrier_left_aux1_y + 0.02999999999999997*R_carrier_left_y_z;
  const double s2_44 = 0.030000000000000027*R_carrier_left_aux2_y_y;
  const double s2_45 = s2_43 + 0.1*R_carrier_left_y_x - s2_44;
  const double s2_46 = r_carrier_left_aux1_z + 0.02999999999999997*R_carrier_left_z_z;
  const double s2_47 = 0.030000000000000027*R_carrier_left_aux2_z_y;
  const double s2_48 = s2_46 + 0.1*R_carrier_left_z_x - s2_47;
  const double R_arb_front_left_x_z = work.sines[5];
  const double R_arb_front_left_x_x = work.cosines[5];
  const double s2_49 = 3.95 + 0.09999999999999998*R_arb_front_left_x_z;
  const double s2_50 = s2_49 - 0.24999999999999997*R_arb_front_left_x_x;
  const double s2_51 = 0.09999999999999998*R_arb_front_left_x_x - 0.5;
  const double s2_52 = s2_51 + 0.24999999999999997*R_arb_front_left_x_z;
  const double s2_53 = s2_50 - s2_42;
  const double s2_54 = 0.72 - s2_45;
  const double s2_55 = s2_52 - s2_48;
  const double s2_56 = 3.846153846153846*s2_53;
  const double s2_57 = 3.846153846153846*s2_54;
  const double s2_58 = 3.846153846153846*s2_55;
  work.s2_59 = 0.5*(s2_54*s2_57 - 0.26 + s2_55*s2_58 + s2_53*s2_56);
  result.residual[6] = work.s2_59;
  const double s2_60 = s2_45*s2_58 - s2_48*s2_57;
  const double s2_61 = s2_48*s2_56 - s2_42*s2_58;
  const double s2_62 = s2_42*s2_57 - s2_45*s2_56;
  work.s2_63 = s2_60 - 0.62*s2_57 - 0.4*s2_58;
  const double s2_64 = R_lower_arm_left_y_y*s2_62 - R_lower_arm_left_z_y*s2_61;
  work.s2_65 = s2_64 + b_carrier_left_rz_x*s2_56 - s1_6*s2_58 - s1_5*s2_57;
  const double s2_66 = R_carrier_left_aux1_y_x*s2_61 + R_carrier_left_aux1_z_x*s2_62;
  const double s2_67 = s2_66 + R_carrier_left_aux1_x_x*s2_60 + b_carrier_left_rx_y*s2_57;
  work.s2_68 = s2_67 + b_carrier_left_rx_z*s2_58 + b_carrier_left_rx_x*s2_56;
  const double s2_69 = R_carrier_left_aux2_y_y*s2_61 + R_carrier_left_aux2_z_y*s2_62;
  const double s2_70 = s2_69 - s1_8*s2_60 + b_carrier_left_ry_z*s2_58;
  work.s2_71 = s2_70 + b_carrier_left_ry_x*s2_56 - s1_17*s2_57;
  work.J_arb_link_front_left_arb_front_left = s2_56*(0.5 + s2_52) + s2_58*(3.95 - s2_50);
  // arb_link_front_right
  const double s2_72 = 3.6 + 0.02999999999999997*R_carrier_right_x_z + 0.1*R_carrier_right_x_x;
  const double s2_73 = s2_72 - 0.030000000000000027*s1_26;
  const double s2_74 = r_carrier_right_aux1_y + 0.030000000000000027*R_carrier_right_aux2_y_y;
  const double s2_75 = s2_74 + 0.02999999999999997*R_carrier_right_y_z;
  const double s2_76 = s2_75 + 0.1*R_carrier_right_y_x;
  const double s2_77 = 0.030000000000000027*R_carrier_right_aux2_z_y - s1_20;
  const double s2_78 = s2_77 + 0.02999999999999997*R_carrier_right_z_z;
  const double s2_79 = s2_78 + 0.1*R_carrier_right_z_x;
  const double R_arb_front_right_x_z = work.sines[11];
  const double R_arb_front_right_x_x = work.cosines[11];
  const double s2_80 = 3.95 + 0.09999999999999998*R_arb_front_right_x_z;
  const double s2_81 = s2_80 - 0.24999999999999997*R_arb_front_right_x_x;
  const double s2_82 = 0.09999999999999998*R_arb_front_right_x_x - 0.5;
  const double s2_83 = s2_82 + 0.24999999999999997*R_arb_front_right_x_z;
  const double s2_84 = s2_81 - s2_73;
  const double s2_85 = 0.72 + s2_76;
  const double s2_86 = s2_83 - s2_79;
  const double s2_87 = 3.846153846153846*s2_84;
  const double s2_88 = 3.846153846153846*s2_85;
  const double s2_89 = 3.846153846153846*s2_86;
  work.s2_90 = 0.5*(s2_85*s2_88 - 0.26 + s2_86*s2_89 + s2_84*s2_87);
  result.residual[7] = work.s2_90;
  const double s2_91 = s2_79*s2_88 + s2_76*s2_89;
  const double s2_92 = s2_79*s2_87 - s2_73*s2_89;
  const double s2_93 = s2_76*s2_87 + s2_73*s2_88;
  work.s2_94 = s2_91 + 0.62*s2_88 + 0.4*s2_89;
  const double s2_95 = s1_23*s2_88 + b_carrier_right_rz_x*s2_87 - s1_24*s2_89;
  work.s2_96 = s2_95 - R_lower_arm_right_z_y*s2_92 - R_lower_arm_right_y_y*s2_93;
  const double s2_97 = R_carrier_right_aux1_y_x*s2_92 + R_carrier_right_aux1_x_x*s2_91;
  const double s2_98 = s2_97 - R_carrier_right_aux1_z_x*s2_93 + s1_30*s2_88;
  work.s2_99 = s2_98 + b_carrier_right_rx_z*s2_89 + b_carrier_right_rx_x*s2_87;
  const double s2_100 = R_carrier_right_aux2_y_y*s2_92 - R_carrier_right_aux2_z_y*s2_93;
  const double s2_101 = s2_100 - s1_26*s2_91 + b_carrier_right_ry_z*s2_89;
  work.s2_102 = s2_101 + b_carrier_right_ry_x*s2_87 - b_carrier_right_ry_y*s2_88;
  work.J_arb_link_front_right_arb_front_right = s2_87*(0.5 + s2_83) + s2_89*(3.95 - s2_81);
  // drag_link
  const double R_bell_crank_x_x = work.cosines[13];
  const double s2_103 = 0.3*R_bell_crank_x_x;
  const double R_bell_crank_y_x = work.sines[13];
  const double s2_104 = 3.25 - 0.3*R_bell_crank_y_x;
  const double s2_105 = 4.4 - 0.21999999999999997*work.sines[12];
  const double s2_106 = 0.4 + 0.21999999999999997*work.cosines[12];
  const double s2_107 = s2_105 - s2_104;
  const double s2_108 = 0.5 - s2_103;
  const double s2_109 = 0.6 - s2_106;
  const double s2_110 = 0.8565801464479955*s2_107;
  const double s2_111 = 0.8565801464479955*s2_108;
  const double s2_112 = 0.8565801464479955*s2_109;
  work.s2_113 = 0.5*(s2_108*s2_111 - 1.1674330815939729 + s2_109*s2_112 + s2_107*s2_110);
  result.residual[8] = work.s2_113;
  work.J_drag_link_pitman_arm = s2_110*(0.4 - s2_106) + s2_112*(4.4 - s2_105);
  work.s2_114 = s2_111*(s2_104 - 3.25) - s2_103*s2_110;
  // tie_rod_left
  const double s2_115 = s2_1 + 0.07*R_carrier_left_x_z - 0.22*R_carrier_left_x_x;
  const double s2_116 = s2_3 + 0.07*R_carrier_left_y_z - 0.22*R_carrier_left_y_x;
  const double s2_117 = s2_5 + 0.07*R_carrier_left_z_z - 0.22*R_carrier_left_z_x;
  const double s2_118 = 0.08*R_bell_crank_y_x;
  const double s2_119 = 0.20000000000000007*R_bell_crank_x_x;
  const double s2_120 = 0.08*R_bell_crank_x_x;
  const double s2_121 = 0.20000000000000007*R_bell_crank_y_x;
  const double s2_122 = s2_120 - s2_121;
  const double s2_123 = 3.25 - s2_118 - s2_119;
  const double s2_124 = s2_123 - s2_115;
  const double s2_125 = s2_122 - s2_116;
  const double s2_126 = 0.6 + s2_117;
  const double s2_127 = 1.2625900317976169*s2_124;
  const double s2_128 = 1.2625900317976169*s2_125;
  const double s2_129 = 1.2625900317976169*s2_126;
  work.s2_130 = 0.5*(s2_125*s2_128 - 0.7920227269466452 + s2_126*s2_129 + s2_124*s2_127);
  result.residual[9] = work.s2_130;
  const double s2_131 = s2_117*s2_128 + s2_116*s2_129;
  const double s2_132 = s2_115*s2_129 + s2_117*s2_127;
  const double s2_133 = s2_115*s2_128 - s2_116*s2_127;
  work.s2_134 = 0.4*s2_129 - s2_131 - 0.62*s2_128;
  const double s2_135 = R_lower_arm_left_y_y*s2_133 - R_lower_arm_left_z_y*s2_132 + s1_6*s2_129;
  work.s2_136 = s2_135 + b_carrier_left_rz_x*s2_127 - s1_5*s2_128;
  const double s2_137 = R_carrier_left_aux1_y_x*s2_132 + R_carrier_left_aux1_z_x*s2_133;
  const double s2_138 = s2_137 - R_carrier_left_aux1_x_x*s2_131 + b_carrier_left_rx_y*s2_128;
  work.s2_139 = s2_138 + b_carrier_left_rx_x*s2_127 - b_carrier_left_rx_z*s2_129;
  const double s2_140 = R_carrier_left_aux2_y_y*s2_132 + R_carrier_left_aux2_z_y*s2_133;
  const double s2_141 = s2_140 + s1_8*s2_131 + b_carrier_left_ry_x*s2_127;
  work.s2_142 = s2_141 - b_carrier_left_ry_z*s2_129 - s1_17*s2_128;
  work.J_tie_rod_left_bell_crank = s2_128*(s2_123 - 3.25) - s2_122*s2_127;
  // tie_rod_right
  const double s2_143 = s2_21 + 0.07*R_carrier_right_x_z - 0.22*R_carrier_right_x_x;
  const double s2_144 = s2_23 + 0.07*R_carrier_right_y_z - 0.22*R_carrier_right_y_x;
  const double s2_145 = s2_25 + 0.07*R_carrier_right_z_z - 0.22*R_carrier_right_z_x;
  const double s2_146 = s2_120 + s2_121;
  const double s2_147 = 3.25 + (s2_118 - s2_119);
  const double s2_148 = s2_147 - s2_143;
  const double s2_149 = s2_144 + s2_146;
  const double s2_150 = 0.6 + s2_145;
  const double s2_151 = 1.2625900317976169*s2_148;
  const double s2_152 = 1.2625900317976169*s2_149;
  const double s2_153 = 1.2625900317976169*s2_150;
  work.s2_154 = 0.5*(s2_149*s2_152 - 0.7920227269466452 + s2_150*s2_153 + s2_148*s2_151);
  result.residual[10] = work.s2_154;
  const double s2_155 = s2_145*s2_152 - s2_144*s2_153;
  const double s2_156 = s2_143*s2_153 + s2_145*s2_151;
  const double s2_157 = s2_144*s2_151 + s2_143*s2_152;
  work.s2_158 = s2_155 + 0.62*s2_152 - 0.4*s2_153;
  const double s2_159 = s1_23*s2_152 + s1_24*s2_153 + b_carrier_right_rz_x*s2_151;
  work.s2_160 = s2_159 - R_lower_arm_right_z_y*s2_156 - R_lower_arm_right_y_y*s2_157;
  const double s2_161 = R_carrier_right_aux1_y_x*s2_156 + R_carrier_right_aux1_x_x*s2_155;
  const double s2_162 = s2_161 - R_carrier_right_aux1_z_x*s2_157 + s1_30*s2_152;
  work.s2_163 = s2_162 + b_carrier_right_rx_x*s2_151 - b_carrier_right_rx_z*s2_153;
  const double s2_164 = R_carrier_right_aux2_y_y*s2_156 - R_carrier_right_aux2_z_y*s2_157;
  const double s2_165 = s2_164 - s1_26*s2_155 + b_carrier_right_ry_x*s2_151;
  work.s2_166 = s2_165 - b_carrier_right_ry_z*s2_153 - b_carrier_right_ry_y*s2_152;
  work.J_tie_rod_right_bell_crank = s2_146*s2_151 + s2_152*(3.25 - s2_147);
}

/// Part 2 of compute_closure: step 2: closure Jacobian Phi_z and its factors (60); step 4:
/// velocities Z (36).
[[gnu::noinline]] void compute_closure_2(const State& state, ClosureWork& __restrict work,
    Closure& __restrict result) noexcept {
  // --- step 2: closure Jacobian Phi_z and its factors (60), continued ---
  // tie_rod_right
  const double s2_167 = 1.0/work.J_drag_link_pitman_arm;
  const double s2_168 = 1.0/work.J_arb_link_front_right_arb_front_right;
  const double s2_169 = 4.291271972095581*std::abs(work.J_arb_link_front_right_arb_front_right);
  const double s2_170 = 4.625980413576839*std::abs(work.J_drag_link_pitman_arm);
  const double s2_171 = 1.0/work.J_arb_link_front_left_arb_front_left;
  const double s2_172 = 4.336650753223258*std::abs(work.J_arb_link_front_left_arb_front_left);
  const double s2_173 = 1.0/work.s2_40;
  const double s2_174 = mbgen::min(mbgen::min(s2_170, s2_169), s2_172);
  const double s2_175 = 1.0/work.s2_160;
  const double s2_176 = mbgen::min(s2_174, 3.3503257942070226*std::abs(work.s2_40));
  const double s2_177 = work.J_upper_ball_right_carrier_right_rz*s2_175;
  const double s2_178 = work.J_upper_ball_right_carrier_right_rx - work.s2_163*s2_177;
  const double s2_179 = work.J_upper_ball_right_carrier_right_ry - work.s2_166*s2_177;
  const double s2_180 = 1.0/s2_179;
  const double s2_181 = mbgen::min(s2_176, 5.556930741705859*std::abs(work.s2_160));
  const double s2_182 = work.s2_38*s2_173;
  const double s2_183 = work.J_upper_ball_right_carrier_right_rz_3*s2_182;
  const double s2_184 = s2_175*(work.J_upper_ball_right_carrier_right_rz_2 - s2_183);
  const double s2_185 = work.J_upper_ball_right_carrier_right_ry_3*s2_182;
  const double s2_186 = work.J_upper_ball_right_carrier_right_ry_2 - s2_185 - work.s2_166*s2_184;
  const double s2_187 = s2_180*s2_186;
  const double s2_188 = work.J_upper_ball_right_carrier_right_rx_3*s2_182;
  const double s2_189 = work.J_upper_ball_right_carrier_right_rx_2 - s2_188 - work.s2_163*s2_184;
  const double s2_190 = s2_189 - s2_178*s2_187;
  const double s2_191 = 1.0/s2_190;
  const double s2_192 = mbgen::min(s2_181, 2.6620449619787987*std::abs(s2_179));
  const double s2_193 = 1.0/work.s2_20;
  const double s2_194 = mbgen::min(s2_192, 2.732781487945307*std::abs(s2_190));
  const double s2_195 = 1.0/work.s2_139;
  const double s2_196 = mbgen::min(s2_194, 3.3514772255331233*std::abs(work.s2_20));
  const double s2_197 = work.J_upper_ball_left_upper_arm_left*s2_193;
  const double s2_198 = work.J_upper_ball_left_carrier_left_rx_3*s2_197;
  const double s2_199 = s2_195*(work.J_upper_ball_left_carrier_left_rx_2 + s2_198);
  const double s2_200 = work.J_upper_ball_left_carrier_left_rz_3*s2_197;
  const double s2_201 = work.J_upper_ball_left_carrier_left_rz_2 + s2_200 - work.s2_136*s2_199;
  const double s2_202 = work.J_upper_ball_left_carrier_left_ry_3*s2_197;
  const double s2_203 = work.J_upper_ball_left_carrier_left_ry_2 + s2_202 - work.s2_142*s2_199;
  const double s2_204 = 1.0/s2_203;
  const double s2_205 = mbgen::min(s2_196, 15.714736645766752*std::abs(work.s2_139));
  const double s2_206 = work.J_upper_ball_left_carrier_left_rx*s2_195;
  const double s2_207 = s2_204*(work.J_upper_ball_left_carrier_left_ry - work.s2_142*s2_206);
  const double s2_208 = work.J_upper_ball_left_carrier_left_rz - work.s2_136*s2_206;
  const double s2_209 = s2_208 - s2_201*s2_207;
  const double s2_210 = 1.0/s2_209;
  const double s2_211 = mbgen::min(s2_205, 5.864463449986124*std::abs(s2_203));
  result.pivot[0] = mbgen::min(s2_211, 0.43888841273380513*std::abs(s2_209));
  // long_rod_left
  const double s2_212 = 0.55*work.R_rear_axle_x_y;
  const double s2_213 = 0.04999999999999982*work.R_rear_axle_aux5_x_x;
  const double s2_214 = 0.55*work.R_rear_axle_y_y;
  const double s2_215 = 0.04999999999999982*work.R_rear_axle_aux5_y_x;
  const double s2_216 = 0.55*work.R_rear_axle_z_y;
  const double s1_35 = work.sines[15];
  const double s2_217 = 0.08000000000000002*work.R_rear_axle_z_z + 0.04999999999999982*s1_35;
  const double s2_218 = s2_213 - 0.08000000000000002*work.R_rear_axle_x_z;
  const double s2_219 = work.r_rear_axle_aux1_x + s2_218;
  const double s2_220 = s2_212 + s2_219;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s2_221 = z_rear_axle_ty + (s2_215 - 0.08000000000000002*work.R_rear_axle_y_z);
  const double s2_222 = s2_214 + s2_221;
  const double s2_223 = work.r_rear_axle_aux3_z + s2_216 - s2_217;
  const double s2_224 = 1.6 + s2_220;
  const double s2_225 = 0.55 - s2_222;
  const double s2_226 = 0.55 + s2_223;
  const double J_long_rod_left_rear_axle_tx = 1.1757385222540742*s2_224;
  const double s2_227 = 1.1757385222540742*s2_225;
  const double J_long_rod_left_rear_axle_tz = 1.1757385222540742*s2_226;
  const double s2_228 = s2_225*s2_227 - 0.8505292469985963 + s2_226*J_long_rod_left_rear_axle_tz;
  const double s2_229 = 0.5*(s2_228 + s2_224*J_long_rod_left_rear_axle_tx);
  result.residual[11] = s2_229;
  const double s2_230 = s2_223*s2_227 + s2_222*J_long_rod_left_rear_axle_tz;
  const double s2_231 = s2_220*J_long_rod_left_rear_axle_tz;
  const double s2_232 = s2_231 - s2_223*J_long_rod_left_rear_axle_tx;
  const double s2_233 = s2_222*J_long_rod_left_rear_axle_tx + s2_220*s2_227;
  const double s2_234 = work.R_rear_axle_aux5_y_x*s2_232 - s1_35*s2_233;
  const double s2_235 = s2_234 - work.R_rear_axle_aux5_x_x*s2_230 + work.b_rear_axle_rx_y*s2_227;
  const double s2_236 = work.b_rear_axle_rx_z*J_long_rod_left_rear_axle_tz;
  const double s2_237 = s2_235 + work.s1_41*J_long_rod_left_rear_axle_tx - s2_236;
  // diag_rod_left
  const double s2_238 = 0.1*work.R_rear_axle_x_y;
  const double s2_239 = 0.1*work.R_rear_axle_y_y;
  const double s2_240 = 0.1*work.R_rear_axle_z_y;
  const double s2_241 = work.r_rear_axle_aux1_x + 0.25*work.R_rear_axle_x_z;
  const double s2_242 = s2_238 + s2_241;
  const double s2_243 = z_rear_axle_ty + 0.25*work.R_rear_axle_y_z;
  const double s2_244 = s2_239 + s2_243;
  const double s2_245 = work.r_rear_axle_aux3_z + 0.25*work.R_rear_axle_z_z;
  const double s2_246 = s2_240 + s2_245;
  const double s2_247 = 1.6999999999999997 + s2_242;
  const double s2_248 = 0.4 - s2_244;
  const double s2_249 = 0.15000000000000002 + s2_246;
  const double J_diag_rod_left_rear_axle_tx = 1.162476387438193*s2_247;
  const double s2_250 = 1.162476387438193*s2_248;
  const double J_diag_rod_left_rear_axle_tz = 1.162476387438193*s2_249;
  const double s2_251 = s2_248*s2_250 - 0.8602325267042625 + s2_249*J_diag_rod_left_rear_axle_tz;
  const double s2_252 = 0.5*(s2_251 + s2_247*J_diag_rod_left_rear_axle_tx);
  result.residual[12] = s2_252;
  const double s2_253 = s2_246*s2_250 + s2_244*J_diag_rod_left_rear_axle_tz;
  const double s2_254 = s2_242*J_diag_rod_left_rear_axle_tz;
  const double s2_255 = s2_254 - s2_246*J_diag_rod_left_rear_axle_tx;
  const double s2_256 = s2_244*J_diag_rod_left_rear_axle_tx + s2_242*s2_250;
  const double s2_257 = work.R_rear_axle_aux5_y_x*s2_255 - s1_35*s2_256;
  const double s2_258 = s2_257 - work.R_rear_axle_aux5_x_x*s2_253 + work.b_rear_axle_rx_y*s2_250;
  const double s2_259 = work.b_rear_axle_rx_z*J_diag_rod_left_rear_axle_tz;
  const double s2_260 = s2_258 + work.s1_41*J_diag_rod_left_rear_axle_tx - s2_259;
  // arb_link_rear_left
  const double s2_261 = 0.6*work.R_rear_axle_x_y;
  const double s2_262 = 0.35000000000000053*work.R_rear_axle_aux5_x_x;
  const double s2_263 = 0.15000000000000002*work.R_rear_axle_x_z + s2_262;
  const double s2_264 = 0.6*work.R_rear_axle_y_y;
  const double s2_265 = 0.35000000000000053*work.R_rear_axle_aux5_y_x;
  const double s2_266 = 0.15000000000000002*work.R_rear_axle_y_z + s2_265;
  const double s2_267 = 0.6*work.R_rear_axle_z_y;
  const double s2_268 = work.r_rear_axle_aux1_x + s2_261 - s2_263;
  const double s2_269 = z_rear_axle_ty + s2_264 - s2_266;
  const double s2_270 = 0.35000000000000053*s1_35 - 0.15000000000000002*work.R_rear_axle_z_z;
  const double s2_271 = work.r_rear_axle_aux3_z + s2_270;
  const double s2_272 = s2_267 + s2_271;
  const double s2_273 = 0.35000000000000053*work.cosines[17] - 3.3000000000000003;
  const double s2_274 = 0.44999999999999996 + 0.35000000000000053*work.sines[17];
  const double s2_275 = s2_273 - s2_268;
  const double s2_276 = 0.6 - s2_269;
  const double s2_277 = s2_272 + s2_274;
  const double s2_278 = 4.472135954999581*s2_275;
  const double s2_279 = 4.472135954999581*s2_276;
  const double J_arb_link_rear_left_rear_axle_tz = 4.472135954999581*s2_277;
  const double s2_280 = s2_277*J_arb_link_rear_left_rear_axle_tz;
  const double s2_281 = 0.5*(s2_276*s2_279 - 0.22360679774997888 + s2_280 + s2_275*s2_278);
  result.residual[13] = s2_281;
  const double s2_282 = s2_272*s2_279 + s2_269*J_arb_link_rear_left_rear_axle_tz;
  const double s2_283 = s2_268*J_arb_link_rear_left_rear_axle_tz + s2_272*s2_278;
  const double s2_284 = s2_268*s2_279 - s2_269*s2_278;
  const double s2_285 = s2_284 + z_rear_axle_ty*s2_278 - work.r_rear_axle_aux1_x*s2_279;
  const double R_rear_axle_aux4_x_x = work.cosines[14];
  const double R_rear_axle_aux4_y_x = work.sines[14];
  const double s2_286 = R_rear_axle_aux4_x_x*s2_283 + R_rear_axle_aux4_y_x*s2_282;
  const double s2_287 = work.b_rear_axle_ry_z*J_arb_link_rear_left_rear_axle_tz;
  const double s2_288 = s2_286 - work.s1_37*s2_279 - s2_287 - work.s1_36*s2_278;
  const double s2_289 = work.R_rear_axle_aux5_y_x*s2_283 - s1_35*s2_284;
  const double s2_290 = s2_289 - work.R_rear_axle_aux5_x_x*s2_282 + work.b_rear_axle_rx_y*s2_279;
  const double s2_291 = s2_290 - work.b_rear_axle_rx_z*J_arb_link_rear_left_rear_axle_tz;
  const double s2_292 = s2_291 - work.s1_41*s2_278;
  const double s2_293 = J_arb_link_rear_left_rear_axle_tz*(3.3000000000000003 + s2_273);
  const double J_arb_link_rear_left_arb_rear_left = s2_278*(0.44999999999999996 - s2_274) + s2_293;
  // long_rod_right
  const double s2_294 = s2_219 - s2_212;
  const double s2_295 = s2_221 - s2_214;
  const double s2_296 = work.r_rear_axle_aux3_z - s2_216 - s2_217;
  const double s2_297 = 1.6 + s2_294;
  const double s2_298 = 0.55 + s2_295;
  const double s2_299 = 0.55 + s2_296;
  const double J_long_rod_right_rear_axle_tx = 1.1757385222540742*s2_297;
  const double J_long_rod_right_rear_axle_ty = 1.1757385222540742*s2_298;
  const double J_long_rod_right_rear_axle_tz = 1.1757385222540742*s2_299;
  const double s2_300 = s2_298*J_long_rod_right_rear_axle_ty - 0.8505292469985963;
  const double s2_301 = s2_300 + s2_299*J_long_rod_right_rear_axle_tz;
  const double s2_302 = 0.5*(s2_301 + s2_297*J_long_rod_right_rear_axle_tx);
  result.residual[14] = s2_302;
  const double s2_303 = s2_296*J_long_rod_right_rear_axle_ty;
  const double s2_304 = s2_303 - s2_295*J_long_rod_right_rear_axle_tz;
  const double s2_305 = s2_294*J_long_rod_right_rear_axle_tz;
  const double s2_306 = s2_305 - s2_296*J_long_rod_right_rear_axle_tx;
  const double s2_307 = s2_295*J_long_rod_right_rear_axle_tx;
  const double s2_308 = s2_307 - s2_294*J_long_rod_right_rear_axle_ty;
  const double s2_309 = work.R_rear_axle_aux5_y_x*s2_306 + work.R_rear_axle_aux5_x_x*s2_304;
  const double s2_310 = s2_309 - s1_35*s2_308 + work.s1_41*J_long_rod_right_rear_axle_tx;
  const double s2_311 = s2_310 - work.b_rear_axle_rx_z*J_long_rod_right_rear_axle_tz;
  const double s2_312 = s2_311 - work.b_rear_axle_rx_y*J_long_rod_right_rear_axle_ty;
  // diag_rod_right
  const double s2_313 = s2_241 - s2_238;
  const double s2_314 = s2_243 - s2_239;
  const double s2_315 = s2_245 - s2_240;
  const double s2_316 = 1.6999999999999997 + s2_313;
  const double s2_317 = 0.4 + s2_314;
  const double s2_318 = 0.15000000000000002 + s2_315;
  const double J_diag_rod_right_rear_axle_tx = 1.162476387438193*s2_316;
  const double J_diag_rod_right_rear_axle_ty = 1.162476387438193*s2_317;
  const double J_diag_rod_right_rear_axle_tz = 1.162476387438193*s2_318;
  const double s2_319 = s2_317*J_diag_rod_right_rear_axle_ty - 0.8602325267042625;
  const double s2_320 = s2_319 + s2_318*J_diag_rod_right_rear_axle_tz;
  const double s2_321 = 0.5*(s2_320 + s2_316*J_diag_rod_right_rear_axle_tx);
  result.residual[15] = s2_321;
  const double s2_322 = s2_315*J_diag_rod_right_rear_axle_ty;
  const double s2_323 = s2_322 - s2_314*J_diag_rod_right_rear_axle_tz;
  const double s2_324 = s2_313*J_diag_rod_right_rear_axle_tz;
  const double s2_325 = s2_324 - s2_315*J_diag_rod_right_rear_axle_tx;
  const double s2_326 = s2_314*J_diag_rod_right_rear_axle_tx;
  const double s2_327 = s2_326 - s2_313*J_diag_rod_right_rear_axle_ty;
  const double s2_328 = s2_327 + work.r_rear_axle_aux1_x*J_diag_rod_right_rear_axle_ty;
  const double s2_329 = s2_328 - z_rear_axle_ty*J_diag_rod_right_rear_axle_tx;
  const double s2_330 = R_rear_axle_aux4_x_x*s2_325 - R_rear_axle_aux4_y_x*s2_323;
  const double s2_331 = s2_330 + work.s1_37*J_diag_rod_right_rear_axle_ty;
  const double s2_332 = work.b_rear_axle_ry_z*J_diag_rod_right_rear_axle_tz;
  const double s2_333 = s2_331 + work.s1_36*J_diag_rod_right_rear_axle_tx - s2_332;
  const double s2_334 = work.R_rear_axle_aux5_y_x*s2_325 + work.R_rear_axle_aux5_x_x*s2_323;
  const double s2_335 = s2_334 - s1_35*s2_327 + work.s1_41*J_diag_rod_right_rear_axle_tx;
  const double s2_336 = s2_335 - work.b_rear_axle_rx_z*J_diag_rod_right_rear_axle_tz;
  const double s2_337 = s2_336 - work.b_rear_axle_rx_y*J_diag_rod_right_rear_axle_ty;
  // arb_link_rear_right
  const double s2_338 = work.r_rear_axle_aux1_x - s2_261 - s2_263;
  const double s2_339 = z_rear_axle_ty - s2_264 - s2_266;
  const double s2_340 = s2_271 - s2_267;
  const double s2_341 = 0.35000000000000053*work.cosines[18] - 3.3000000000000003;
  const double s2_342 = 0.44999999999999996 + 0.35000000000000053*work.sines[18];
  const double s2_343 = s2_341 - s2_338;
  const double s2_344 = 0.6 + s2_339;
  const double s2_345 = s2_340 + s2_342;
  const double s2_346 = 4.472135954999581*s2_343;
  const double J_arb_link_rear_right_rear_axle_ty = 4.472135954999581*s2_344;
  const double J_arb_link_rear_right_rear_axle_tz = 4.472135954999581*s2_345;
  const double s2_347 = s2_344*J_arb_link_rear_right_rear_axle_ty - 0.22360679774997888;
  const double s2_348 = 0.5*(s2_347 + s2_345*J_arb_link_rear_right_rear_axle_tz + s2_343*s2_346);
  result.residual[16] = s2_348;
  const double s2_349 = s2_340*J_arb_link_rear_right_rear_axle_ty;
  const double s2_350 = s2_349 - s2_339*J_arb_link_rear_right_rear_axle_tz;
  const double s2_351 = s2_338*J_arb_link_rear_right_rear_axle_tz + s2_340*s2_346;
  const double s2_352 = s2_339*s2_346 + s2_338*J_arb_link_rear_right_rear_axle_ty;
  const double s2_353 = work.r_rear_axle_aux1_x*J_arb_link_rear_right_rear_axle_ty - s2_352;
  const double s2_354 = s2_353 + z_rear_axle_ty*s2_346;
  const double s2_355 = R_rear_axle_aux4_x_x*s2_351 - R_rear_axle_aux4_y_x*s2_350;
  const double s2_356 = work.b_rear_axle_ry_z*J_arb_link_rear_right_rear_axle_tz;
  const double s2_357 = s2_355 + work.s1_37*J_arb_link_rear_right_rear_axle_ty - s2_356;
  const double s2_358 = s2_357 - work.s1_36*s2_346;
  const double s2_359 = work.R_rear_axle_aux5_y_x*s2_351 + s1_35*s2_352;
  const double s2_360 = work.b_rear_axle_rx_y*J_arb_link_rear_right_rear_axle_ty;
  const double s2_361 = work.b_rear_axle_rx_z*J_arb_link_rear_right_rear_axle_tz;
  const double s2_362 = s2_359 + work.R_rear_axle_aux5_x_x*s2_350 - s2_360 - s2_361;
  const double s2_363 = s2_362 - work.s1_41*s2_346;
  const double s2_364 = J_arb_link_rear_right_rear_axle_tz*(3.3000000000000003 + s2_341);
  const double J_arb_link_rear_right_arb_rear_right = s2_346*(0.44999999999999996 - s2_342) +
      s2_364;
  const double s2_365 = 1.0/J_arb_link_rear_right_arb_rear_right;
  const double s2_366 = 1.0/J_arb_link_rear_left_arb_rear_left;
  const double s2_367 = 3.204642123170383*std::abs(J_arb_link_rear_right_arb_rear_right);
  const double s2_368 = 3.194382824999693*std::abs(J_arb_link_rear_left_arb_rear_left);
  const double s2_369 = 1.0/J_diag_rod_right_rear_axle_tx;
  const double s2_370 = 1.0748203921841*std::abs(J_diag_rod_right_rear_axle_tx);
  const double s2_371 = J_long_rod_left_rear_axle_tx*s2_369;
  const double s2_372 = s2_227 + J_diag_rod_right_rear_axle_ty*s2_371;
  const double s2_373 = s2_329*s2_371 - s2_233 + work.r_rear_axle_aux1_x*s2_227;
  const double s2_374 = s2_373 + z_rear_axle_ty*J_long_rod_left_rear_axle_tx;
  const double s2_375 = s2_333*s2_371 - R_rear_axle_aux4_x_x*s2_232;
  const double s2_376 = work.s1_36*J_long_rod_left_rear_axle_tx;
  const double s2_377 = work.b_rear_axle_ry_z*J_long_rod_left_rear_axle_tz;
  const double s2_378 = s2_375 - R_rear_axle_aux4_y_x*s2_230 - s2_376 + s2_377;
  const double s2_379 = s2_378 + work.s1_37*s2_227;
  const double s2_380 = 1.0/s2_374;
  const double s2_381 = mbgen::min(mbgen::min(s2_367, s2_368), s2_370);
  const double s2_382 = J_long_rod_right_rear_axle_tx*s2_369;
  const double s2_383 = work.r_rear_axle_aux1_x*J_long_rod_right_rear_axle_ty;
  const double s2_384 = z_rear_axle_ty*J_long_rod_right_rear_axle_tx;
  const double s2_385 = s2_380*(s2_329*s2_382 - s2_308 - s2_383 + s2_384);
  const double s2_386 = J_long_rod_right_rear_axle_ty - J_diag_rod_right_rear_axle_ty*s2_382;
  const double s2_387 = s2_386 + s2_372*s2_385;
  const double s2_388 = s2_333*s2_382 - R_rear_axle_aux4_x_x*s2_306;
  const double s2_389 = work.s1_37*J_long_rod_right_rear_axle_ty;
  const double s2_390 = s2_388 + R_rear_axle_aux4_y_x*s2_304 - s2_389;
  const double s2_391 = work.b_rear_axle_ry_z*J_long_rod_right_rear_axle_tz;
  const double s2_392 = s2_390 - work.s1_36*J_long_rod_right_rear_axle_tx + s2_391;
  const double s2_393 = s2_392 - s2_379*s2_385;
  const double s2_394 = 1.0/s2_393;
  const double s2_395 = mbgen::min(s2_381, 1.5318884572025857*std::abs(s2_374));
  const double s2_396 = J_diag_rod_left_rear_axle_tx*s2_369;
  const double s2_397 = s2_329*s2_396 - s2_256 + work.r_rear_axle_aux1_x*s2_250;
  const double s2_398 = s2_380*(s2_397 + z_rear_axle_ty*J_diag_rod_left_rear_axle_tx);
  const double s2_399 = s2_333*s2_396 - R_rear_axle_aux4_x_x*s2_255;
  const double s2_400 = work.s1_36*J_diag_rod_left_rear_axle_tx;
  const double s2_401 = work.b_rear_axle_ry_z*J_diag_rod_left_rear_axle_tz;
  const double s2_402 = s2_399 - R_rear_axle_aux4_y_x*s2_253 - s2_400 + s2_401;
  const double s2_403 = s2_394*(s2_402 + work.s1_37*s2_250 - s2_379*s2_398);
  const double s2_404 = s2_372*s2_398 - s2_250 - J_diag_rod_right_rear_axle_ty*s2_396;
  const double s2_405 = s2_404 - s2_387*s2_403;
  const double s2_406 = 1.0/s2_405;
  const double s2_407 = mbgen::min(s2_395, 1.7893247478820993*std::abs(s2_393));
  result.pivot[1] = mbgen::min(s2_407, 1.4337752588788297*std::abs(s2_405));
  // operations: 430 add, 494 multiply, 17 divide, 32 other

  // --- step 4: velocities Z (36) ---
  // loop block 0
  const double s4_1 = work.s2_31 + work.s2_154*s2_177;
  const double s4_2 = work.s2_12 + work.s2_13*s2_197 + work.s2_130*s2_199;
  const double s4_3 = s2_210*(s2_207*s4_2 - work.s2_11 - work.s2_130*s2_206);
  result.dz[Coordinate::carrier_left_rz] = s4_3;
  const double s4_4 = s2_204*(s4_2 + s2_201*s4_3);
  result.dz[Coordinate::carrier_left_ry] = -s4_4;
  const double s4_5 = s2_195*(work.s2_136*s4_3 - work.s2_130 - work.s2_142*s4_4);
  result.dz[Coordinate::carrier_left_rx] = -s4_5;
  const double s4_6 = work.J_upper_ball_left_carrier_left_rx_3*s4_5 - work.s2_13;
  const double s4_7 = s4_6 + work.J_upper_ball_left_carrier_left_ry_3*s4_4;
  result.dz[Coordinate::upper_arm_left] = -(s2_193*(s4_7 -
      work.J_upper_ball_left_carrier_left_rz_3*s4_3));
  const double s4_8 = work.s2_33*s2_182 - work.s2_32 - work.s2_154*s2_184 + s2_187*s4_1;
  const double s4_9 = s2_191*s4_8;
  result.dz[Coordinate::carrier_right_rx] = s4_9;
  const double s4_10 = s2_180*(s4_1 + s2_178*s4_9);
  result.dz[Coordinate::carrier_right_ry] = -s4_10;
  const double s4_11 = s2_175*(work.s2_163*s4_9 - work.s2_154 - work.s2_166*s4_10);
  result.dz[Coordinate::carrier_right_rz] = -s4_11;
  const double s4_12 = work.J_upper_ball_right_carrier_right_rz_3*s4_11 - work.s2_33;
  const double s4_13 = s4_12 + work.J_upper_ball_right_carrier_right_ry_3*s4_10;
  result.dz[Coordinate::upper_arm_right] = -(s2_173*(s4_13 -
      work.J_upper_ball_right_carrier_right_rx_3*s4_9));
  const double s4_14 = work.s2_65*s4_3 - work.s2_59 - work.s2_68*s4_5 - work.s2_71*s4_4;
  result.dz[Coordinate::arb_front_left] = s2_171*s4_14;
  const double s4_15 = work.s2_99*s4_9 - work.s2_90 - work.s2_96*s4_11 - work.s2_102*s4_10;
  result.dz[Coordinate::arb_front_right] = s2_168*s4_15;
  result.dz[Coordinate::pitman_arm] = -(work.s2_113*s2_167);
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s4_16 = zd_lower_arm_left*work.J_upper_ball_left_lower_arm_left;
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double s4_17 = zd_lower_arm_right*work.J_upper_ball_right_lower_arm_right;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s4_18 = zd_bell_crank*work.J_tie_rod_left_bell_crank;
  const double s4_19 = zd_lower_arm_left*work.s2_134 - s4_18;
  const double s4_20 = zd_bell_crank*work.J_tie_rod_right_bell_crank;
  const double s4_21 = zd_lower_arm_right*work.s2_158 - s4_20;
  const double s4_22 = s2_177*s4_21;
  const double s4_23 = zd_lower_arm_right*work.s2_37 + s2_182*s4_17 + s2_184*s4_21;
  const double s4_24 = zd_lower_arm_left*work.s2_17 - s2_197*s4_16 + s2_199*s4_19;
  const double s4_25 = s2_210*(s2_206*s4_19 - s2_207*s4_24);
  result.zd[Coordinate::carrier_left_rz] = s4_25;
  const double s4_26 = s2_204*(s4_24 - s2_201*s4_25);
  result.zd[Coordinate::carrier_left_ry] = s4_26;
  const double s4_27 = s2_195*(s4_19 + work.s2_142*s4_26 + work.s2_136*s4_25);
  result.zd[Coordinate::carrier_left_rx] = -s4_27;
  const double s4_28 = work.J_upper_ball_left_carrier_left_rx_3*s4_27 - s4_16;
  const double s4_29 = s4_28 - work.J_upper_ball_left_carrier_left_ry_3*s4_26;
  result.zd[Coordinate::upper_arm_left] = -(s2_193*(s4_29 -
      work.J_upper_ball_left_carrier_left_rz_3*s4_25));
  const double s4_30 = s2_191*(s4_23 - s2_187*s4_22);
  result.zd[Coordinate::carrier_right_rx] = s4_30;
  const double s4_31 = s2_180*(s4_22 - s2_178*s4_30);
  result.zd[Coordinate::carrier_right_ry] = s4_31;
  const double s4_32 = s2_175*(s4_21 + work.s2_166*s4_31 + work.s2_163*s4_30);
  result.zd[Coordinate::carrier_right_rz] = -s4_32;
  const double s4_33 = work.J_upper_ball_right_carrier_right_rz_3*s4_32 - s4_17;
  const double s4_34 = s4_33 - work.J_upper_ball_right_carrier_right_ry_3*s4_31;
  result.zd[Coordinate::upper_arm_right] = -(s2_173*(s4_34 -
      work.J_upper_ball_right_carrier_right_rx_3*s4_30));
  const double s4_35 = zd_lower_arm_left*work.s2_63 - work.s2_68*s4_27 + work.s2_71*s4_26;
  result.zd[Coordinate::arb_front_left] = s2_171*(s4_35 + work.s2_65*s4_25);
  const double s4_36 = zd_lower_arm_right*work.s2_94 - work.s2_96*s4_32 + work.s2_102*s4_31;
  result.zd[Coordinate::arb_front_right] = s2_168*(s4_36 + work.s2_99*s4_30);
  result.zd[Coordinate::pitman_arm] = s2_167*(zd_bell_crank*work.s2_114);
  // loop block 1
  const double s4_37 = s2_321*s2_371 - s2_229;
  const double s4_38 = s2_321*s2_382 - s2_302 - s2_385*s4_37;
  const double s4_39 = s2_406*(s2_321*s2_396 - s2_252 - s2_398*s4_37 - s2_403*s4_38);
  result.dz[Coordinate::rear_axle_ty] = s4_39;
  const double s4_40 = s2_394*(s4_38 - s2_387*s4_39);
  result.dz[Coordinate::rear_axle_ry] = s4_40;
  const double s4_41 = s2_380*(s4_37 - s2_379*s4_40 + s2_372*s4_39);
  result.dz[Coordinate::rear_axle_rz] = s4_41;
  const double s4_42 = s2_329*s4_41 - s2_321 + s2_333*s4_40;
  const double s4_43 = s2_369*(s4_42 - J_diag_rod_right_rear_axle_ty*s4_39);
  result.dz[Coordinate::rear_axle_tx] = s4_43;
  const double s4_44 = s2_278*s4_43 - s2_281 + s2_285*s4_41 + s2_288*s4_40 + s2_279*s4_39;
  result.dz[Coordinate::arb_rear_left] = s2_366*s4_44;
  const double s4_45 = s2_346*s4_43 - s2_348 + s2_354*s4_41 + s2_358*s4_40;
  result.dz[Coordinate::arb_rear_right] = s2_365*(s4_45 - J_arb_link_rear_right_rear_axle_ty*s4_39);
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s4_46 = zd_rear_axle_rx*s2_337 - zd_rear_axle_tz*J_diag_rod_right_rear_axle_tz;
  const double s4_47 = zd_rear_axle_rx*s2_237 - zd_rear_axle_tz*J_long_rod_left_rear_axle_tz;
  const double s4_48 = s4_47 - s2_371*s4_46;
  const double s4_49 = zd_rear_axle_rx*s2_312 - zd_rear_axle_tz*J_long_rod_right_rear_axle_tz;
  const double s4_50 = s4_49 - s2_382*s4_46 - s2_385*s4_48;
  const double s4_51 = zd_rear_axle_rx*s2_260 - zd_rear_axle_tz*J_diag_rod_left_rear_axle_tz;
  const double s4_52 = s2_406*(s4_51 - s2_396*s4_46 - s2_398*s4_48 - s2_403*s4_50);
  result.zd[Coordinate::rear_axle_ty] = s4_52;
  const double s4_53 = s2_394*(s4_50 - s2_387*s4_52);
  result.zd[Coordinate::rear_axle_ry] = s4_53;
  const double s4_54 = s2_380*(s4_48 - s2_379*s4_53 + s2_372*s4_52);
  result.zd[Coordinate::rear_axle_rz] = s4_54;
  const double s4_55 = s4_46 + s2_329*s4_54 + s2_333*s4_53;
  const double s4_56 = s2_369*(s4_55 - J_diag_rod_right_rear_axle_ty*s4_52);
  result.zd[Coordinate::rear_axle_tx] = s4_56;
  const double s4_57 = zd_rear_axle_tz*J_arb_link_rear_left_rear_axle_tz;
  const double s4_58 = zd_rear_axle_rx*s2_292 - s4_57 + s2_278*s4_56 + s2_285*s4_54;
  result.zd[Coordinate::arb_rear_left] = s2_366*(s4_58 + s2_288*s4_53 + s2_279*s4_52);
  const double s4_59 = zd_rear_axle_tz*J_arb_link_rear_right_rear_axle_tz;
  const double s4_60 = zd_rear_axle_rx*s2_363 - s4_59 + s2_346*s4_56 + s2_354*s4_54;
  result.zd[Coordinate::arb_rear_right] = s2_365*(s4_60 + s2_358*s4_53 -
      J_arb_link_rear_right_rear_axle_ty*s4_52);
  // operations: 98 add, 149 multiply
  result.dz[Coordinate::chassis_tx] = 0.0;
  result.dz[Coordinate::chassis_ty] = 0.0;
  result.dz[Coordinate::chassis_tz] = 0.0;
  result.dz[Coordinate::chassis_rz] = 0.0;
  result.dz[Coordinate::chassis_ry] = 0.0;
  result.dz[Coordinate::chassis_rx] = 0.0;
  result.dz[Coordinate::lower_arm_left] = 0.0;
  result.dz[Coordinate::wheel_front_left] = 0.0;
  result.dz[Coordinate::lower_arm_right] = 0.0;
  result.dz[Coordinate::wheel_front_right] = 0.0;
  result.dz[Coordinate::bell_crank] = 0.0;
  result.dz[Coordinate::rear_axle_tz] = 0.0;
  result.dz[Coordinate::rear_axle_rx] = 0.0;
  result.dz[Coordinate::wheel_rear_left] = 0.0;
  result.dz[Coordinate::wheel_rear_right] = 0.0;
  result.zd[Coordinate::chassis_tx] = state.zd[Coordinate::chassis_tx];
  result.zd[Coordinate::chassis_ty] = state.zd[Coordinate::chassis_ty];
  result.zd[Coordinate::chassis_tz] = state.zd[Coordinate::chassis_tz];
  result.zd[Coordinate::chassis_rz] = state.zd[Coordinate::chassis_rz];
  result.zd[Coordinate::chassis_ry] = state.zd[Coordinate::chassis_ry];
  result.zd[Coordinate::chassis_rx] = state.zd[Coordinate::chassis_rx];
  result.zd[Coordinate::lower_arm_left] = zd_lower_arm_left;
  result.zd[Coordinate::wheel_front_left] = state.zd[Coordinate::wheel_front_left];
  result.zd[Coordinate::lower_arm_right] = zd_lower_arm_right;
  result.zd[Coordinate::wheel_front_right] = state.zd[Coordinate::wheel_front_right];
  result.zd[Coordinate::bell_crank] = zd_bell_crank;
  result.zd[Coordinate::rear_axle_tz] = zd_rear_axle_tz;
  result.zd[Coordinate::rear_axle_rx] = zd_rear_axle_rx;
  result.zd[Coordinate::wheel_rear_left] = state.zd[Coordinate::wheel_rear_left];
  result.zd[Coordinate::wheel_rear_right] = state.zd[Coordinate::wheel_rear_right];
}

/// One Newton step of the frozen partition, and consistent velocities.
void compute_closure(const Parameters& /*parameters*/, const Inputs& /*inputs*/, const State& state,
    Closure& __restrict result) noexcept {
  ClosureWork work;
  compute_closure_1(state, work, result);
  compute_closure_2(state, work, result);
}

/// Result of compute_multipliers.
struct ConstraintForces {
  double lambda[17];  ///< multipliers, loop after loop
  double drive[1];  ///< generalised driving forces
  double missing[22];  ///< what multipliers and drives must provide, block after block
  double pivot[2];  ///< smallest pivot of each block over its reference
};

/// Values of compute_multipliers that cross its parts.
struct ConstraintForcesWork {
  double
      sines[22], cosines[22], R_chassis_aux5_x_x, R_chassis_aux5_y_x, R_chassis_z_y, R_chassis_z_z,
      R_chassis_x_y, R_chassis_x_z, R_chassis_y_y, R_chassis_y_z, r_carrier_left_aux1_y,
      r_carrier_left_aux1_z, R_carrier_left_aux1_y_x, R_carrier_left_aux1_z_x, b_carrier_left_rz_x,
      s1_10, s1_11, s1_13, R_carrier_left_aux2_y_y, R_carrier_left_aux2_z_y, b_carrier_left_rx_x,
      b_carrier_left_rx_y, b_carrier_left_rx_z, R_carrier_left_x_x, R_carrier_left_y_x,
      R_carrier_left_z_x, R_carrier_left_x_z, R_carrier_left_y_z, R_carrier_left_z_z,
      b_carrier_left_ry_x, s1_22, b_carrier_left_ry_z, r_wheel_front_left_x, r_wheel_front_left_y,
      r_wheel_front_left_z, r_carrier_right_aux1_y, s1_30, R_carrier_right_aux1_y_x,
      R_carrier_right_aux1_z_x, b_carrier_right_rz_x, s1_33, s1_34, s1_36, R_carrier_right_aux2_y_y,
      R_carrier_right_aux2_z_y, b_carrier_right_rx_x, s1_40, b_carrier_right_rx_z,
      R_carrier_right_x_x, R_carrier_right_y_x, R_carrier_right_z_x, R_carrier_right_x_z,
      R_carrier_right_y_z, R_carrier_right_z_z, b_carrier_right_ry_x, b_carrier_right_ry_y,
      b_carrier_right_ry_z, r_wheel_front_right_x, r_wheel_front_right_y, r_wheel_front_right_z,
      r_rear_axle_aux1_x, r_rear_axle_aux3_z, R_rear_axle_aux5_x_x, R_rear_axle_aux5_y_x, s1_51,
      s1_52, b_rear_axle_ry_z, R_rear_axle_x_y, R_rear_axle_y_y, R_rear_axle_z_y, R_rear_axle_x_z,
      R_rear_axle_y_z, R_rear_axle_z_z, s1_56, b_rear_axle_rx_y, b_rear_axle_rx_z,
      r_wheel_rear_left_x, r_wheel_rear_left_y, r_wheel_rear_left_z, r_wheel_rear_right_x,
      r_wheel_rear_right_y, r_wheel_rear_right_z, s1_63, s1_65, s1_69, s1_70, s1_71, s1_74, s1_78,
      s1_82, s1_110, s1_112, s1_114, s1_116, s1_118, s1_120, s1_129, s1_131, s1_133, s1_135, s1_137,
      s1_139, s1_141, s1_143, s1_147, s1_148, s1_149, s1_151, s1_153, s1_156, s1_160, s1_164,
      s1_165, s1_166, s1_168, s1_170, s1_174, s1_175, s1_176, s1_179, s1_183, s1_186, s1_213,
      s1_215, s1_217, s1_219, s1_221, s1_223, s1_232, s1_234, s1_236, s1_238, s1_240, s1_242,
      s1_244, s1_246, s1_250, s1_251, s1_252, s1_254, s1_256, s1_259, s1_263, s1_267, s1_268,
      s1_269, s1_270, s1_271, s1_275, s1_276, s1_277, s1_279, s1_281, s1_287, s1_288, s1_289,
      s1_291, s1_293, s1_295, s1_309, s1_311, s1_312, s1_314, s1_316, s1_318, s1_327, s1_329,
      s1_330, s1_332, s1_334, s1_336, s1_337, s1_338, s1_339, s1_341, s1_344, s1_345, s1_346,
      s1_347, s1_348, s1_349, s1_351, s1_354, s1_355, s1_356, s1_359, s1_362, s1_365, s1_367,
      s1_369, s1_371, s1_375, s1_378, s1_380, s1_382, s1_383, s1_384, s1_385, s1_386, s1_387,
      s1_389, s1_391, s1_393, s1_395, s1_397, s1_402, s1_403, s1_404, s1_406, s1_408, s1_410,
      s1_411, s1_413, s1_414, s1_415, s1_424, s1_426, s1_427, s1_432, s1_434, s1_436, s1_444,
      s1_445, s1_448, s1_449, s1_450, s1_451, s1_452, s1_453, s1_454, s1_455, s1_456, s1_457,
      s1_458, s1_459, s1_460, s1_461, w_chassis_y, w_chassis_z, w_chassis_x, w_carrier_left_x,
      w_carrier_left_y, w_carrier_left_z, w_wheel_front_left_x, w_wheel_front_left_y,
      w_wheel_front_left_z, w_arb_front_left_y, w_carrier_right_x, w_carrier_right_y,
      w_carrier_right_z, w_wheel_front_right_x, w_wheel_front_right_y, w_wheel_front_right_z,
      w_upper_arm_right_x, w_arb_front_right_y, w_pitman_arm_y, w_bell_crank_z, w_rear_axle_aux4_z,
      s4_28, s4_29, w_rear_axle_aux5_x, w_rear_axle_aux5_y, s4_30, s4_31, s4_32, w_rear_axle_x,
      w_rear_axle_y, w_rear_axle_z, s4_33, s4_34, s4_35, w_wheel_rear_left_x, w_wheel_rear_left_y,
      w_wheel_rear_left_z, w_arb_rear_left_y, s4_36, s4_37, s4_38, w_wheel_rear_right_x,
      w_wheel_rear_right_y, w_wheel_rear_right_z, w_arb_rear_right_y, a_chassis_x, a_chassis_y,
      a_chassis_z, s7_5, s7_6, s7_7, s7_8, alpha_chassis_x, alpha_chassis_y, alpha_chassis_z, s7_12,
      s7_13, s7_14, s7_15, s7_16, s7_17, s7_18, s7_19, s7_20, s7_21, s7_22, alpha_lower_arm_left_x,
      s7_26, s7_27, s7_29, s7_30, s7_32, s7_33, a_lower_arm_left_y, a_lower_arm_left_z,
      alpha_carrier_left_x, alpha_carrier_left_y, alpha_carrier_left_z, s7_94, s7_95, s7_96, s7_97,
      s7_98, s7_99, s7_100, s7_101, s7_102, a_carrier_left_x, a_carrier_left_y, a_carrier_left_z,
      alpha_wheel_front_left_x, alpha_wheel_front_left_y, alpha_wheel_front_left_z, s7_120, s7_121,
      s7_122, s7_123, s7_124, s7_125, s7_126, s7_127, s7_128, a_wheel_front_left_x,
      a_wheel_front_left_y, a_wheel_front_left_z, alpha_upper_arm_left_x, s7_139, s7_140, s7_141,
      s7_142, s7_143, s7_144, a_upper_arm_left_y, a_upper_arm_left_z, alpha_arb_front_left_y,
      alpha_arb_front_left_x, alpha_arb_front_left_z, s7_152, s7_153, s7_154, s7_155, s7_156,
      s7_157, s7_158, s7_159, a_arb_front_left_x, a_arb_front_left_y, a_arb_front_left_z,
      alpha_lower_arm_right_x, s7_167, s7_168, s7_170, s7_171, s7_173, s7_174, a_lower_arm_right_y,
      a_lower_arm_right_z, alpha_carrier_right_x, alpha_carrier_right_y, alpha_carrier_right_z,
      s7_237, s7_238, s7_239, s7_240, s7_241, s7_242, s7_243, s7_244, s7_245, a_carrier_right_x,
      a_carrier_right_y, a_carrier_right_z, alpha_wheel_front_right_x, alpha_wheel_front_right_y,
      alpha_wheel_front_right_z, s7_263, s7_264, s7_265, s7_266, s7_267, s7_268, s7_269, s7_270,
      s7_271, s7_272, s7_273, a_wheel_front_right_x, a_wheel_front_right_y, s7_280,
      a_wheel_front_right_z, alpha_upper_arm_right_x, s7_284, s7_285, s7_286, s7_287, s7_288,
      s7_289, a_upper_arm_right_y, a_upper_arm_right_z, alpha_arb_front_right_y,
      alpha_arb_front_right_x, alpha_arb_front_right_z, s7_297, s7_299, s7_300, s7_301, s7_302,
      s7_304, a_arb_front_right_x, a_arb_front_right_z, alpha_pitman_arm_y, s7_313, s7_315, s7_317,
      s7_318, s7_320, a_pitman_arm_z, alpha_bell_crank_z, s7_326, s7_327, s7_329, s7_330,
      alpha_rear_axle_x, alpha_rear_axle_y, alpha_rear_axle_z, s7_393, s7_394, s7_395, s7_396,
      s7_397, s7_398, s7_399, s7_400, s7_401, a_rear_axle_x, a_rear_axle_y, a_rear_axle_z,
      alpha_wheel_rear_left_x, alpha_wheel_rear_left_y, alpha_wheel_rear_left_z, s7_420, s7_421,
      s7_422, s7_423, s7_424, s7_425, s7_426, s7_427, s7_428, a_wheel_rear_left_x,
      a_wheel_rear_left_y, a_wheel_rear_left_z, alpha_arb_rear_left_y, alpha_arb_rear_left_x,
      alpha_arb_rear_left_z, s7_441, s7_443, s7_444, s7_445, s7_446, s7_448, a_arb_rear_left_x,
      a_arb_rear_left_z, alpha_wheel_rear_right_x, alpha_wheel_rear_right_y,
      alpha_wheel_rear_right_z, s7_466, s7_467, s7_468, s7_469, s7_470, s7_471, s7_472, s7_473,
      s7_474, a_wheel_rear_right_x, a_wheel_rear_right_y, a_wheel_rear_right_z,
      alpha_arb_rear_right_y, alpha_arb_rear_right_x, alpha_arb_rear_right_z, s7_487, s7_489,
      s7_490, s7_491, s7_492, s7_494, a_arb_rear_right_x, a_arb_rear_right_z, s7_502, s7_503,
      s7_508, s7_509, s7_510, s7_514, s7_516, s7_519, s7_521, s7_522, s7_523, s7_525, s7_526,
      s7_527, s7_529, s7_530, s7_533, s7_534, s7_535, s7_537, s7_539, s7_540, s7_544, s7_546,
      s7_548, s7_550, s7_551, s7_558, s7_559, s7_560, s7_569, s7_570, s7_571, s7_574, s7_575,
      s7_579, s7_581, s7_582, s7_583, s7_584, s7_585, s7_586, s7_587, s7_588, s7_591, s7_592,
      s7_595, s7_597, s7_598, s7_601, s7_602, s7_603, s7_604, s7_608, s7_609, s7_610, s7_612,
      s7_614, s7_616, s7_623, s7_624, s7_625, s7_628, s7_631, s7_634, s7_637, s7_638, s7_639,
      s7_640, s7_644, s7_646, s7_648, s7_650, s7_651, s7_652, s7_655, s7_656, s7_657, s7_658,
      s7_662, s7_663, s7_664, s7_666, s7_668, s7_670, s7_671, Q_arb_rear_right, Q_arb_rear_left,
      Q_rear_axle_ry, Q_rear_axle_rz, Q_rear_axle_ty, Q_rear_axle_tx, Q_pitman_arm,
      Q_arb_front_right, Q_upper_arm_right, Q_carrier_right_ry, Q_carrier_right_rx,
      Q_carrier_right_rz, Q_arb_front_left, Q_upper_arm_left, Q_carrier_left_ry, Q_carrier_left_rx,
      Q_carrier_left_rz;
};

/// Part 1 of compute_multipliers: step 1: poses, axes b, accumulated inertias MR (50).
[[gnu::noinline]] void compute_multipliers_1(const State& state,
    ConstraintForcesWork& __restrict work) noexcept {
  // --- step 1: poses, axes b, accumulated inertias MR (50) ---
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
  const double s1_1 = work.sines[2];
  work.R_chassis_z_y = R_chassis_aux5_z_z*s1_1;
  const double s1_2 = work.cosines[2];
  work.R_chassis_z_z = R_chassis_aux5_z_z*s1_2;
  const double s1_3 = work.sines[1];
  const double s1_4 = s1_3*s1_1;
  const double s1_5 = s1_3*s1_2;
  work.R_chassis_x_y = R_chassis_aux4_x_x*s1_4 - R_chassis_aux4_y_x*s1_2;
  work.R_chassis_x_z = R_chassis_aux4_y_x*s1_1 + R_chassis_aux4_x_x*s1_5;
  work.R_chassis_y_y = R_chassis_aux4_x_x*s1_2 + R_chassis_aux4_y_x*s1_4;
  work.R_chassis_y_z = R_chassis_aux4_y_x*s1_5 - R_chassis_aux4_x_x*s1_1;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s1_6 = 0.4 + 0.44999999999999996*R_lower_arm_left_y_y;
  work.r_carrier_left_aux1_y = s1_6 + 0.04999999999999999*R_lower_arm_left_z_y;
  const double s1_7 = 0.44999999999999996*R_lower_arm_left_z_y - 0.62;
  work.r_carrier_left_aux1_z = s1_7 - 0.04999999999999999*R_lower_arm_left_y_y;
  const double s1_8 = work.sines[4];
  work.R_carrier_left_aux1_y_x = R_lower_arm_left_y_y*s1_8;
  work.R_carrier_left_aux1_z_x = R_lower_arm_left_z_y*s1_8;
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double R_carrier_left_aux1_y_y = R_lower_arm_left_y_y*R_carrier_left_aux1_x_x;
  const double R_carrier_left_aux1_z_y = R_lower_arm_left_z_y*R_carrier_left_aux1_x_x;
  const double s1_9 = R_lower_arm_left_z_y*work.r_carrier_left_aux1_z;
  work.b_carrier_left_rz_x = s1_9 + R_lower_arm_left_y_y*work.r_carrier_left_aux1_y;
  work.s1_10 = 3.6*R_lower_arm_left_y_y;
  work.s1_11 = 3.6*R_lower_arm_left_z_y;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_12 = work.cosines[5];
  work.s1_13 = s1_8*s1_12;
  const double s1_14 = work.sines[5];
  work.R_carrier_left_aux2_y_y = R_carrier_left_aux1_y_y*s1_12 - R_lower_arm_left_z_y*s1_14;
  work.R_carrier_left_aux2_z_y = R_carrier_left_aux1_z_y*s1_12 + R_lower_arm_left_y_y*s1_14;
  const double R_carrier_left_aux2_x_z = s1_8*s1_14;
  const double s1_15 = R_carrier_left_aux1_y_y*s1_14 + R_lower_arm_left_z_y*s1_12;
  const double R_carrier_left_aux2_z_z = R_lower_arm_left_y_y*s1_12 - R_carrier_left_aux1_z_y*s1_14;
  const double s1_16 = work.r_carrier_left_aux1_y*work.R_carrier_left_aux1_z_x;
  work.b_carrier_left_rx_x = s1_16 - work.r_carrier_left_aux1_z*work.R_carrier_left_aux1_y_x;
  const double s1_17 = work.r_carrier_left_aux1_z*R_carrier_left_aux1_x_x;
  work.b_carrier_left_rx_y = s1_17 - 3.6*work.R_carrier_left_aux1_z_x;
  const double s1_18 = work.r_carrier_left_aux1_y*R_carrier_left_aux1_x_x;
  work.b_carrier_left_rx_z = 3.6*work.R_carrier_left_aux1_y_x - s1_18;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_19 = work.cosines[6];
  const double s1_20 = work.sines[6];
  work.R_carrier_left_x_x = R_carrier_left_aux1_x_x*s1_19 - R_carrier_left_aux2_x_z*s1_20;
  work.R_carrier_left_y_x = s1_15*s1_20 + work.R_carrier_left_aux1_y_x*s1_19;
  work.R_carrier_left_z_x = work.R_carrier_left_aux1_z_x*s1_19 - R_carrier_left_aux2_z_z*s1_20;
  work.R_carrier_left_x_z = R_carrier_left_aux2_x_z*s1_19 + R_carrier_left_aux1_x_x*s1_20;
  work.R_carrier_left_y_z = work.R_carrier_left_aux1_y_x*s1_20 - s1_15*s1_19;
  work.R_carrier_left_z_z = R_carrier_left_aux2_z_z*s1_19 + work.R_carrier_left_aux1_z_x*s1_20;
  const double s1_21 = work.r_carrier_left_aux1_y*work.R_carrier_left_aux2_z_y;
  work.b_carrier_left_ry_x = s1_21 - work.r_carrier_left_aux1_z*work.R_carrier_left_aux2_y_y;
  work.s1_22 = 3.6*work.R_carrier_left_aux2_z_y + work.r_carrier_left_aux1_z*work.s1_13;
  work.b_carrier_left_ry_z = work.r_carrier_left_aux1_y*work.s1_13 +
      3.6*work.R_carrier_left_aux2_y_y;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s1_23 = 3.6 + 0.16999999999999998*work.R_carrier_left_x_z;
  work.r_wheel_front_left_x = s1_23 - 0.17499999999999993*work.s1_13;
  const double s1_24 = 0.17499999999999993*work.R_carrier_left_aux2_y_y;
  const double s1_25 = 0.16999999999999998*work.R_carrier_left_y_z;
  work.r_wheel_front_left_y = work.r_carrier_left_aux1_y + s1_24 + s1_25;
  const double s1_26 = 0.17499999999999993*work.R_carrier_left_aux2_z_y;
  const double s1_27 = 0.16999999999999998*work.R_carrier_left_z_z;
  work.r_wheel_front_left_z = work.r_carrier_left_aux1_z + s1_26 + s1_27;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_z_y = work.sines[9];
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s1_28 = 0.04999999999999999*R_lower_arm_right_z_y - 0.4;
  work.r_carrier_right_aux1_y = s1_28 - 0.44999999999999996*R_lower_arm_right_y_y;
  const double s1_29 = 0.62 + 0.44999999999999996*R_lower_arm_right_z_y;
  work.s1_30 = s1_29 + 0.04999999999999999*R_lower_arm_right_y_y;
  const double s1_31 = work.sines[10];
  work.R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_31;
  work.R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_31;
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  const double s1_32 = R_lower_arm_right_y_y*work.r_carrier_right_aux1_y;
  work.b_carrier_right_rz_x = s1_32 - R_lower_arm_right_z_y*work.s1_30;
  work.s1_33 = 3.6*R_lower_arm_right_y_y;
  work.s1_34 = 3.6*R_lower_arm_right_z_y;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_35 = work.cosines[11];
  work.s1_36 = s1_31*s1_35;
  const double s1_37 = work.sines[11];
  work.R_carrier_right_aux2_y_y = R_carrier_right_aux1_y_y*s1_35 - R_lower_arm_right_z_y*s1_37;
  work.R_carrier_right_aux2_z_y = R_carrier_right_aux1_z_y*s1_35 + R_lower_arm_right_y_y*s1_37;
  const double R_carrier_right_aux2_x_z = s1_31*s1_37;
  const double s1_38 = R_carrier_right_aux1_y_y*s1_37 + R_lower_arm_right_z_y*s1_35;
  const double R_carrier_right_aux2_z_z = R_lower_arm_right_y_y*s1_35 -
      R_carrier_right_aux1_z_y*s1_37;
  const double s1_39 = work.r_carrier_right_aux1_y*work.R_carrier_right_aux1_z_x;
  work.b_carrier_right_rx_x = work.s1_30*work.R_carrier_right_aux1_y_x + s1_39;
  work.s1_40 = 3.6*work.R_carrier_right_aux1_z_x + work.s1_30*R_carrier_right_aux1_x_x;
  const double s1_41 = work.r_carrier_right_aux1_y*R_carrier_right_aux1_x_x;
  work.b_carrier_right_rx_z = 3.6*work.R_carrier_right_aux1_y_x - s1_41;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_42 = work.cosines[12];
  const double s1_43 = work.sines[12];
  work.R_carrier_right_x_x = R_carrier_right_aux1_x_x*s1_42 - R_carrier_right_aux2_x_z*s1_43;
  work.R_carrier_right_y_x = s1_38*s1_43 + work.R_carrier_right_aux1_y_x*s1_42;
  work.R_carrier_right_z_x = work.R_carrier_right_aux1_z_x*s1_42 - R_carrier_right_aux2_z_z*s1_43;
  work.R_carrier_right_x_z = R_carrier_right_aux2_x_z*s1_42 + R_carrier_right_aux1_x_x*s1_43;
  work.R_carrier_right_y_z = work.R_carrier_right_aux1_y_x*s1_43 - s1_38*s1_42;
  work.R_carrier_right_z_z = R_carrier_right_aux2_z_z*s1_42 + work.R_carrier_right_aux1_z_x*s1_43;
  const double s1_44 = work.r_carrier_right_aux1_y*work.R_carrier_right_aux2_z_y;
  work.b_carrier_right_ry_x = work.s1_30*work.R_carrier_right_aux2_y_y + s1_44;
  work.b_carrier_right_ry_y = work.s1_30*work.s1_36 - 3.6*work.R_carrier_right_aux2_z_y;
  const double s1_45 = work.r_carrier_right_aux1_y*work.s1_36;
  work.b_carrier_right_ry_z = s1_45 + 3.6*work.R_carrier_right_aux2_y_y;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s1_46 = 0.16999999999999998*work.R_carrier_right_x_z;
  work.r_wheel_front_right_x = 3.6 + 0.17499999999999993*work.s1_36 + s1_46;
  const double s1_47 = 0.16999999999999998*work.R_carrier_right_y_z;
  const double s1_48 = 0.17499999999999993*work.R_carrier_right_aux2_y_y;
  work.r_wheel_front_right_y = work.r_carrier_right_aux1_y + s1_47 - s1_48;
  const double s1_49 = 0.16999999999999998*work.R_carrier_right_z_z - work.s1_30;
  work.r_wheel_front_right_z = s1_49 - 0.17499999999999993*work.R_carrier_right_aux2_z_y;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - 2.4999999999999996;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  work.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] - 0.5;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double R_rear_axle_aux5_z_z = work.cosines[18];
  work.R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double s1_50 = work.sines[18];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_50;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_50;
  work.s1_51 = work.r_rear_axle_aux3_z*R_rear_axle_aux4_x_x;
  work.s1_52 = work.r_rear_axle_aux3_z*R_rear_axle_aux4_y_x;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s1_53 = work.r_rear_axle_aux1_x*R_rear_axle_aux4_x_x;
  work.b_rear_axle_ry_z = z_rear_axle_ty*R_rear_axle_aux4_y_x + s1_53;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_54 = work.sines[19];
  const double s1_55 = work.cosines[19];
  work.R_rear_axle_x_y = R_rear_axle_aux5_x_z*s1_54 - R_rear_axle_aux4_y_x*s1_55;
  work.R_rear_axle_y_y = R_rear_axle_aux4_x_x*s1_55 + R_rear_axle_aux5_y_z*s1_54;
  work.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_54;
  work.R_rear_axle_x_z = R_rear_axle_aux4_y_x*s1_54 + R_rear_axle_aux5_x_z*s1_55;
  work.R_rear_axle_y_z = R_rear_axle_aux5_y_z*s1_55 - R_rear_axle_aux4_x_x*s1_54;
  work.R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_55;
  work.s1_56 = work.r_rear_axle_aux3_z*work.R_rear_axle_aux5_y_x + z_rear_axle_ty*s1_50;
  const double s1_57 = work.r_rear_axle_aux3_z*work.R_rear_axle_aux5_x_x;
  work.b_rear_axle_rx_y = work.r_rear_axle_aux1_x*s1_50 + s1_57;
  const double s1_58 = work.r_rear_axle_aux1_x*work.R_rear_axle_aux5_y_x;
  work.b_rear_axle_rx_z = s1_58 - z_rear_axle_ty*work.R_rear_axle_aux5_x_x;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s1_59 = 0.93*work.R_rear_axle_x_y;
  const double s1_60 = 0.93*work.R_rear_axle_y_y;
  const double s1_61 = 0.93*work.R_rear_axle_z_y;
  work.r_wheel_rear_left_x = work.r_rear_axle_aux1_x + s1_59;
  work.r_wheel_rear_left_y = z_rear_axle_ty + s1_60;
  work.r_wheel_rear_left_z = work.r_rear_axle_aux3_z + s1_61;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  work.r_wheel_rear_right_x = work.r_rear_axle_aux1_x - s1_59;
  work.r_wheel_rear_right_y = z_rear_axle_ty - s1_60;
  work.r_wheel_rear_right_z = work.r_rear_axle_aux3_z - s1_61;
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s1_62 = 0.4 + 0.21999999999999997*R_lower_arm_left_y_y;
  work.s1_63 = s1_62 + 0.025000000000000022*R_lower_arm_left_z_y;
  const double s1_64 = 0.21999999999999997*R_lower_arm_left_z_y - 0.62;
  work.s1_65 = s1_64 - 0.025000000000000022*R_lower_arm_left_y_y;
  const double s1_66 = 0.25*R_lower_arm_left_z_y;
  const double s1_67 = 0.8*R_lower_arm_left_y_y;
  const double s1_68 = R_lower_arm_left_y_y*(0.25*R_lower_arm_left_y_y);
  work.s1_69 = s1_68 + R_lower_arm_left_z_y*(0.8*R_lower_arm_left_z_y);
  work.s1_70 = R_lower_arm_left_z_y*s1_66 + R_lower_arm_left_y_y*s1_67;
  work.s1_71 = R_lower_arm_left_y_y*s1_66 - R_lower_arm_left_z_y*s1_67;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_72 = 3.6 + 0.16710914454277284*work.R_carrier_left_x_z;
  const double s1_73 = s1_72 - 0.003952802359882006*work.R_carrier_left_x_x;
  work.s1_74 = s1_73 - 0.07666666666666674*work.s1_13;
  const double s1_75 = 0.07666666666666674*work.R_carrier_left_aux2_y_y;
  const double s1_76 = 0.16710914454277284*work.R_carrier_left_y_z;
  const double s1_77 = 0.003952802359882006*work.R_carrier_left_y_x;
  work.s1_78 = work.r_carrier_left_aux1_y + s1_75 + s1_76 - s1_77;
  const double s1_79 = 0.07666666666666674*work.R_carrier_left_aux2_z_y;
  const double s1_80 = 0.16710914454277284*work.R_carrier_left_z_z;
  const double s1_81 = 0.003952802359882006*work.R_carrier_left_z_x;
  work.s1_82 = work.r_carrier_left_aux1_z + s1_79 + s1_80 - s1_81;
  const double s1_83 = 3.081700098328417*work.R_carrier_left_x_x;
  const double s1_84 = 0.04070875122910521*work.R_carrier_left_x_z;
  const double s1_85 = 0.039511111111111115*work.R_carrier_left_x_z;
  const double s1_86 = 0.05791111111111111*work.R_carrier_left_x_x;
  const double s1_87 = 3.1640788593903637*work.R_carrier_left_x_z;
  const double s1_88 = 0.04070875122910521*work.R_carrier_left_x_x;
  const double s1_89 = 0.04070875122910521*work.R_carrier_left_y_z;
  const double s1_90 = 3.081700098328417*work.R_carrier_left_y_x - s1_89;
  const double s1_91 = s1_90 - 0.05791111111111111*work.R_carrier_left_aux2_y_y;
  const double s1_92 = 2.6532900688298917*work.R_carrier_left_aux2_y_y;
  const double s1_93 = s1_92 - 0.039511111111111115*work.R_carrier_left_y_z;
  const double s1_94 = s1_93 - 0.05791111111111111*work.R_carrier_left_y_x;
  const double s1_95 = 0.04070875122910521*work.R_carrier_left_y_x;
  const double s1_96 = 3.1640788593903637*work.R_carrier_left_y_z - s1_95;
  const double s1_97 = s1_96 - 0.039511111111111115*work.R_carrier_left_aux2_y_y;
  const double s1_98 = 0.04070875122910521*work.R_carrier_left_z_z;
  const double s1_99 = 3.081700098328417*work.R_carrier_left_z_x - s1_98;
  const double s1_100 = s1_99 - 0.05791111111111111*work.R_carrier_left_aux2_z_y;
  const double s1_101 = 2.6532900688298917*work.R_carrier_left_aux2_z_y;
  const double s1_102 = s1_101 - 0.039511111111111115*work.R_carrier_left_z_z;
  const double s1_103 = s1_102 - 0.05791111111111111*work.R_carrier_left_z_x;
  const double s1_104 = 0.04070875122910521*work.R_carrier_left_z_x;
  const double s1_105 = 3.1640788593903637*work.R_carrier_left_z_z - s1_104;
  const double s1_106 = s1_105 - 0.039511111111111115*work.R_carrier_left_aux2_z_y;
  const double s1_107 = 0.039511111111111115*work.s1_13 + s1_87 - s1_88;
  const double s1_108 = work.s1_13*(2.6532900688298917*work.s1_13 + s1_85 + s1_86);
  const double s1_109 = work.R_carrier_left_x_x*(0.05791111111111111*work.s1_13 + s1_83 - s1_84);
  work.s1_110 = s1_108 + work.R_carrier_left_x_z*s1_107 + s1_109;
  const double s1_111 = work.R_carrier_left_aux2_y_y*s1_94 + work.R_carrier_left_y_z*s1_97;
  work.s1_112 = s1_111 + work.R_carrier_left_y_x*s1_91;
  const double s1_113 = work.R_carrier_left_aux2_z_y*s1_103 + work.R_carrier_left_z_z*s1_106;
  work.s1_114 = s1_113 + work.R_carrier_left_z_x*s1_100;
  const double s1_115 = work.R_carrier_left_x_z*s1_97 + work.R_carrier_left_x_x*s1_91;
  work.s1_116 = s1_115 - work.s1_13*s1_94;
  const double s1_117 = work.R_carrier_left_x_z*s1_106 + work.R_carrier_left_x_x*s1_100;
  work.s1_118 = s1_117 - work.s1_13*s1_103;
  const double s1_119 = work.R_carrier_left_aux2_y_y*s1_103 + work.R_carrier_left_y_z*s1_106;
  work.s1_120 = s1_119 + work.R_carrier_left_y_x*s1_100;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s1_121 = 6.0*work.R_carrier_left_y_x;
  const double s1_122 = 11.0*work.R_carrier_left_aux2_y_y;
  const double s1_123 = 6.0*work.R_carrier_left_y_z;
  const double s1_124 = 6.0*work.R_carrier_left_z_x;
  const double s1_125 = 11.0*work.R_carrier_left_aux2_z_y;
  const double s1_126 = 6.0*work.R_carrier_left_z_z;
  const double s1_127 = work.R_carrier_left_x_z*(6.0*work.R_carrier_left_x_z);
  const double s1_128 = work.R_carrier_left_x_x*(6.0*work.R_carrier_left_x_x);
  work.s1_129 = work.s1_13*(11.0*work.s1_13) + s1_127 + s1_128;
  const double s1_130 = work.R_carrier_left_aux2_y_y*s1_122 + work.R_carrier_left_y_z*s1_123;
  work.s1_131 = s1_130 + work.R_carrier_left_y_x*s1_121;
  const double s1_132 = work.R_carrier_left_aux2_z_y*s1_125 + work.R_carrier_left_z_z*s1_126;
  work.s1_133 = s1_132 + work.R_carrier_left_z_x*s1_124;
  const double s1_134 = work.R_carrier_left_x_z*s1_123 + work.R_carrier_left_x_x*s1_121;
  work.s1_135 = s1_134 - work.s1_13*s1_122;
  const double s1_136 = work.R_carrier_left_x_z*s1_126 + work.R_carrier_left_x_x*s1_124;
  work.s1_137 = s1_136 - work.s1_13*s1_125;
  const double s1_138 = work.R_carrier_left_aux2_y_y*s1_125 + work.R_carrier_left_y_z*s1_126;
  work.s1_139 = s1_138 + work.R_carrier_left_y_x*s1_124;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double R_upper_arm_left_z_y = work.sines[7];
  const double s1_140 = 0.5 + 0.15000000000000002*R_upper_arm_left_y_y;
  work.s1_141 = s1_140 + 0.010000000000000009*R_upper_arm_left_z_y;
  const double s1_142 = 0.15000000000000002*R_upper_arm_left_z_y - 0.28;
  work.s1_143 = s1_142 - 0.010000000000000009*R_upper_arm_left_y_y;
  const double s1_144 = 0.1*R_upper_arm_left_z_y;
  const double s1_145 = 0.25*R_upper_arm_left_y_y;
  const double s1_146 = R_upper_arm_left_z_y*(0.25*R_upper_arm_left_z_y);
  work.s1_147 = R_upper_arm_left_y_y*(0.1*R_upper_arm_left_y_y) + s1_146;
  work.s1_148 = R_upper_arm_left_z_y*s1_144 + R_upper_arm_left_y_y*s1_145;
  work.s1_149 = R_upper_arm_left_y_y*s1_144 - R_upper_arm_left_z_y*s1_145;
  // arb_front_left: arb_front_left, revolute, chassis
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s1_150 = 3.95 + 0.053846153846153884*R_arb_front_left_x_z;
  work.s1_151 = s1_150 - 0.1392307692307692*R_arb_front_left_x_x;
  const double s1_152 = 0.053846153846153884*R_arb_front_left_x_x - 0.5;
  work.s1_153 = s1_152 + 0.1392307692307692*R_arb_front_left_x_z;
  const double s1_154 = 0.003692307692307688*R_arb_front_left_x_z;
  const double s1_155 = 0.016246153846153844*R_arb_front_left_x_x;
  work.s1_156 = s1_155 - 0.00676923076923076*R_arb_front_left_x_z;
  const double s1_157 = 0.003692307692307688*R_arb_front_left_x_x;
  const double s1_158 = s1_157 - 0.18132307692307692*R_arb_front_left_x_z;
  const double s1_159 = 0.016246153846153844*R_arb_front_left_x_z;
  work.s1_160 = 0.00676923076923076*R_arb_front_left_x_x + s1_159;
  const double s1_161 = 0.23864615384615384*R_arb_front_left_x_x - s1_154;
  const double s1_162 = R_arb_front_left_x_z*(s1_157 + 0.23864615384615384*R_arb_front_left_x_z);
  const double s1_163 = R_arb_front_left_x_x*(s1_154 + 0.18132307692307692*R_arb_front_left_x_x);
  work.s1_164 = s1_162 + s1_163;
  work.s1_165 = R_arb_front_left_x_x*s1_161 - R_arb_front_left_x_z*s1_158;
  work.s1_166 = R_arb_front_left_x_z*s1_161 + R_arb_front_left_x_x*s1_158;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double s1_167 = 0.025000000000000022*R_lower_arm_right_z_y - 0.4;
  work.s1_168 = s1_167 - 0.21999999999999997*R_lower_arm_right_y_y;
  const double s1_169 = 0.62 + 0.21999999999999997*R_lower_arm_right_z_y;
  work.s1_170 = s1_169 + 0.025000000000000022*R_lower_arm_right_y_y;
  const double s1_171 = 0.25*R_lower_arm_right_z_y;
  const double s1_172 = 0.8*R_lower_arm_right_y_y;
  const double s1_173 = R_lower_arm_right_y_y*(0.25*R_lower_arm_right_y_y);
  work.s1_174 = s1_173 + R_lower_arm_right_z_y*(0.8*R_lower_arm_right_z_y);
  work.s1_175 = R_lower_arm_right_z_y*s1_171 + R_lower_arm_right_y_y*s1_172;
  work.s1_176 = R_lower_arm_right_y_y*s1_171 - R_lower_arm_right_z_y*s1_172;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_177 = 0.16710914454277284*work.R_carrier_right_x_z;
  const double s1_178 = 3.6 + 0.07666666666666674*work.s1_36 + s1_177;
  work.s1_179 = s1_178 - 0.003952802359882006*work.R_carrier_right_x_x;
  const double s1_180 = 0.16710914454277284*work.R_carrier_right_y_z;
  const double s1_181 = 0.003952802359882006*work.R_carrier_right_y_x;
  const double s1_182 = 0.07666666666666674*work.R_carrier_right_aux2_y_y;
  work.s1_183 = work.r_carrier_right_aux1_y + s1_180 - s1_181 - s1_182;
  const double s1_184 = 0.16710914454277284*work.R_carrier_right_z_z - work.s1_30;
  const double s1_185 = s1_184 - 0.003952802359882006*work.R_carrier_right_z_x;
  work.s1_186 = s1_185 - 0.07666666666666674*work.R_carrier_right_aux2_z_y;
  const double s1_187 = 0.04070875122910521*work.R_carrier_right_x_z;
  const double s1_188 = 3.081700098328417*work.R_carrier_right_x_x - s1_187;
  const double s1_189 = 0.039511111111111115*work.R_carrier_right_x_z;
  const double s1_190 = s1_189 + 0.05791111111111111*work.R_carrier_right_x_x;
  const double s1_191 = 0.04070875122910521*work.R_carrier_right_x_x;
  const double s1_192 = 3.1640788593903637*work.R_carrier_right_x_z - s1_191;
  const double s1_193 = 0.05791111111111111*work.R_carrier_right_aux2_y_y;
  const double s1_194 = s1_193 + 3.081700098328417*work.R_carrier_right_y_x;
  const double s1_195 = s1_194 - 0.04070875122910521*work.R_carrier_right_y_z;
  const double s1_196 = 2.6532900688298917*work.R_carrier_right_aux2_y_y;
  const double s1_197 = s1_196 + 0.039511111111111115*work.R_carrier_right_y_z;
  const double s1_198 = s1_197 + 0.05791111111111111*work.R_carrier_right_y_x;
  const double s1_199 = 0.039511111111111115*work.R_carrier_right_aux2_y_y;
  const double s1_200 = s1_199 + 3.1640788593903637*work.R_carrier_right_y_z;
  const double s1_201 = s1_200 - 0.04070875122910521*work.R_carrier_right_y_x;
  const double s1_202 = 0.05791111111111111*work.R_carrier_right_aux2_z_y;
  const double s1_203 = s1_202 + 3.081700098328417*work.R_carrier_right_z_x;
  const double s1_204 = s1_203 - 0.04070875122910521*work.R_carrier_right_z_z;
  const double s1_205 = 2.6532900688298917*work.R_carrier_right_aux2_z_y;
  const double s1_206 = s1_205 + 0.039511111111111115*work.R_carrier_right_z_z;
  const double s1_207 = s1_206 + 0.05791111111111111*work.R_carrier_right_z_x;
  const double s1_208 = 0.039511111111111115*work.R_carrier_right_aux2_z_y;
  const double s1_209 = s1_208 + 3.1640788593903637*work.R_carrier_right_z_z;
  const double s1_210 = s1_209 - 0.04070875122910521*work.R_carrier_right_z_x;
  const double s1_211 = work.R_carrier_right_x_z*(s1_192 - 0.039511111111111115*work.s1_36);
  const double s1_212 = work.R_carrier_right_x_x*(s1_188 - 0.05791111111111111*work.s1_36);
  work.s1_213 = s1_211 + s1_212 - work.s1_36*(s1_190 - 2.6532900688298917*work.s1_36);
  const double s1_214 = work.R_carrier_right_aux2_y_y*s1_198 + work.R_carrier_right_y_z*s1_201;
  work.s1_215 = s1_214 + work.R_carrier_right_y_x*s1_195;
  const double s1_216 = work.R_carrier_right_aux2_z_y*s1_207 + work.R_carrier_right_z_z*s1_210;
  work.s1_217 = s1_216 + work.R_carrier_right_z_x*s1_204;
  const double s1_218 = work.R_carrier_right_x_z*s1_201 + work.R_carrier_right_x_x*s1_195;
  work.s1_219 = s1_218 - work.s1_36*s1_198;
  const double s1_220 = work.R_carrier_right_x_z*s1_210 + work.R_carrier_right_x_x*s1_204;
  work.s1_221 = s1_220 - work.s1_36*s1_207;
  const double s1_222 = work.R_carrier_right_aux2_y_y*s1_207 + work.R_carrier_right_y_z*s1_210;
  work.s1_223 = s1_222 + work.R_carrier_right_y_x*s1_204;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s1_224 = 6.0*work.R_carrier_right_y_x;
  const double s1_225 = 11.0*work.R_carrier_right_aux2_y_y;
  const double s1_226 = 6.0*work.R_carrier_right_y_z;
  const double s1_227 = 6.0*work.R_carrier_right_z_x;
  const double s1_228 = 11.0*work.R_carrier_right_aux2_z_y;
  const double s1_229 = 6.0*work.R_carrier_right_z_z;
  const double s1_230 = work.R_carrier_right_x_z*(6.0*work.R_carrier_right_x_z);
  const double s1_231 = work.R_carrier_right_x_x*(6.0*work.R_carrier_right_x_x);
  work.s1_232 = work.s1_36*(11.0*work.s1_36) + s1_230 + s1_231;
  const double s1_233 = work.R_carrier_right_aux2_y_y*s1_225 + work.R_carrier_right_y_z*s1_226;
  work.s1_234 = s1_233 + work.R_carrier_right_y_x*s1_224;
  const double s1_235 = work.R_carrier_right_aux2_z_y*s1_228 + work.R_carrier_right_z_z*s1_229;
  work.s1_236 = s1_235 + work.R_carrier_right_z_x*s1_227;
  const double s1_237 = work.R_carrier_right_x_z*s1_226 + work.R_carrier_right_x_x*s1_224;
  work.s1_238 = s1_237 - work.s1_36*s1_225;
  const double s1_239 = work.R_carrier_right_x_z*s1_229 + work.R_carrier_right_x_x*s1_227;
  work.s1_240 = s1_239 - work.s1_36*s1_228;
  const double s1_241 = work.R_carrier_right_aux2_y_y*s1_228 + work.R_carrier_right_y_z*s1_229;
  work.s1_242 = s1_241 + work.R_carrier_right_y_x*s1_227;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s1_243 = 0.010000000000000009*R_upper_arm_right_z_y - 0.5;
  work.s1_244 = s1_243 - 0.15000000000000002*R_upper_arm_right_y_y;
  const double s1_245 = 0.28 + 0.15000000000000002*R_upper_arm_right_z_y;
  work.s1_246 = s1_245 + 0.010000000000000009*R_upper_arm_right_y_y;
  const double s1_247 = 0.1*R_upper_arm_right_z_y;
  const double s1_248 = 0.25*R_upper_arm_right_y_y;
  const double s1_249 = R_upper_arm_right_z_y*(0.25*R_upper_arm_right_z_y);
  work.s1_250 = R_upper_arm_right_y_y*(0.1*R_upper_arm_right_y_y) + s1_249;
  work.s1_251 = R_upper_arm_right_z_y*s1_247 + R_upper_arm_right_y_y*s1_248;
  work.s1_252 = R_upper_arm_right_y_y*s1_247 - R_upper_arm_right_z_y*s1_248;
  // arb_front_right: arb_front_right, revolute, chassis
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s1_253 = 3.95 + 0.053846153846153884*R_arb_front_right_x_z;
  work.s1_254 = s1_253 - 0.1392307692307692*R_arb_front_right_x_x;
  const double s1_255 = 0.053846153846153884*R_arb_front_right_x_x - 0.5;
  work.s1_256 = s1_255 + 0.1392307692307692*R_arb_front_right_x_z;
  const double s1_257 = 0.003692307692307688*R_arb_front_right_x_z;
  const double s1_258 = 0.016246153846153844*R_arb_front_right_x_x;
  work.s1_259 = 0.00676923076923076*R_arb_front_right_x_z - s1_258;
  const double s1_260 = 0.003692307692307688*R_arb_front_right_x_x;
  const double s1_261 = s1_260 - 0.18132307692307692*R_arb_front_right_x_z;
  const double s1_262 = 0.016246153846153844*R_arb_front_right_x_z;
  work.s1_263 = 0.00676923076923076*R_arb_front_right_x_x + s1_262;
  const double s1_264 = 0.23864615384615384*R_arb_front_right_x_x - s1_257;
  const double s1_265 = s1_260 + 0.23864615384615384*R_arb_front_right_x_z;
  const double s1_266 = s1_257 + 0.18132307692307692*R_arb_front_right_x_x;
  work.s1_267 = R_arb_front_right_x_z*s1_265 + R_arb_front_right_x_x*s1_266;
  work.s1_268 = R_arb_front_right_x_x*s1_264 - R_arb_front_right_x_z*s1_261;
  work.s1_269 = R_arb_front_right_x_z*s1_264 + R_arb_front_right_x_x*s1_261;
  // pitman_arm: pitman_arm, revolute, chassis
  const double R_pitman_arm_x_z = work.sines[15];
  work.s1_270 = 4.4 - 0.14666666666666664*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = work.cosines[15];
  work.s1_271 = 0.4 + 0.14666666666666664*R_pitman_arm_x_x;
  const double s1_272 = 0.0742*R_pitman_arm_x_z;
  const double s1_273 = 0.03*R_pitman_arm_x_x;
  const double s1_274 = R_pitman_arm_x_x*(0.0742*R_pitman_arm_x_x);
  work.s1_275 = R_pitman_arm_x_z*(0.03*R_pitman_arm_x_z) + s1_274;
  work.s1_276 = R_pitman_arm_x_x*s1_273 + R_pitman_arm_x_z*s1_272;
  work.s1_277 = R_pitman_arm_x_z*s1_273 - R_pitman_arm_x_x*s1_272;
  // bell_crank: bell_crank, revolute, chassis
  const double R_bell_crank_x_x = work.cosines[16];
  const double R_bell_crank_y_x = work.sines[16];
  const double s1_278 = 0.09720000000000001*R_bell_crank_x_x;
  work.s1_279 = s1_278 - 0.09380000000000002*R_bell_crank_y_x;
  const double s1_280 = 3.25 - 0.09720000000000001*R_bell_crank_y_x;
  work.s1_281 = s1_280 - 0.09380000000000002*R_bell_crank_x_x;
  const double s1_282 = 0.10155600000000002*R_bell_crank_y_x;
  const double s1_283 = 0.10155600000000002*R_bell_crank_x_x;
  const double s1_284 = 0.2800026666666667*R_bell_crank_y_x - s1_283;
  const double s1_285 = 0.14412600000000006*R_bell_crank_x_x - s1_282;
  const double s1_286 = R_bell_crank_y_x*(s1_283 + 0.14412600000000006*R_bell_crank_y_x);
  work.s1_287 = s1_286 + R_bell_crank_x_x*(s1_282 + 0.2800026666666667*R_bell_crank_x_x);
  work.s1_288 = R_bell_crank_x_x*s1_285 + R_bell_crank_y_x*s1_284;
  work.s1_289 = R_bell_crank_x_x*s1_284 - R_bell_crank_y_x*s1_285;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_290 = work.r_rear_axle_aux1_x + 0.0019465977605512485*work.R_rear_axle_x_z;
  work.s1_291 = s1_290 + 0.00017226528854435476*work.R_rear_axle_aux5_x_x;
  const double s1_292 = z_rear_axle_ty + 0.0019465977605512485*work.R_rear_axle_y_z;
  work.s1_293 = s1_292 + 0.00017226528854435476*work.R_rear_axle_aux5_y_x;
  const double s1_294 = work.r_rear_axle_aux3_z + 0.0019465977605512485*work.R_rear_axle_z_z;
  work.s1_295 = s1_294 - 0.00017226528854435476*s1_50;
  const double s1_296 = 264.98720045937415*work.R_rear_axle_aux5_x_x;
  const double s1_297 = 0.02174045363192678*work.R_rear_axle_aux5_x_x;
  const double s1_298 = 264.98720045937415*work.R_rear_axle_aux5_y_x;
  const double s1_299 = s1_298 - 0.02174045363192678*work.R_rear_axle_y_z;
  const double s1_300 = 45.96384415733562*work.R_rear_axle_y_y;
  const double s1_301 = 0.02174045363192678*work.R_rear_axle_aux5_y_x;
  const double s1_302 = 264.4099770312949*work.R_rear_axle_y_z - s1_301;
  const double s1_303 = 0.02174045363192678*work.R_rear_axle_z_z + 264.98720045937415*s1_50;
  const double s1_304 = 45.96384415733562*work.R_rear_axle_z_y;
  const double s1_305 = 264.4099770312949*work.R_rear_axle_z_z + 0.02174045363192678*s1_50;
  const double s1_306 = work.R_rear_axle_x_z*(264.4099770312949*work.R_rear_axle_x_z - s1_297);
  const double s1_307 = s1_296 - 0.02174045363192678*work.R_rear_axle_x_z;
  const double s1_308 = work.R_rear_axle_x_y*(45.96384415733562*work.R_rear_axle_x_y) + s1_306;
  work.s1_309 = s1_308 + work.R_rear_axle_aux5_x_x*s1_307;
  const double s1_310 = work.R_rear_axle_y_y*s1_300 + work.R_rear_axle_y_z*s1_302;
  work.s1_311 = s1_310 + work.R_rear_axle_aux5_y_x*s1_299;
  work.s1_312 = work.R_rear_axle_z_y*s1_304 + work.R_rear_axle_z_z*s1_305 + s1_50*s1_303;
  const double s1_313 = work.R_rear_axle_x_y*s1_300 + work.R_rear_axle_x_z*s1_302;
  work.s1_314 = s1_313 + work.R_rear_axle_aux5_x_x*s1_299;
  const double s1_315 = work.R_rear_axle_x_y*s1_304 + work.R_rear_axle_x_z*s1_305;
  work.s1_316 = s1_315 - work.R_rear_axle_aux5_x_x*s1_303;
  const double s1_317 = work.R_rear_axle_y_y*s1_304 + work.R_rear_axle_y_z*s1_305;
  work.s1_318 = s1_317 - work.R_rear_axle_aux5_y_x*s1_303;
}

/// Part 2 of compute_multipliers: step 1: poses, axes b, accumulated inertias MR (50); step 4:
/// velocities Z (36); step 7: accelerations Zdot and accumulated forces QR - PR (51), (52).
[[gnu::noinline]] void compute_multipliers_2(const State& state, const Derivative& derivative,
    ConstraintForcesWork& __restrict work) noexcept {
  // --- step 1: poses, axes b, accumulated inertias MR (50), continued ---
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s1_319 = 14.0*work.R_rear_axle_aux5_y_x;
  const double s1_320 = 22.0*work.R_rear_axle_y_y;
  const double s1_321 = 14.0*work.R_rear_axle_y_z;
  const double s1_50 = work.sines[18];
  const double s1_322 = 14.0*s1_50;
  const double s1_323 = 22.0*work.R_rear_axle_z_y;
  const double s1_324 = 14.0*work.R_rear_axle_z_z;
  const double s1_325 = work.R_rear_axle_x_y*(22.0*work.R_rear_axle_x_y);
  const double s1_326 = work.R_rear_axle_aux5_x_x*(14.0*work.R_rear_axle_aux5_x_x);
  work.s1_327 = s1_325 + work.R_rear_axle_x_z*(14.0*work.R_rear_axle_x_z) + s1_326;
  const double s1_328 = work.R_rear_axle_y_y*s1_320 + work.R_rear_axle_y_z*s1_321;
  work.s1_329 = s1_328 + work.R_rear_axle_aux5_y_x*s1_319;
  work.s1_330 = work.R_rear_axle_z_y*s1_323 + work.R_rear_axle_z_z*s1_324 + s1_50*s1_322;
  const double s1_331 = work.R_rear_axle_x_y*s1_320 + work.R_rear_axle_x_z*s1_321;
  work.s1_332 = s1_331 + work.R_rear_axle_aux5_x_x*s1_319;
  const double s1_333 = work.R_rear_axle_x_y*s1_323 + work.R_rear_axle_x_z*s1_324;
  work.s1_334 = s1_333 - work.R_rear_axle_aux5_x_x*s1_322;
  const double s1_335 = work.R_rear_axle_y_y*s1_323 + work.R_rear_axle_y_z*s1_324;
  work.s1_336 = s1_335 - work.R_rear_axle_aux5_y_x*s1_322;
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double R_arb_rear_left_x_x = work.cosines[20];
  work.s1_337 = 0.16538461538461574*R_arb_rear_left_x_x - 3.3000000000000003;
  const double R_arb_rear_left_x_z = work.sines[20];
  work.s1_338 = 0.44999999999999996 + 0.16538461538461574*R_arb_rear_left_x_z;
  work.s1_339 = 0.012307692307692316*R_arb_rear_left_x_x;
  const double s1_340 = 0.15615384615384614*R_arb_rear_left_x_z;
  work.s1_341 = 0.012307692307692316*R_arb_rear_left_x_z;
  const double s1_342 = 0.23076923076923084*R_arb_rear_left_x_x;
  const double s1_343 = R_arb_rear_left_x_z*(0.23076923076923084*R_arb_rear_left_x_z);
  work.s1_344 = s1_343 + R_arb_rear_left_x_x*(0.15615384615384614*R_arb_rear_left_x_x);
  work.s1_345 = R_arb_rear_left_x_x*s1_342 + R_arb_rear_left_x_z*s1_340;
  work.s1_346 = R_arb_rear_left_x_z*s1_342 - R_arb_rear_left_x_x*s1_340;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double R_arb_rear_right_x_x = work.cosines[21];
  work.s1_347 = 0.16538461538461574*R_arb_rear_right_x_x - 3.3000000000000003;
  const double R_arb_rear_right_x_z = work.sines[21];
  work.s1_348 = 0.44999999999999996 + 0.16538461538461574*R_arb_rear_right_x_z;
  work.s1_349 = 0.012307692307692316*R_arb_rear_right_x_x;
  const double s1_350 = 0.15615384615384614*R_arb_rear_right_x_z;
  work.s1_351 = 0.012307692307692316*R_arb_rear_right_x_z;
  const double s1_352 = 0.23076923076923084*R_arb_rear_right_x_x;
  const double s1_353 = R_arb_rear_right_x_z*(0.23076923076923084*R_arb_rear_right_x_z);
  work.s1_354 = s1_353 + R_arb_rear_right_x_x*(0.15615384615384614*R_arb_rear_right_x_x);
  work.s1_355 = R_arb_rear_right_x_x*s1_352 + R_arb_rear_right_x_z*s1_350;
  work.s1_356 = R_arb_rear_right_x_z*s1_352 - R_arb_rear_right_x_x*s1_350;
  // arb_link_front_left
  const double s1_357 = 0.02999999999999997*work.R_carrier_left_x_z;
  const double s1_358 = 3.6 + 0.030000000000000027*work.s1_13 + s1_357;
  work.s1_359 = s1_358 + 0.1*work.R_carrier_left_x_x;
  const double s1_360 = work.r_carrier_left_aux1_y + 0.02999999999999997*work.R_carrier_left_y_z;
  const double s1_361 = 0.030000000000000027*work.R_carrier_left_aux2_y_y;
  work.s1_362 = s1_360 + 0.1*work.R_carrier_left_y_x - s1_361;
  const double s1_363 = work.r_carrier_left_aux1_z + 0.02999999999999997*work.R_carrier_left_z_z;
  const double s1_364 = 0.030000000000000027*work.R_carrier_left_aux2_z_y;
  work.s1_365 = s1_363 + 0.1*work.R_carrier_left_z_x - s1_364;
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s1_366 = 3.95 + 0.09999999999999998*R_arb_front_left_x_z;
  work.s1_367 = s1_366 - 0.24999999999999997*R_arb_front_left_x_x;
  const double s1_368 = 0.09999999999999998*R_arb_front_left_x_x - 0.5;
  work.s1_369 = s1_368 + 0.24999999999999997*R_arb_front_left_x_z;
  // arb_link_front_right
  const double s1_370 = 3.6 + 0.02999999999999997*work.R_carrier_right_x_z;
  work.s1_371 = s1_370 + 0.1*work.R_carrier_right_x_x - 0.030000000000000027*work.s1_36;
  const double s1_372 = 0.030000000000000027*work.R_carrier_right_aux2_y_y;
  const double s1_373 = 0.02999999999999997*work.R_carrier_right_y_z;
  const double s1_374 = work.r_carrier_right_aux1_y + s1_372 + s1_373;
  work.s1_375 = s1_374 + 0.1*work.R_carrier_right_y_x;
  const double s1_376 = 0.030000000000000027*work.R_carrier_right_aux2_z_y - work.s1_30;
  const double s1_377 = s1_376 + 0.02999999999999997*work.R_carrier_right_z_z;
  work.s1_378 = s1_377 + 0.1*work.R_carrier_right_z_x;
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s1_379 = 3.95 + 0.09999999999999998*R_arb_front_right_x_z;
  work.s1_380 = s1_379 - 0.24999999999999997*R_arb_front_right_x_x;
  const double s1_381 = 0.09999999999999998*R_arb_front_right_x_x - 0.5;
  work.s1_382 = s1_381 + 0.24999999999999997*R_arb_front_right_x_z;
  // drag_link
  const double R_bell_crank_x_x = work.cosines[16];
  work.s1_383 = 0.3*R_bell_crank_x_x;
  const double R_bell_crank_y_x = work.sines[16];
  work.s1_384 = 3.25 - 0.3*R_bell_crank_y_x;
  work.s1_385 = 4.4 - 0.21999999999999997*work.sines[15];
  work.s1_386 = 0.4 + 0.21999999999999997*work.cosines[15];
  // tie_rod_left
  work.s1_387 = 3.6 + 0.04999999999999993*work.s1_13;
  const double s1_388 = work.s1_387 + 0.07*work.R_carrier_left_x_z;
  work.s1_389 = s1_388 - 0.22*work.R_carrier_left_x_x;
  const double s1_390 = 0.04999999999999993*work.R_carrier_left_aux2_y_y;
  work.s1_391 = work.r_carrier_left_aux1_y - s1_390;
  const double s1_392 = work.s1_391 + 0.07*work.R_carrier_left_y_z;
  work.s1_393 = s1_392 - 0.22*work.R_carrier_left_y_x;
  const double s1_394 = 0.04999999999999993*work.R_carrier_left_aux2_z_y;
  work.s1_395 = work.r_carrier_left_aux1_z - s1_394;
  const double s1_396 = work.s1_395 + 0.07*work.R_carrier_left_z_z;
  work.s1_397 = s1_396 - 0.22*work.R_carrier_left_z_x;
  const double s1_398 = 0.08*R_bell_crank_y_x;
  const double s1_399 = 0.20000000000000007*R_bell_crank_x_x;
  const double s1_400 = 0.08*R_bell_crank_x_x;
  const double s1_401 = 0.20000000000000007*R_bell_crank_y_x;
  work.s1_402 = s1_400 - s1_401;
  work.s1_403 = 3.25 - s1_398 - s1_399;
  // tie_rod_right
  work.s1_404 = 3.6 - 0.04999999999999993*work.s1_36;
  const double s1_405 = work.s1_404 + 0.07*work.R_carrier_right_x_z;
  work.s1_406 = s1_405 - 0.22*work.R_carrier_right_x_x;
  const double s1_407 = 0.04999999999999993*work.R_carrier_right_aux2_y_y;
  work.s1_408 = work.r_carrier_right_aux1_y + s1_407;
  const double s1_409 = work.s1_408 + 0.07*work.R_carrier_right_y_z;
  work.s1_410 = s1_409 - 0.22*work.R_carrier_right_y_x;
  work.s1_411 = 0.04999999999999993*work.R_carrier_right_aux2_z_y - work.s1_30;
  const double s1_412 = work.s1_411 + 0.07*work.R_carrier_right_z_z;
  work.s1_413 = s1_412 - 0.22*work.R_carrier_right_z_x;
  work.s1_414 = s1_400 + s1_401;
  work.s1_415 = 3.25 + (s1_398 - s1_399);
  // long_rod_left
  const double s1_416 = 0.55*work.R_rear_axle_x_y;
  const double s1_417 = 0.04999999999999982*work.R_rear_axle_aux5_x_x;
  const double s1_418 = 0.55*work.R_rear_axle_y_y;
  const double s1_419 = 0.04999999999999982*work.R_rear_axle_aux5_y_x;
  const double s1_420 = 0.55*work.R_rear_axle_z_y;
  const double s1_421 = 0.08000000000000002*work.R_rear_axle_z_z + 0.04999999999999982*s1_50;
  const double s1_422 = s1_417 - 0.08000000000000002*work.R_rear_axle_x_z;
  const double s1_423 = work.r_rear_axle_aux1_x + s1_422;
  work.s1_424 = s1_416 + s1_423;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s1_425 = z_rear_axle_ty + (s1_419 - 0.08000000000000002*work.R_rear_axle_y_z);
  work.s1_426 = s1_418 + s1_425;
  work.s1_427 = work.r_rear_axle_aux3_z + s1_420 - s1_421;
  // diag_rod_left
  const double s1_428 = 0.1*work.R_rear_axle_x_y;
  const double s1_429 = 0.1*work.R_rear_axle_y_y;
  const double s1_430 = 0.1*work.R_rear_axle_z_y;
  const double s1_431 = work.r_rear_axle_aux1_x + 0.25*work.R_rear_axle_x_z;
  work.s1_432 = s1_428 + s1_431;
  const double s1_433 = z_rear_axle_ty + 0.25*work.R_rear_axle_y_z;
  work.s1_434 = s1_429 + s1_433;
  const double s1_435 = work.r_rear_axle_aux3_z + 0.25*work.R_rear_axle_z_z;
  work.s1_436 = s1_430 + s1_435;
  // arb_link_rear_left
  const double s1_437 = 0.6*work.R_rear_axle_x_y;
  const double s1_438 = 0.35000000000000053*work.R_rear_axle_aux5_x_x;
  const double s1_439 = 0.15000000000000002*work.R_rear_axle_x_z + s1_438;
  const double s1_440 = 0.6*work.R_rear_axle_y_y;
  const double s1_441 = 0.35000000000000053*work.R_rear_axle_aux5_y_x;
  const double s1_442 = 0.15000000000000002*work.R_rear_axle_y_z + s1_441;
  const double s1_443 = 0.6*work.R_rear_axle_z_y;
  work.s1_444 = work.r_rear_axle_aux1_x + s1_437 - s1_439;
  work.s1_445 = z_rear_axle_ty + s1_440 - s1_442;
  const double s1_446 = 0.35000000000000053*s1_50 - 0.15000000000000002*work.R_rear_axle_z_z;
  const double s1_447 = work.r_rear_axle_aux3_z + s1_446;
  work.s1_448 = s1_443 + s1_447;
  work.s1_449 = 0.35000000000000053*R_arb_rear_left_x_x - 3.3000000000000003;
  work.s1_450 = 0.44999999999999996 + 0.35000000000000053*R_arb_rear_left_x_z;
  // long_rod_right
  work.s1_451 = s1_423 - s1_416;
  work.s1_452 = s1_425 - s1_418;
  work.s1_453 = work.r_rear_axle_aux3_z - s1_420 - s1_421;
  // diag_rod_right
  work.s1_454 = s1_431 - s1_428;
  work.s1_455 = s1_433 - s1_429;
  work.s1_456 = s1_435 - s1_430;
  // arb_link_rear_right
  work.s1_457 = work.r_rear_axle_aux1_x - s1_437 - s1_439;
  work.s1_458 = z_rear_axle_ty - s1_440 - s1_442;
  work.s1_459 = s1_447 - s1_443;
  work.s1_460 = 0.35000000000000053*R_arb_rear_right_x_x - 3.3000000000000003;
  work.s1_461 = 0.44999999999999996 + 0.35000000000000053*R_arb_rear_right_x_z;
  // operations: 384 add, 605 multiply, 44 sin cos

  // --- step 4: velocities Z (36) ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  const double s1_3 = work.sines[1];
  const double s4_1 = zd_chassis_rz*s1_3;
  const double s4_2 = zd_chassis_rz*work.R_chassis_z_y;
  const double s4_3 = zd_chassis_rz*work.R_chassis_z_z;
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  const double s1_2 = work.cosines[2];
  const double s4_4 = zd_chassis_ry*s1_2;
  const double s1_1 = work.sines[2];
  const double s4_5 = zd_chassis_ry*s1_1;
  work.w_chassis_y = s4_2 + s4_4;
  work.w_chassis_z = s4_3 - s4_5;
  const double zd_chassis_rx = state.zd[Coordinate::chassis_rx];
  work.w_chassis_x = zd_chassis_rx - s4_1;
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double w_lower_arm_left_x = zd_lower_arm_left + work.w_chassis_x;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s4_6 = zd_carrier_left_rz*R_lower_arm_left_z_y;
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double s4_7 = zd_carrier_left_rz*R_lower_arm_left_y_y;
  const double w_carrier_left_aux1_y = work.w_chassis_y - s4_6;
  const double w_carrier_left_aux1_z = work.w_chassis_z + s4_7;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double s4_8 = zd_carrier_left_rx*R_carrier_left_aux1_x_x;
  const double s4_9 = zd_carrier_left_rx*work.R_carrier_left_aux1_y_x;
  const double s4_10 = zd_carrier_left_rx*work.R_carrier_left_aux1_z_x;
  const double w_carrier_left_aux2_x = w_lower_arm_left_x + s4_8;
  const double w_carrier_left_aux2_y = w_carrier_left_aux1_y + s4_9;
  const double w_carrier_left_aux2_z = w_carrier_left_aux1_z + s4_10;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  const double s4_11 = zd_carrier_left_ry*work.s1_13;
  const double s4_12 = zd_carrier_left_ry*work.R_carrier_left_aux2_y_y;
  const double s4_13 = zd_carrier_left_ry*work.R_carrier_left_aux2_z_y;
  work.w_carrier_left_x = w_carrier_left_aux2_x - s4_11;
  work.w_carrier_left_y = w_carrier_left_aux2_y + s4_12;
  work.w_carrier_left_z = w_carrier_left_aux2_z + s4_13;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double zd_wheel_front_left = state.zd[Coordinate::wheel_front_left];
  const double s4_14 = zd_wheel_front_left*work.s1_13;
  const double s4_15 = zd_wheel_front_left*work.R_carrier_left_aux2_y_y;
  const double s4_16 = zd_wheel_front_left*work.R_carrier_left_aux2_z_y;
  work.w_wheel_front_left_x = work.w_carrier_left_x - s4_14;
  work.w_wheel_front_left_y = work.w_carrier_left_y + s4_15;
  work.w_wheel_front_left_z = work.w_carrier_left_z + s4_16;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  const double w_upper_arm_left_x = zd_upper_arm_left + work.w_chassis_x;
  // arb_front_left: arb_front_left, revolute, chassis
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  work.w_arb_front_left_y = zd_arb_front_left + work.w_chassis_y;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double w_lower_arm_right_x = zd_lower_arm_right + work.w_chassis_x;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  const double R_lower_arm_right_z_y = work.sines[9];
  const double s4_17 = zd_carrier_right_rz*R_lower_arm_right_z_y;
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s4_18 = zd_carrier_right_rz*R_lower_arm_right_y_y;
  const double w_carrier_right_aux1_y = work.w_chassis_y - s4_17;
  const double w_carrier_right_aux1_z = work.w_chassis_z + s4_18;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double s4_19 = zd_carrier_right_rx*R_carrier_right_aux1_x_x;
  const double s4_20 = zd_carrier_right_rx*work.R_carrier_right_aux1_y_x;
  const double s4_21 = zd_carrier_right_rx*work.R_carrier_right_aux1_z_x;
  const double w_carrier_right_aux2_x = w_lower_arm_right_x + s4_19;
  const double w_carrier_right_aux2_y = w_carrier_right_aux1_y + s4_20;
  const double w_carrier_right_aux2_z = w_carrier_right_aux1_z + s4_21;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  const double s4_22 = zd_carrier_right_ry*work.s1_36;
  const double s4_23 = zd_carrier_right_ry*work.R_carrier_right_aux2_y_y;
  const double s4_24 = zd_carrier_right_ry*work.R_carrier_right_aux2_z_y;
  work.w_carrier_right_x = w_carrier_right_aux2_x - s4_22;
  work.w_carrier_right_y = w_carrier_right_aux2_y + s4_23;
  work.w_carrier_right_z = w_carrier_right_aux2_z + s4_24;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double zd_wheel_front_right = state.zd[Coordinate::wheel_front_right];
  const double s4_25 = zd_wheel_front_right*work.s1_36;
  const double s4_26 = zd_wheel_front_right*work.R_carrier_right_aux2_y_y;
  const double s4_27 = zd_wheel_front_right*work.R_carrier_right_aux2_z_y;
  work.w_wheel_front_right_x = work.w_carrier_right_x - s4_25;
  work.w_wheel_front_right_y = work.w_carrier_right_y + s4_26;
  work.w_wheel_front_right_z = work.w_carrier_right_z + s4_27;
  // upper_arm_right: upper_arm_right, revolute, chassis
  work.w_upper_arm_right_x = state.zd[Coordinate::upper_arm_right] + work.w_chassis_x;
  // arb_front_right: arb_front_right, revolute, chassis
  work.w_arb_front_right_y = state.zd[Coordinate::arb_front_right] + work.w_chassis_y;
  // pitman_arm: pitman_arm, revolute, chassis
  work.w_pitman_arm_y = state.zd[Coordinate::pitman_arm] + work.w_chassis_y;
  // bell_crank: bell_crank, revolute, chassis
  work.w_bell_crank_z = state.zd[Coordinate::bell_crank] + work.w_chassis_z;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  work.w_rear_axle_aux4_z = state.zd[Coordinate::rear_axle_rz] + work.w_chassis_z;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  work.s4_28 = zd_rear_axle_ry*work.sines[17];
  work.s4_29 = zd_rear_axle_ry*work.cosines[17];
  work.w_rear_axle_aux5_x = work.w_chassis_x - work.s4_28;
  work.w_rear_axle_aux5_y = work.w_chassis_y + work.s4_29;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  work.s4_30 = zd_rear_axle_rx*work.R_rear_axle_aux5_x_x;
  work.s4_31 = zd_rear_axle_rx*work.R_rear_axle_aux5_y_x;
  work.s4_32 = zd_rear_axle_rx*s1_50;
  work.w_rear_axle_x = work.w_rear_axle_aux5_x + work.s4_30;
  work.w_rear_axle_y = work.w_rear_axle_aux5_y + work.s4_31;
  work.w_rear_axle_z = work.w_rear_axle_aux4_z - work.s4_32;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double zd_wheel_rear_left = state.zd[Coordinate::wheel_rear_left];
  work.s4_33 = zd_wheel_rear_left*work.R_rear_axle_x_y;
  work.s4_34 = zd_wheel_rear_left*work.R_rear_axle_y_y;
  work.s4_35 = zd_wheel_rear_left*work.R_rear_axle_z_y;
  work.w_wheel_rear_left_x = work.w_rear_axle_x + work.s4_33;
  work.w_wheel_rear_left_y = work.w_rear_axle_y + work.s4_34;
  work.w_wheel_rear_left_z = work.w_rear_axle_z + work.s4_35;
  // arb_rear_left: arb_rear_left, revolute, chassis
  work.w_arb_rear_left_y = state.zd[Coordinate::arb_rear_left] + work.w_chassis_y;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double zd_wheel_rear_right = state.zd[Coordinate::wheel_rear_right];
  work.s4_36 = zd_wheel_rear_right*work.R_rear_axle_x_y;
  work.s4_37 = zd_wheel_rear_right*work.R_rear_axle_y_y;
  work.s4_38 = zd_wheel_rear_right*work.R_rear_axle_z_y;
  work.w_wheel_rear_right_x = work.w_rear_axle_x + work.s4_36;
  work.w_wheel_rear_right_y = work.w_rear_axle_y + work.s4_37;
  work.w_wheel_rear_right_z = work.w_rear_axle_z + work.s4_38;
  // arb_rear_right: arb_rear_right, revolute, chassis
  work.w_arb_rear_right_y = state.zd[Coordinate::arb_rear_right] + work.w_chassis_y;
  // operations: 47 add, 38 multiply

  // --- step 7: accelerations Zdot and accumulated forces QR - PR (51), (52) ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s7_1 = 9.81 + derivative.zdd[Coordinate::chassis_tz];
  const double zdd_chassis_tx = derivative.zdd[Coordinate::chassis_tx];
  const double zdd_chassis_ty = derivative.zdd[Coordinate::chassis_ty];
  const double s7_2 = zdd_chassis_tx*work.R_chassis_aux5_x_x;
  work.a_chassis_x = s7_2 + zdd_chassis_ty*work.R_chassis_aux5_y_x - s1_3*s7_1;
  const double s7_3 = zdd_chassis_tx*work.R_chassis_x_y + zdd_chassis_ty*work.R_chassis_y_y;
  work.a_chassis_y = s7_3 + work.R_chassis_z_y*s7_1;
  const double s7_4 = zdd_chassis_tx*work.R_chassis_x_z + zdd_chassis_ty*work.R_chassis_y_z;
  work.a_chassis_z = s7_4 + work.R_chassis_z_z*s7_1;
  work.s7_5 = work.w_chassis_y*work.w_chassis_y;
  work.s7_6 = work.w_chassis_z*work.w_chassis_z;
  work.s7_7 = work.w_chassis_y*work.w_chassis_z;
  work.s7_8 = work.s7_5 + work.s7_6;
  const double zdd_chassis_rz = derivative.zdd[Coordinate::chassis_rz];
  const double s7_9 = derivative.zdd[Coordinate::chassis_rx] - zdd_chassis_rz*s1_3 - s4_3*s4_4;
  work.alpha_chassis_x = s7_9 - s4_2*s4_5;
  const double zdd_chassis_ry = derivative.zdd[Coordinate::chassis_ry];
  const double s7_10 = zdd_chassis_rz*work.R_chassis_z_y + zdd_chassis_ry*s1_2 - s4_1*s4_5;
  work.alpha_chassis_y = s7_10 + zd_chassis_rx*work.w_chassis_z;
  const double s7_11 = zdd_chassis_rz*work.R_chassis_z_z - zdd_chassis_ry*s1_1 - s4_1*s4_4;
  work.alpha_chassis_z = s7_11 - zd_chassis_rx*work.w_chassis_y;
  work.s7_12 = work.w_chassis_x*work.w_chassis_x;
  work.s7_13 = work.w_chassis_y*work.w_chassis_x;
  work.s7_14 = work.w_chassis_z*work.w_chassis_x;
  work.s7_15 = work.alpha_chassis_z + work.s7_13;
  work.s7_16 = work.s7_14 - work.alpha_chassis_y;
  work.s7_17 = work.s7_13 - work.alpha_chassis_z;
  work.s7_18 = work.s7_6 + work.s7_12;
  work.s7_19 = work.s7_7 + work.alpha_chassis_x;
  work.s7_20 = work.alpha_chassis_y + work.s7_14;
  work.s7_21 = work.s7_7 - work.alpha_chassis_x;
  work.s7_22 = work.s7_5 + work.s7_12;
  // lower_arm_left: lower_arm_left, revolute, chassis
  work.alpha_lower_arm_left_x = derivative.zdd[Coordinate::lower_arm_left] + work.alpha_chassis_x;
  const double alpha_lower_arm_left_y = work.alpha_chassis_y + zd_lower_arm_left*work.w_chassis_z;
  const double alpha_lower_arm_left_z = work.alpha_chassis_z - zd_lower_arm_left*work.w_chassis_y;
  const double s7_23 = w_lower_arm_left_x*w_lower_arm_left_x;
  const double s7_24 = work.w_chassis_y*w_lower_arm_left_x;
  const double s7_25 = work.w_chassis_z*w_lower_arm_left_x;
  work.s7_26 = alpha_lower_arm_left_z + s7_24;
  work.s7_27 = s7_25 - alpha_lower_arm_left_y;
  const double s7_28 = s7_24 - alpha_lower_arm_left_z;
  work.s7_29 = work.s7_6 + s7_23;
  work.s7_30 = work.s7_7 + work.alpha_lower_arm_left_x;
  const double s7_31 = alpha_lower_arm_left_y + s7_25;
  work.s7_32 = work.s7_7 - work.alpha_lower_arm_left_x;
  work.s7_33 = work.s7_5 + s7_23;
  const double a_lower_arm_left_x = work.a_chassis_x + 0.4*(work.s7_17 - s7_28) - 0.62*(work.s7_20 -
      s7_31);
  const double s7_34 = work.a_chassis_y + 0.4*(work.s7_29 - work.s7_18);
  work.a_lower_arm_left_y = s7_34 + 3.6*(work.s7_15 - work.s7_26) - 0.62*(work.s7_21 - work.s7_32);
  const double s7_35 = work.a_chassis_z + 0.4*(work.s7_19 - work.s7_30);
  work.a_lower_arm_left_z = s7_35 + 3.6*(work.s7_16 - work.s7_27) - 0.62*(work.s7_33 - work.s7_22);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s7_36 = work.alpha_lower_arm_left_x + work.w_chassis_z*s4_6;
  const double alpha_carrier_left_aux1_x = s7_36 + work.w_chassis_y*s4_7;
  const double zdd_carrier_left_rz = derivative.zdd[Coordinate::carrier_left_rz];
  const double s7_37 = alpha_lower_arm_left_y - zdd_carrier_left_rz*R_lower_arm_left_z_y;
  const double alpha_carrier_left_aux1_y = s7_37 - w_lower_arm_left_x*s4_7;
  const double s7_38 = alpha_lower_arm_left_z + zdd_carrier_left_rz*R_lower_arm_left_y_y;
  const double alpha_carrier_left_aux1_z = s7_38 - w_lower_arm_left_x*s4_6;
  const double s7_39 = w_carrier_left_aux1_y*w_carrier_left_aux1_y;
  const double s7_40 = w_carrier_left_aux1_z*w_carrier_left_aux1_z;
  const double s7_41 = w_lower_arm_left_x*w_carrier_left_aux1_y;
  const double s7_42 = w_lower_arm_left_x*w_carrier_left_aux1_z;
  const double s7_43 = w_carrier_left_aux1_y*w_carrier_left_aux1_z;
  const double s7_44 = s7_39 + s7_40;
  const double s7_45 = alpha_carrier_left_aux1_z + s7_41;
  const double s7_46 = s7_42 - alpha_carrier_left_aux1_y;
  const double s7_47 = s7_41 - alpha_carrier_left_aux1_z;
  const double s7_48 = s7_23 + s7_40;
  const double s7_49 = alpha_carrier_left_aux1_x + s7_43;
  const double s7_50 = alpha_carrier_left_aux1_y + s7_42;
  const double s7_51 = s7_43 - alpha_carrier_left_aux1_x;
  const double s7_52 = s7_23 + s7_39;
  const double s7_53 = a_lower_arm_left_x + work.r_carrier_left_aux1_y*(s7_28 - s7_47);
  const double s7_54 = s7_53 + work.r_carrier_left_aux1_z*(s7_31 - s7_50);
  const double a_carrier_left_aux1_x = s7_54 + 3.6*(s7_44 - work.s7_8);
  const double s7_55 = work.r_carrier_left_aux1_y*(s7_48 - work.s7_29);
  const double s7_56 = work.r_carrier_left_aux1_z*(work.s7_32 - s7_51);
  const double a_carrier_left_aux1_y = work.a_lower_arm_left_y + s7_55 + s7_56 + 3.6*(work.s7_26 -
      s7_45);
  const double s7_57 = work.r_carrier_left_aux1_y*(work.s7_30 - s7_49);
  const double s7_58 = work.r_carrier_left_aux1_z*(s7_52 - work.s7_33);
  const double a_carrier_left_aux1_z = work.a_lower_arm_left_z + s7_57 + s7_58 + 3.6*(work.s7_27 -
      s7_46);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s7_59 = alpha_carrier_left_aux1_x + w_carrier_left_aux1_y*s4_10;
  const double zdd_carrier_left_rx = derivative.zdd[Coordinate::carrier_left_rx];
  const double s7_60 = zdd_carrier_left_rx*R_carrier_left_aux1_x_x;
  const double alpha_carrier_left_aux2_x = s7_59 - w_carrier_left_aux1_z*s4_9 + s7_60;
  const double s7_61 = alpha_carrier_left_aux1_y + w_carrier_left_aux1_z*s4_8;
  const double s7_62 = zdd_carrier_left_rx*work.R_carrier_left_aux1_y_x;
  const double alpha_carrier_left_aux2_y = s7_61 - w_lower_arm_left_x*s4_10 + s7_62;
  const double s7_63 = alpha_carrier_left_aux1_z + w_lower_arm_left_x*s4_9;
  const double s7_64 = zdd_carrier_left_rx*work.R_carrier_left_aux1_z_x;
  const double alpha_carrier_left_aux2_z = s7_63 - w_carrier_left_aux1_y*s4_8 + s7_64;
  const double s7_65 = w_carrier_left_aux2_x*w_carrier_left_aux2_x;
  const double s7_66 = w_carrier_left_aux2_y*w_carrier_left_aux2_y;
  const double s7_67 = w_carrier_left_aux2_z*w_carrier_left_aux2_z;
  const double s7_68 = w_carrier_left_aux2_x*w_carrier_left_aux2_y;
  const double s7_69 = w_carrier_left_aux2_x*w_carrier_left_aux2_z;
  const double s7_70 = w_carrier_left_aux2_y*w_carrier_left_aux2_z;
  const double s7_71 = s7_66 + s7_67;
  const double s7_72 = alpha_carrier_left_aux2_z + s7_68;
  const double s7_73 = s7_69 - alpha_carrier_left_aux2_y;
  const double s7_74 = s7_68 - alpha_carrier_left_aux2_z;
  const double s7_75 = s7_65 + s7_67;
  const double s7_76 = alpha_carrier_left_aux2_x + s7_70;
  const double s7_77 = alpha_carrier_left_aux2_y + s7_69;
  const double s7_78 = s7_70 - alpha_carrier_left_aux2_x;
  const double s7_79 = s7_65 + s7_66;
  const double s7_80 = a_carrier_left_aux1_x + work.r_carrier_left_aux1_y*(s7_47 - s7_74);
  const double a_carrier_left_aux2_x = s7_80 + work.r_carrier_left_aux1_z*(s7_50 - s7_77) +
      3.6*(s7_71 - s7_44);
  const double s7_81 = a_carrier_left_aux1_y + work.r_carrier_left_aux1_y*(s7_75 - s7_48);
  const double a_carrier_left_aux2_y = s7_81 + work.r_carrier_left_aux1_z*(s7_51 - s7_78) +
      3.6*(s7_45 - s7_72);
  const double s7_82 = a_carrier_left_aux1_z + work.r_carrier_left_aux1_y*(s7_49 - s7_76);
  const double a_carrier_left_aux2_z = s7_82 + work.r_carrier_left_aux1_z*(s7_79 - s7_52) +
      3.6*(s7_46 - s7_73);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_83 = alpha_carrier_left_aux2_x + w_carrier_left_aux2_y*s4_13;
  const double zdd_carrier_left_ry = derivative.zdd[Coordinate::carrier_left_ry];
  work.alpha_carrier_left_x = s7_83 - w_carrier_left_aux2_z*s4_12 - zdd_carrier_left_ry*work.s1_13;
  const double s7_84 = zdd_carrier_left_ry*work.R_carrier_left_aux2_y_y;
  const double s7_85 = alpha_carrier_left_aux2_y + s7_84 - w_carrier_left_aux2_x*s4_13;
  work.alpha_carrier_left_y = s7_85 - w_carrier_left_aux2_z*s4_11;
  const double s7_86 = alpha_carrier_left_aux2_z + w_carrier_left_aux2_y*s4_11;
  const double s7_87 = zdd_carrier_left_ry*work.R_carrier_left_aux2_z_y;
  work.alpha_carrier_left_z = s7_86 + w_carrier_left_aux2_x*s4_12 + s7_87;
  const double s7_88 = work.w_carrier_left_x*work.w_carrier_left_x;
  const double s7_89 = work.w_carrier_left_y*work.w_carrier_left_y;
  const double s7_90 = work.w_carrier_left_z*work.w_carrier_left_z;
  const double s7_91 = work.w_carrier_left_x*work.w_carrier_left_y;
  const double s7_92 = work.w_carrier_left_x*work.w_carrier_left_z;
  const double s7_93 = work.w_carrier_left_y*work.w_carrier_left_z;
  work.s7_94 = s7_89 + s7_90;
  work.s7_95 = work.alpha_carrier_left_z + s7_91;
  work.s7_96 = s7_92 - work.alpha_carrier_left_y;
  work.s7_97 = s7_91 - work.alpha_carrier_left_z;
  work.s7_98 = s7_88 + s7_90;
  work.s7_99 = work.alpha_carrier_left_x + s7_93;
  work.s7_100 = work.alpha_carrier_left_y + s7_92;
  work.s7_101 = s7_93 - work.alpha_carrier_left_x;
  work.s7_102 = s7_88 + s7_89;
  const double s7_103 = a_carrier_left_aux2_x + work.r_carrier_left_aux1_y*(s7_74 - work.s7_97);
  const double s7_104 = s7_103 + work.r_carrier_left_aux1_z*(s7_77 - work.s7_100);
  work.a_carrier_left_x = s7_104 + 3.6*(work.s7_94 - s7_71);
  const double s7_105 = a_carrier_left_aux2_y + work.r_carrier_left_aux1_y*(work.s7_98 - s7_75);
  const double s7_106 = s7_105 + work.r_carrier_left_aux1_z*(s7_78 - work.s7_101);
  work.a_carrier_left_y = s7_106 + 3.6*(s7_72 - work.s7_95);
  const double s7_107 = a_carrier_left_aux2_z + work.r_carrier_left_aux1_y*(s7_76 - work.s7_99);
  const double s7_108 = s7_107 + work.r_carrier_left_aux1_z*(work.s7_102 - s7_79);
  work.a_carrier_left_z = s7_108 + 3.6*(s7_73 - work.s7_96);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s7_109 = work.alpha_carrier_left_x + work.w_carrier_left_y*s4_16;
  const double zdd_wheel_front_left = derivative.zdd[Coordinate::wheel_front_left];
  work.alpha_wheel_front_left_x = s7_109 - work.w_carrier_left_z*s4_15 -
      zdd_wheel_front_left*work.s1_13;
  const double s7_110 = zdd_wheel_front_left*work.R_carrier_left_aux2_y_y;
  const double s7_111 = work.alpha_carrier_left_y + s7_110 - work.w_carrier_left_x*s4_16;
  work.alpha_wheel_front_left_y = s7_111 - work.w_carrier_left_z*s4_14;
  const double s7_112 = work.alpha_carrier_left_z + work.w_carrier_left_y*s4_14;
  const double s7_113 = zdd_wheel_front_left*work.R_carrier_left_aux2_z_y;
  work.alpha_wheel_front_left_z = s7_112 + work.w_carrier_left_x*s4_15 + s7_113;
  const double s7_114 = work.w_wheel_front_left_x*work.w_wheel_front_left_x;
  const double s7_115 = work.w_wheel_front_left_y*work.w_wheel_front_left_y;
  const double s7_116 = work.w_wheel_front_left_z*work.w_wheel_front_left_z;
  const double s7_117 = work.w_wheel_front_left_x*work.w_wheel_front_left_y;
  const double s7_118 = work.w_wheel_front_left_x*work.w_wheel_front_left_z;
  const double s7_119 = work.w_wheel_front_left_y*work.w_wheel_front_left_z;
  work.s7_120 = s7_115 + s7_116;
  work.s7_121 = work.alpha_wheel_front_left_z + s7_117;
  work.s7_122 = s7_118 - work.alpha_wheel_front_left_y;
  work.s7_123 = s7_117 - work.alpha_wheel_front_left_z;
  work.s7_124 = s7_114 + s7_116;
  work.s7_125 = work.alpha_wheel_front_left_x + s7_119;
  work.s7_126 = work.alpha_wheel_front_left_y + s7_118;
  work.s7_127 = s7_119 - work.alpha_wheel_front_left_x;
  work.s7_128 = s7_114 + s7_115;
  const double s7_129 = work.r_wheel_front_left_y*(work.s7_97 - work.s7_123);
  const double s7_130 = work.r_wheel_front_left_z*(work.s7_100 - work.s7_126);
  const double s7_131 = work.r_wheel_front_left_x*(work.s7_120 - work.s7_94);
  work.a_wheel_front_left_x = work.a_carrier_left_x + s7_129 + s7_130 + s7_131;
  const double s7_132 = work.r_wheel_front_left_y*(work.s7_124 - work.s7_98);
  const double s7_133 = work.r_wheel_front_left_z*(work.s7_101 - work.s7_127);
  const double s7_134 = work.r_wheel_front_left_x*(work.s7_95 - work.s7_121);
  work.a_wheel_front_left_y = work.a_carrier_left_y + s7_132 + s7_133 + s7_134;
  const double s7_135 = work.r_wheel_front_left_y*(work.s7_99 - work.s7_125);
  const double s7_136 = work.r_wheel_front_left_z*(work.s7_128 - work.s7_102);
  const double s7_137 = work.r_wheel_front_left_x*(work.s7_96 - work.s7_122);
  work.a_wheel_front_left_z = work.a_carrier_left_z + s7_135 + s7_136 + s7_137;
  // upper_arm_left: upper_arm_left, revolute, chassis
  work.alpha_upper_arm_left_x = derivative.zdd[Coordinate::upper_arm_left] + work.alpha_chassis_x;
  const double alpha_upper_arm_left_y = work.alpha_chassis_y + zd_upper_arm_left*work.w_chassis_z;
  const double alpha_upper_arm_left_z = work.alpha_chassis_z - zd_upper_arm_left*work.w_chassis_y;
  const double s7_138 = w_upper_arm_left_x*w_upper_arm_left_x;
  work.s7_139 = alpha_upper_arm_left_z + work.w_chassis_y*w_upper_arm_left_x;
  work.s7_140 = work.w_chassis_z*w_upper_arm_left_x - alpha_upper_arm_left_y;
  work.s7_141 = work.s7_6 + s7_138;
  work.s7_142 = work.s7_7 + work.alpha_upper_arm_left_x;
  work.s7_143 = work.s7_7 - work.alpha_upper_arm_left_x;
  work.s7_144 = work.s7_5 + s7_138;
  const double s7_145 = work.a_chassis_y + 0.5*(work.s7_141 - work.s7_18);
  const double s7_146 = s7_145 + 3.6*(work.s7_15 - work.s7_139);
  work.a_upper_arm_left_y = s7_146 - 0.28*(work.s7_21 - work.s7_143);
  const double s7_147 = work.a_chassis_z + 0.5*(work.s7_19 - work.s7_142);
  const double s7_148 = s7_147 + 3.6*(work.s7_16 - work.s7_140);
  work.a_upper_arm_left_z = s7_148 - 0.28*(work.s7_144 - work.s7_22);
  // arb_front_left: arb_front_left, revolute, chassis
  work.alpha_arb_front_left_y = derivative.zdd[Coordinate::arb_front_left] + work.alpha_chassis_y;
  work.alpha_arb_front_left_x = work.alpha_chassis_x - zd_arb_front_left*work.w_chassis_z;
  work.alpha_arb_front_left_z = work.alpha_chassis_z + zd_arb_front_left*work.w_chassis_x;
  const double s7_149 = work.w_arb_front_left_y*work.w_arb_front_left_y;
  const double s7_150 = work.w_chassis_x*work.w_arb_front_left_y;
  const double s7_151 = work.w_chassis_z*work.w_arb_front_left_y;
  work.s7_152 = work.s7_6 + s7_149;
  work.s7_153 = work.alpha_arb_front_left_z + s7_150;
  work.s7_154 = work.s7_14 - work.alpha_arb_front_left_y;
  work.s7_155 = s7_150 - work.alpha_arb_front_left_z;
  work.s7_156 = work.alpha_arb_front_left_x + s7_151;
  work.s7_157 = work.s7_14 + work.alpha_arb_front_left_y;
  work.s7_158 = s7_151 - work.alpha_arb_front_left_x;
  work.s7_159 = work.s7_12 + s7_149;
  const double s7_160 = work.a_chassis_x + 0.45*(work.s7_17 - work.s7_155);
  work.a_arb_front_left_x = s7_160 + 3.95*(work.s7_152 - work.s7_8) - 0.5*(work.s7_20 -
      work.s7_157);
  const double s7_161 = work.a_chassis_y + 3.95*(work.s7_15 - work.s7_153);
  work.a_arb_front_left_y = s7_161 - 0.5*(work.s7_21 - work.s7_158);
  const double s7_162 = work.a_chassis_z + 0.45*(work.s7_19 - work.s7_156);
  const double s7_163 = s7_162 + 3.95*(work.s7_16 - work.s7_154);
  work.a_arb_front_left_z = s7_163 - 0.5*(work.s7_159 - work.s7_22);
  // lower_arm_right: lower_arm_right, revolute, chassis
  work.alpha_lower_arm_right_x = derivative.zdd[Coordinate::lower_arm_right] + work.alpha_chassis_x;
  const double alpha_lower_arm_right_y = work.alpha_chassis_y + zd_lower_arm_right*work.w_chassis_z;
  const double alpha_lower_arm_right_z = work.alpha_chassis_z - zd_lower_arm_right*work.w_chassis_y;
  const double s7_164 = w_lower_arm_right_x*w_lower_arm_right_x;
  const double s7_165 = work.w_chassis_y*w_lower_arm_right_x;
  const double s7_166 = work.w_chassis_z*w_lower_arm_right_x;
  work.s7_167 = alpha_lower_arm_right_z + s7_165;
  work.s7_168 = s7_166 - alpha_lower_arm_right_y;
  const double s7_169 = s7_165 - alpha_lower_arm_right_z;
  work.s7_170 = work.s7_6 + s7_164;
  work.s7_171 = work.s7_7 + work.alpha_lower_arm_right_x;
  const double s7_172 = alpha_lower_arm_right_y + s7_166;
  work.s7_173 = work.s7_7 - work.alpha_lower_arm_right_x;
  work.s7_174 = work.s7_5 + s7_164;
  const double s7_175 = work.a_chassis_x - 0.4*(work.s7_17 - s7_169);
  const double a_lower_arm_right_x = s7_175 - 0.62*(work.s7_20 - s7_172);
  const double s7_176 = work.a_chassis_y + 3.6*(work.s7_15 - work.s7_167);
  const double s7_177 = s7_176 - 0.62*(work.s7_21 - work.s7_173);
  work.a_lower_arm_right_y = s7_177 - 0.4*(work.s7_170 - work.s7_18);
  const double s7_178 = work.a_chassis_z + 3.6*(work.s7_16 - work.s7_168);
  const double s7_179 = s7_178 - 0.62*(work.s7_174 - work.s7_22);
  work.a_lower_arm_right_z = s7_179 - 0.4*(work.s7_19 - work.s7_171);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s7_180 = work.alpha_lower_arm_right_x + work.w_chassis_z*s4_17;
  const double alpha_carrier_right_aux1_x = s7_180 + work.w_chassis_y*s4_18;
  const double zdd_carrier_right_rz = derivative.zdd[Coordinate::carrier_right_rz];
  const double s7_181 = alpha_lower_arm_right_y - zdd_carrier_right_rz*R_lower_arm_right_z_y;
  const double alpha_carrier_right_aux1_y = s7_181 - w_lower_arm_right_x*s4_18;
  const double s7_182 = alpha_lower_arm_right_z + zdd_carrier_right_rz*R_lower_arm_right_y_y;
  const double alpha_carrier_right_aux1_z = s7_182 - w_lower_arm_right_x*s4_17;
  const double s7_183 = w_carrier_right_aux1_y*w_carrier_right_aux1_y;
  const double s7_184 = w_carrier_right_aux1_z*w_carrier_right_aux1_z;
  const double s7_185 = w_lower_arm_right_x*w_carrier_right_aux1_y;
  const double s7_186 = w_lower_arm_right_x*w_carrier_right_aux1_z;
  const double s7_187 = w_carrier_right_aux1_y*w_carrier_right_aux1_z;
  const double s7_188 = s7_183 + s7_184;
  const double s7_189 = alpha_carrier_right_aux1_z + s7_185;
  const double s7_190 = s7_186 - alpha_carrier_right_aux1_y;
  const double s7_191 = s7_185 - alpha_carrier_right_aux1_z;
  const double s7_192 = s7_164 + s7_184;
  const double s7_193 = alpha_carrier_right_aux1_x + s7_187;
  const double s7_194 = alpha_carrier_right_aux1_y + s7_186;
  const double s7_195 = s7_187 - alpha_carrier_right_aux1_x;
  const double s7_196 = s7_164 + s7_183;
  const double s7_197 = a_lower_arm_right_x + work.r_carrier_right_aux1_y*(s7_169 - s7_191);
  const double a_carrier_right_aux1_x = s7_197 + 3.6*(s7_188 - work.s7_8) - work.s1_30*(s7_172 -
      s7_194);
  const double s7_198 = work.r_carrier_right_aux1_y*(s7_192 - work.s7_170);
  const double s7_199 = work.a_lower_arm_right_y + s7_198 + 3.6*(work.s7_167 - s7_189);
  const double a_carrier_right_aux1_y = s7_199 - work.s1_30*(work.s7_173 - s7_195);
  const double s7_200 = work.r_carrier_right_aux1_y*(work.s7_171 - s7_193);
  const double s7_201 = work.a_lower_arm_right_z + s7_200 + 3.6*(work.s7_168 - s7_190);
  const double a_carrier_right_aux1_z = s7_201 - work.s1_30*(s7_196 - work.s7_174);
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s7_202 = alpha_carrier_right_aux1_x + w_carrier_right_aux1_y*s4_21;
  const double zdd_carrier_right_rx = derivative.zdd[Coordinate::carrier_right_rx];
  const double s7_203 = zdd_carrier_right_rx*R_carrier_right_aux1_x_x;
  const double alpha_carrier_right_aux2_x = s7_202 - w_carrier_right_aux1_z*s4_20 + s7_203;
  const double s7_204 = alpha_carrier_right_aux1_y + w_carrier_right_aux1_z*s4_19;
  const double s7_205 = zdd_carrier_right_rx*work.R_carrier_right_aux1_y_x;
  const double alpha_carrier_right_aux2_y = s7_204 - w_lower_arm_right_x*s4_21 + s7_205;
  const double s7_206 = alpha_carrier_right_aux1_z + w_lower_arm_right_x*s4_20;
  const double s7_207 = zdd_carrier_right_rx*work.R_carrier_right_aux1_z_x;
  const double alpha_carrier_right_aux2_z = s7_206 - w_carrier_right_aux1_y*s4_19 + s7_207;
  const double s7_208 = w_carrier_right_aux2_x*w_carrier_right_aux2_x;
  const double s7_209 = w_carrier_right_aux2_y*w_carrier_right_aux2_y;
  const double s7_210 = w_carrier_right_aux2_z*w_carrier_right_aux2_z;
  const double s7_211 = w_carrier_right_aux2_x*w_carrier_right_aux2_y;
  const double s7_212 = w_carrier_right_aux2_x*w_carrier_right_aux2_z;
  const double s7_213 = w_carrier_right_aux2_y*w_carrier_right_aux2_z;
  const double s7_214 = s7_209 + s7_210;
  const double s7_215 = alpha_carrier_right_aux2_z + s7_211;
  const double s7_216 = s7_212 - alpha_carrier_right_aux2_y;
  const double s7_217 = s7_211 - alpha_carrier_right_aux2_z;
  const double s7_218 = s7_208 + s7_210;
  const double s7_219 = alpha_carrier_right_aux2_x + s7_213;
  const double s7_220 = alpha_carrier_right_aux2_y + s7_212;
  const double s7_221 = s7_213 - alpha_carrier_right_aux2_x;
  const double s7_222 = s7_208 + s7_209;
  const double s7_223 = a_carrier_right_aux1_x + work.r_carrier_right_aux1_y*(s7_191 - s7_217);
  const double a_carrier_right_aux2_x = s7_223 + 3.6*(s7_214 - s7_188) - work.s1_30*(s7_194 -
      s7_220);
  const double s7_224 = a_carrier_right_aux1_y + work.r_carrier_right_aux1_y*(s7_218 - s7_192);
  const double a_carrier_right_aux2_y = s7_224 + 3.6*(s7_189 - s7_215) - work.s1_30*(s7_195 -
      s7_221);
  const double s7_225 = a_carrier_right_aux1_z + work.r_carrier_right_aux1_y*(s7_193 - s7_219);
  const double a_carrier_right_aux2_z = s7_225 + 3.6*(s7_190 - s7_216) - work.s1_30*(s7_222 -
      s7_196);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_226 = alpha_carrier_right_aux2_x + w_carrier_right_aux2_y*s4_24;
  const double zdd_carrier_right_ry = derivative.zdd[Coordinate::carrier_right_ry];
  work.alpha_carrier_right_x = s7_226 - w_carrier_right_aux2_z*s4_23 -
      zdd_carrier_right_ry*work.s1_36;
  const double s7_227 = zdd_carrier_right_ry*work.R_carrier_right_aux2_y_y;
  const double s7_228 = alpha_carrier_right_aux2_y + s7_227 - w_carrier_right_aux2_x*s4_24;
  work.alpha_carrier_right_y = s7_228 - w_carrier_right_aux2_z*s4_22;
  const double s7_229 = alpha_carrier_right_aux2_z + w_carrier_right_aux2_y*s4_22;
  const double s7_230 = zdd_carrier_right_ry*work.R_carrier_right_aux2_z_y;
  work.alpha_carrier_right_z = s7_229 + w_carrier_right_aux2_x*s4_23 + s7_230;
  const double s7_231 = work.w_carrier_right_x*work.w_carrier_right_x;
  const double s7_232 = work.w_carrier_right_y*work.w_carrier_right_y;
  const double s7_233 = work.w_carrier_right_z*work.w_carrier_right_z;
  const double s7_234 = work.w_carrier_right_x*work.w_carrier_right_y;
  const double s7_235 = work.w_carrier_right_x*work.w_carrier_right_z;
  const double s7_236 = work.w_carrier_right_y*work.w_carrier_right_z;
  work.s7_237 = s7_232 + s7_233;
  work.s7_238 = work.alpha_carrier_right_z + s7_234;
  work.s7_239 = s7_235 - work.alpha_carrier_right_y;
  work.s7_240 = s7_234 - work.alpha_carrier_right_z;
  work.s7_241 = s7_231 + s7_233;
  work.s7_242 = work.alpha_carrier_right_x + s7_236;
  work.s7_243 = work.alpha_carrier_right_y + s7_235;
  work.s7_244 = s7_236 - work.alpha_carrier_right_x;
  work.s7_245 = s7_231 + s7_232;
  const double s7_246 = work.r_carrier_right_aux1_y*(s7_217 - work.s7_240);
  const double s7_247 = a_carrier_right_aux2_x + s7_246 + 3.6*(work.s7_237 - s7_214);
  work.a_carrier_right_x = s7_247 - work.s1_30*(s7_220 - work.s7_243);
  const double s7_248 = work.r_carrier_right_aux1_y*(work.s7_241 - s7_218);
  const double s7_249 = a_carrier_right_aux2_y + s7_248 + 3.6*(s7_215 - work.s7_238);
  work.a_carrier_right_y = s7_249 - work.s1_30*(s7_221 - work.s7_244);
  const double s7_250 = work.r_carrier_right_aux1_y*(s7_219 - work.s7_242);
  const double s7_251 = a_carrier_right_aux2_z + s7_250 + 3.6*(s7_216 - work.s7_239);
  work.a_carrier_right_z = s7_251 - work.s1_30*(work.s7_245 - s7_222);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s7_252 = work.alpha_carrier_right_x + work.w_carrier_right_y*s4_27;
  const double zdd_wheel_front_right = derivative.zdd[Coordinate::wheel_front_right];
  work.alpha_wheel_front_right_x = s7_252 - work.w_carrier_right_z*s4_26 -
      zdd_wheel_front_right*work.s1_36;
  const double s7_253 = zdd_wheel_front_right*work.R_carrier_right_aux2_y_y;
  const double s7_254 = work.alpha_carrier_right_y + s7_253 - work.w_carrier_right_x*s4_27;
  work.alpha_wheel_front_right_y = s7_254 - work.w_carrier_right_z*s4_25;
  const double s7_255 = work.alpha_carrier_right_z + work.w_carrier_right_y*s4_25;
  const double s7_256 = zdd_wheel_front_right*work.R_carrier_right_aux2_z_y;
  work.alpha_wheel_front_right_z = s7_255 + work.w_carrier_right_x*s4_26 + s7_256;
  const double s7_257 = work.w_wheel_front_right_x*work.w_wheel_front_right_x;
  const double s7_258 = work.w_wheel_front_right_y*work.w_wheel_front_right_y;
  const double s7_259 = work.w_wheel_front_right_z*work.w_wheel_front_right_z;
  const double s7_260 = work.w_wheel_front_right_x*work.w_wheel_front_right_y;
  const double s7_261 = work.w_wheel_front_right_x*work.w_wheel_front_right_z;
  const double s7_262 = work.w_wheel_front_right_y*work.w_wheel_front_right_z;
  work.s7_263 = s7_258 + s7_259;
  work.s7_264 = work.alpha_wheel_front_right_z + s7_260;
  work.s7_265 = s7_261 - work.alpha_wheel_front_right_y;
  work.s7_266 = s7_260 - work.alpha_wheel_front_right_z;
  work.s7_267 = s7_257 + s7_259;
  work.s7_268 = work.alpha_wheel_front_right_x + s7_262;
  work.s7_269 = work.alpha_wheel_front_right_y + s7_261;
  work.s7_270 = s7_262 - work.alpha_wheel_front_right_x;
  work.s7_271 = s7_257 + s7_258;
  work.s7_272 = work.s7_239 - work.s7_265;
  work.s7_273 = work.s7_271 - work.s7_245;
  const double s7_274 = work.r_wheel_front_right_y*(work.s7_240 - work.s7_266);
  const double s7_275 = work.r_wheel_front_right_z*(work.s7_243 - work.s7_269);
  const double s7_276 = work.r_wheel_front_right_x*(work.s7_263 - work.s7_237);
  work.a_wheel_front_right_x = work.a_carrier_right_x + s7_274 + s7_275 + s7_276;
  const double s7_277 = work.r_wheel_front_right_y*(work.s7_267 - work.s7_241);
  const double s7_278 = work.r_wheel_front_right_z*(work.s7_244 - work.s7_270);
  const double s7_279 = work.r_wheel_front_right_x*(work.s7_238 - work.s7_264);
  work.a_wheel_front_right_y = work.a_carrier_right_y + s7_277 + s7_278 + s7_279;
  work.s7_280 = work.r_wheel_front_right_y*(work.s7_242 - work.s7_268);
}

/// Part 3 of compute_multipliers: step 7: accelerations Zdot and accumulated forces QR - PR (51),
/// (52).
[[gnu::noinline]] void compute_multipliers_3(const State& state, const Derivative& derivative,
    ConstraintForcesWork& __restrict work) noexcept {
  // --- step 7: accelerations Zdot and accumulated forces QR - PR (51), (52), continued ---
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s7_281 = work.r_wheel_front_right_z*work.s7_273;
  const double s7_282 = work.a_carrier_right_z + work.s7_280 + s7_281;
  work.a_wheel_front_right_z = s7_282 + work.r_wheel_front_right_x*work.s7_272;
  // upper_arm_right: upper_arm_right, revolute, chassis
  work.alpha_upper_arm_right_x = derivative.zdd[Coordinate::upper_arm_right] + work.alpha_chassis_x;
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  const double alpha_upper_arm_right_y = work.alpha_chassis_y + zd_upper_arm_right*work.w_chassis_z;
  const double alpha_upper_arm_right_z = work.alpha_chassis_z - zd_upper_arm_right*work.w_chassis_y;
  const double s7_283 = work.w_upper_arm_right_x*work.w_upper_arm_right_x;
  work.s7_284 = alpha_upper_arm_right_z + work.w_chassis_y*work.w_upper_arm_right_x;
  work.s7_285 = work.w_chassis_z*work.w_upper_arm_right_x - alpha_upper_arm_right_y;
  work.s7_286 = work.s7_6 + s7_283;
  work.s7_287 = work.s7_7 + work.alpha_upper_arm_right_x;
  work.s7_288 = work.s7_7 - work.alpha_upper_arm_right_x;
  work.s7_289 = work.s7_5 + s7_283;
  const double s7_290 = work.a_chassis_y + 3.6*(work.s7_15 - work.s7_284);
  const double s7_291 = s7_290 - 0.28*(work.s7_21 - work.s7_288);
  work.a_upper_arm_right_y = s7_291 - 0.5*(work.s7_286 - work.s7_18);
  const double s7_292 = work.a_chassis_z + 3.6*(work.s7_16 - work.s7_285);
  const double s7_293 = s7_292 - 0.28*(work.s7_289 - work.s7_22);
  work.a_upper_arm_right_z = s7_293 - 0.5*(work.s7_19 - work.s7_287);
  // arb_front_right: arb_front_right, revolute, chassis
  work.alpha_arb_front_right_y = derivative.zdd[Coordinate::arb_front_right] + work.alpha_chassis_y;
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  work.alpha_arb_front_right_x = work.alpha_chassis_x - zd_arb_front_right*work.w_chassis_z;
  work.alpha_arb_front_right_z = work.alpha_chassis_z + zd_arb_front_right*work.w_chassis_x;
  const double s7_294 = work.w_arb_front_right_y*work.w_arb_front_right_y;
  const double s7_295 = work.w_chassis_x*work.w_arb_front_right_y;
  const double s7_296 = work.w_chassis_z*work.w_arb_front_right_y;
  work.s7_297 = work.s7_6 + s7_294;
  const double s7_298 = work.alpha_arb_front_right_z + s7_295;
  work.s7_299 = work.s7_14 - work.alpha_arb_front_right_y;
  work.s7_300 = s7_295 - work.alpha_arb_front_right_z;
  work.s7_301 = work.alpha_arb_front_right_x + s7_296;
  work.s7_302 = work.s7_14 + work.alpha_arb_front_right_y;
  const double s7_303 = s7_296 - work.alpha_arb_front_right_x;
  work.s7_304 = work.s7_12 + s7_294;
  const double s7_305 = work.a_chassis_x + 3.95*(work.s7_297 - work.s7_8);
  const double s7_306 = s7_305 - 0.5*(work.s7_20 - work.s7_302);
  work.a_arb_front_right_x = s7_306 - 0.45*(work.s7_17 - work.s7_300);
  const double s7_307 = work.a_chassis_y + 3.95*(work.s7_15 - s7_298);
  const double a_arb_front_right_y = s7_307 - 0.5*(work.s7_21 - s7_303);
  const double s7_308 = work.a_chassis_z + 3.95*(work.s7_16 - work.s7_299);
  const double s7_309 = s7_308 - 0.5*(work.s7_304 - work.s7_22);
  work.a_arb_front_right_z = s7_309 - 0.45*(work.s7_19 - work.s7_301);
  // pitman_arm: pitman_arm, revolute, chassis
  work.alpha_pitman_arm_y = derivative.zdd[Coordinate::pitman_arm] + work.alpha_chassis_y;
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double alpha_pitman_arm_x = work.alpha_chassis_x - zd_pitman_arm*work.w_chassis_z;
  const double alpha_pitman_arm_z = work.alpha_chassis_z + zd_pitman_arm*work.w_chassis_x;
  const double s7_310 = work.w_pitman_arm_y*work.w_pitman_arm_y;
  const double s7_311 = work.w_chassis_x*work.w_pitman_arm_y;
  const double s7_312 = work.w_chassis_z*work.w_pitman_arm_y;
  work.s7_313 = work.s7_6 + s7_310;
  const double s7_314 = alpha_pitman_arm_z + s7_311;
  work.s7_315 = work.s7_14 - work.alpha_pitman_arm_y;
  const double s7_316 = s7_311 - alpha_pitman_arm_z;
  work.s7_317 = alpha_pitman_arm_x + s7_312;
  work.s7_318 = work.s7_14 + work.alpha_pitman_arm_y;
  const double s7_319 = s7_312 - alpha_pitman_arm_x;
  work.s7_320 = work.s7_12 + s7_310;
  const double s7_321 = work.a_chassis_x + 0.5*(work.s7_17 - s7_316);
  const double a_pitman_arm_x = s7_321 + 4.4*(work.s7_313 - work.s7_8) - 0.4*(work.s7_20 -
      work.s7_318);
  const double a_pitman_arm_y = work.a_chassis_y + 4.4*(work.s7_15 - s7_314) - 0.4*(work.s7_21 -
      s7_319);
  const double s7_322 = work.a_chassis_z + 0.5*(work.s7_19 - work.s7_317);
  work.a_pitman_arm_z = s7_322 + 4.4*(work.s7_16 - work.s7_315) - 0.4*(work.s7_320 - work.s7_22);
  // bell_crank: bell_crank, revolute, chassis
  work.alpha_bell_crank_z = derivative.zdd[Coordinate::bell_crank] + work.alpha_chassis_z;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double alpha_bell_crank_x = work.alpha_chassis_x + zd_bell_crank*work.w_chassis_y;
  const double alpha_bell_crank_y = work.alpha_chassis_y - zd_bell_crank*work.w_chassis_x;
  const double s7_323 = work.w_bell_crank_z*work.w_bell_crank_z;
  const double s7_324 = work.w_chassis_x*work.w_bell_crank_z;
  const double s7_325 = work.w_chassis_y*work.w_bell_crank_z;
  work.s7_326 = work.s7_5 + s7_323;
  work.s7_327 = work.s7_13 + work.alpha_bell_crank_z;
  const double s7_328 = s7_324 - alpha_bell_crank_y;
  work.s7_329 = work.s7_13 - work.alpha_bell_crank_z;
  work.s7_330 = work.s7_12 + s7_323;
  const double s7_331 = alpha_bell_crank_x + s7_325;
  const double s7_332 = alpha_bell_crank_y + s7_324;
  const double s7_333 = s7_325 - alpha_bell_crank_x;
  const double s7_334 = work.a_chassis_x + 3.25*(work.s7_326 - work.s7_8);
  const double a_bell_crank_x = s7_334 - 0.6*(work.s7_20 - s7_332);
  const double s7_335 = work.a_chassis_y + 3.25*(work.s7_15 - work.s7_327);
  const double a_bell_crank_y = s7_335 - 0.6*(work.s7_21 - s7_333);
  const double a_bell_crank_z = work.a_chassis_z + 3.25*(work.s7_16 - s7_328);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s7_336 = zd_rear_axle_tx*work.w_chassis_z;
  const double s7_337 = zd_rear_axle_tx*work.w_chassis_y;
  const double a_rear_axle_aux1_x = derivative.zdd[Coordinate::rear_axle_tx] + work.a_chassis_x;
  const double a_rear_axle_aux1_y = s7_336 + (work.a_chassis_y + s7_336);
  const double a_rear_axle_aux1_z = work.a_chassis_z - s7_337 - s7_337;
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s7_338 = zd_rear_axle_ty*work.w_chassis_z;
  const double s7_339 = zd_rear_axle_ty*work.w_chassis_x;
  const double a_rear_axle_aux2_y = derivative.zdd[Coordinate::rear_axle_ty] + a_rear_axle_aux1_y;
  const double a_rear_axle_aux2_x = a_rear_axle_aux1_x - s7_338 - s7_338;
  const double a_rear_axle_aux2_z = s7_339 + (a_rear_axle_aux1_z + s7_339);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s7_340 = zd_rear_axle_tz*work.w_chassis_y;
  const double s7_341 = zd_rear_axle_tz*work.w_chassis_x;
  const double a_rear_axle_aux3_z = derivative.zdd[Coordinate::rear_axle_tz] + a_rear_axle_aux2_z;
  const double a_rear_axle_aux3_x = s7_340 + (a_rear_axle_aux2_x + s7_340);
  const double a_rear_axle_aux3_y = a_rear_axle_aux2_y - s7_341 - s7_341;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double alpha_rear_axle_aux4_z = derivative.zdd[Coordinate::rear_axle_rz] +
      work.alpha_chassis_z;
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  const double alpha_rear_axle_aux4_x = work.alpha_chassis_x + zd_rear_axle_rz*work.w_chassis_y;
  const double alpha_rear_axle_aux4_y = work.alpha_chassis_y - zd_rear_axle_rz*work.w_chassis_x;
  const double s7_342 = work.w_rear_axle_aux4_z*work.w_rear_axle_aux4_z;
  const double s7_343 = work.w_chassis_x*work.w_rear_axle_aux4_z;
  const double s7_344 = work.w_chassis_y*work.w_rear_axle_aux4_z;
  const double s7_345 = work.s7_5 + s7_342;
  const double s7_346 = work.s7_13 + alpha_rear_axle_aux4_z;
  const double s7_347 = s7_343 - alpha_rear_axle_aux4_y;
  const double s7_348 = work.s7_13 - alpha_rear_axle_aux4_z;
  const double s7_349 = work.s7_12 + s7_342;
  const double s7_350 = alpha_rear_axle_aux4_x + s7_344;
  const double s7_351 = alpha_rear_axle_aux4_y + s7_343;
  const double s7_352 = s7_344 - alpha_rear_axle_aux4_x;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s7_353 = a_rear_axle_aux3_x + z_rear_axle_ty*(work.s7_17 - s7_348);
  const double s7_354 = s7_353 + work.r_rear_axle_aux3_z*(work.s7_20 - s7_351);
  const double a_rear_axle_aux4_x = s7_354 + work.r_rear_axle_aux1_x*(s7_345 - work.s7_8);
  const double s7_355 = a_rear_axle_aux3_y + z_rear_axle_ty*(s7_349 - work.s7_18);
  const double s7_356 = s7_355 + work.r_rear_axle_aux3_z*(work.s7_21 - s7_352);
  const double a_rear_axle_aux4_y = s7_356 + work.r_rear_axle_aux1_x*(work.s7_15 - s7_346);
  const double s7_357 = a_rear_axle_aux3_z + z_rear_axle_ty*(work.s7_19 - s7_350);
  const double a_rear_axle_aux4_z = s7_357 + work.r_rear_axle_aux1_x*(work.s7_16 - s7_347);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zdd_rear_axle_ry = derivative.zdd[Coordinate::rear_axle_ry];
  const double s7_358 = alpha_rear_axle_aux4_x - zdd_rear_axle_ry*work.sines[17];
  const double alpha_rear_axle_aux5_x = s7_358 - work.w_rear_axle_aux4_z*work.s4_29;
  const double s7_359 = alpha_rear_axle_aux4_y + zdd_rear_axle_ry*work.cosines[17];
  const double alpha_rear_axle_aux5_y = s7_359 - work.w_rear_axle_aux4_z*work.s4_28;
  const double s7_360 = alpha_rear_axle_aux4_z + work.w_chassis_y*work.s4_28;
  const double alpha_rear_axle_aux5_z = s7_360 + work.w_chassis_x*work.s4_29;
  const double s7_361 = work.w_rear_axle_aux5_x*work.w_rear_axle_aux5_x;
  const double s7_362 = work.w_rear_axle_aux5_y*work.w_rear_axle_aux5_y;
  const double s7_363 = work.w_rear_axle_aux5_x*work.w_rear_axle_aux5_y;
  const double s7_364 = work.w_rear_axle_aux4_z*work.w_rear_axle_aux5_x;
  const double s7_365 = work.w_rear_axle_aux4_z*work.w_rear_axle_aux5_y;
  const double s7_366 = s7_342 + s7_362;
  const double s7_367 = alpha_rear_axle_aux5_z + s7_363;
  const double s7_368 = s7_364 - alpha_rear_axle_aux5_y;
  const double s7_369 = s7_363 - alpha_rear_axle_aux5_z;
  const double s7_370 = s7_342 + s7_361;
  const double s7_371 = alpha_rear_axle_aux5_x + s7_365;
  const double s7_372 = alpha_rear_axle_aux5_y + s7_364;
  const double s7_373 = s7_365 - alpha_rear_axle_aux5_x;
  const double s7_374 = s7_361 + s7_362;
  const double s7_375 = a_rear_axle_aux4_x + z_rear_axle_ty*(s7_348 - s7_369);
  const double s7_376 = s7_375 + work.r_rear_axle_aux3_z*(s7_351 - s7_372);
  const double a_rear_axle_aux5_x = s7_376 + work.r_rear_axle_aux1_x*(s7_366 - s7_345);
  const double s7_377 = a_rear_axle_aux4_y + z_rear_axle_ty*(s7_370 - s7_349);
  const double s7_378 = s7_377 + work.r_rear_axle_aux3_z*(s7_352 - s7_373);
  const double a_rear_axle_aux5_y = s7_378 + work.r_rear_axle_aux1_x*(s7_346 - s7_367);
  const double s7_379 = a_rear_axle_aux4_z + z_rear_axle_ty*(s7_350 - s7_371);
  const double s7_380 = s7_379 + work.r_rear_axle_aux3_z*(s7_374 - work.s7_22);
  const double a_rear_axle_aux5_z = s7_380 + work.r_rear_axle_aux1_x*(s7_347 - s7_368);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zdd_rear_axle_rx = derivative.zdd[Coordinate::rear_axle_rx];
  const double s7_381 = alpha_rear_axle_aux5_x + zdd_rear_axle_rx*work.R_rear_axle_aux5_x_x;
  const double s7_382 = s7_381 - work.w_rear_axle_aux4_z*work.s4_31;
  work.alpha_rear_axle_x = s7_382 - work.w_rear_axle_aux5_y*work.s4_32;
  const double s7_383 = alpha_rear_axle_aux5_y + work.w_rear_axle_aux5_x*work.s4_32;
  const double s7_384 = s7_383 + work.w_rear_axle_aux4_z*work.s4_30;
  work.alpha_rear_axle_y = s7_384 + zdd_rear_axle_rx*work.R_rear_axle_aux5_y_x;
  const double s7_385 = alpha_rear_axle_aux5_z + work.w_rear_axle_aux5_x*work.s4_31;
  const double s7_386 = s7_385 - work.w_rear_axle_aux5_y*work.s4_30;
  work.alpha_rear_axle_z = s7_386 - zdd_rear_axle_rx*work.sines[18];
  const double s7_387 = work.w_rear_axle_x*work.w_rear_axle_x;
  const double s7_388 = work.w_rear_axle_y*work.w_rear_axle_y;
  const double s7_389 = work.w_rear_axle_z*work.w_rear_axle_z;
  const double s7_390 = work.w_rear_axle_x*work.w_rear_axle_y;
  const double s7_391 = work.w_rear_axle_x*work.w_rear_axle_z;
  const double s7_392 = work.w_rear_axle_y*work.w_rear_axle_z;
  work.s7_393 = s7_388 + s7_389;
  work.s7_394 = work.alpha_rear_axle_z + s7_390;
  work.s7_395 = s7_391 - work.alpha_rear_axle_y;
  work.s7_396 = s7_390 - work.alpha_rear_axle_z;
  work.s7_397 = s7_387 + s7_389;
  work.s7_398 = work.alpha_rear_axle_x + s7_392;
  work.s7_399 = work.alpha_rear_axle_y + s7_391;
  work.s7_400 = s7_392 - work.alpha_rear_axle_x;
  work.s7_401 = s7_387 + s7_388;
  const double s7_402 = a_rear_axle_aux5_x + z_rear_axle_ty*(s7_369 - work.s7_396);
  const double s7_403 = s7_402 + work.r_rear_axle_aux3_z*(s7_372 - work.s7_399);
  work.a_rear_axle_x = s7_403 + work.r_rear_axle_aux1_x*(work.s7_393 - s7_366);
  const double s7_404 = a_rear_axle_aux5_y + z_rear_axle_ty*(work.s7_397 - s7_370);
  const double s7_405 = s7_404 + work.r_rear_axle_aux3_z*(s7_373 - work.s7_400);
  work.a_rear_axle_y = s7_405 + work.r_rear_axle_aux1_x*(s7_367 - work.s7_394);
  const double s7_406 = a_rear_axle_aux5_z + z_rear_axle_ty*(s7_371 - work.s7_398);
  const double s7_407 = s7_406 + work.r_rear_axle_aux3_z*(work.s7_401 - s7_374);
  work.a_rear_axle_z = s7_407 + work.r_rear_axle_aux1_x*(s7_368 - work.s7_395);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s7_408 = work.alpha_rear_axle_x + work.w_rear_axle_y*work.s4_35;
  const double zdd_wheel_rear_left = derivative.zdd[Coordinate::wheel_rear_left];
  const double s7_409 = zdd_wheel_rear_left*work.R_rear_axle_x_y;
  work.alpha_wheel_rear_left_x = s7_408 - work.w_rear_axle_z*work.s4_34 + s7_409;
  const double s7_410 = work.alpha_rear_axle_y + work.w_rear_axle_z*work.s4_33;
  const double s7_411 = zdd_wheel_rear_left*work.R_rear_axle_y_y;
  work.alpha_wheel_rear_left_y = s7_410 - work.w_rear_axle_x*work.s4_35 + s7_411;
  const double s7_412 = work.alpha_rear_axle_z + work.w_rear_axle_x*work.s4_34;
  const double s7_413 = zdd_wheel_rear_left*work.R_rear_axle_z_y;
  work.alpha_wheel_rear_left_z = s7_412 - work.w_rear_axle_y*work.s4_33 + s7_413;
  const double s7_414 = work.w_wheel_rear_left_x*work.w_wheel_rear_left_x;
  const double s7_415 = work.w_wheel_rear_left_y*work.w_wheel_rear_left_y;
  const double s7_416 = work.w_wheel_rear_left_z*work.w_wheel_rear_left_z;
  const double s7_417 = work.w_wheel_rear_left_x*work.w_wheel_rear_left_y;
  const double s7_418 = work.w_wheel_rear_left_x*work.w_wheel_rear_left_z;
  const double s7_419 = work.w_wheel_rear_left_y*work.w_wheel_rear_left_z;
  work.s7_420 = s7_415 + s7_416;
  work.s7_421 = work.alpha_wheel_rear_left_z + s7_417;
  work.s7_422 = s7_418 - work.alpha_wheel_rear_left_y;
  work.s7_423 = s7_417 - work.alpha_wheel_rear_left_z;
  work.s7_424 = s7_414 + s7_416;
  work.s7_425 = work.alpha_wheel_rear_left_x + s7_419;
  work.s7_426 = work.alpha_wheel_rear_left_y + s7_418;
  work.s7_427 = s7_419 - work.alpha_wheel_rear_left_x;
  work.s7_428 = s7_414 + s7_415;
  const double s7_429 = work.r_wheel_rear_left_y*(work.s7_396 - work.s7_423);
  const double s7_430 = work.r_wheel_rear_left_z*(work.s7_399 - work.s7_426);
  const double s7_431 = work.r_wheel_rear_left_x*(work.s7_420 - work.s7_393);
  work.a_wheel_rear_left_x = work.a_rear_axle_x + s7_429 + s7_430 + s7_431;
  const double s7_432 = work.r_wheel_rear_left_y*(work.s7_424 - work.s7_397);
  const double s7_433 = work.r_wheel_rear_left_z*(work.s7_400 - work.s7_427);
  const double s7_434 = work.r_wheel_rear_left_x*(work.s7_394 - work.s7_421);
  work.a_wheel_rear_left_y = work.a_rear_axle_y + s7_432 + s7_433 + s7_434;
  const double s7_435 = work.r_wheel_rear_left_y*(work.s7_398 - work.s7_425);
  const double s7_436 = work.r_wheel_rear_left_z*(work.s7_428 - work.s7_401);
  const double s7_437 = work.r_wheel_rear_left_x*(work.s7_395 - work.s7_422);
  work.a_wheel_rear_left_z = work.a_rear_axle_z + s7_435 + s7_436 + s7_437;
  // arb_rear_left: arb_rear_left, revolute, chassis
  work.alpha_arb_rear_left_y = derivative.zdd[Coordinate::arb_rear_left] + work.alpha_chassis_y;
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  work.alpha_arb_rear_left_x = work.alpha_chassis_x - zd_arb_rear_left*work.w_chassis_z;
  work.alpha_arb_rear_left_z = work.alpha_chassis_z + zd_arb_rear_left*work.w_chassis_x;
  const double s7_438 = work.w_arb_rear_left_y*work.w_arb_rear_left_y;
  const double s7_439 = work.w_chassis_x*work.w_arb_rear_left_y;
  const double s7_440 = work.w_chassis_z*work.w_arb_rear_left_y;
  work.s7_441 = work.s7_6 + s7_438;
  const double s7_442 = work.alpha_arb_rear_left_z + s7_439;
  work.s7_443 = work.s7_14 - work.alpha_arb_rear_left_y;
  work.s7_444 = s7_439 - work.alpha_arb_rear_left_z;
  work.s7_445 = work.alpha_arb_rear_left_x + s7_440;
  work.s7_446 = work.s7_14 + work.alpha_arb_rear_left_y;
  const double s7_447 = s7_440 - work.alpha_arb_rear_left_x;
  work.s7_448 = work.s7_12 + s7_438;
  const double s7_449 = work.a_chassis_x + 0.45*(work.s7_17 - work.s7_444);
  const double s7_450 = s7_449 - 0.44999999999999996*(work.s7_20 - work.s7_446);
  work.a_arb_rear_left_x = s7_450 - 3.3000000000000003*(work.s7_441 - work.s7_8);
  const double s7_451 = work.a_chassis_y - 0.44999999999999996*(work.s7_21 - s7_447);
  const double a_arb_rear_left_y = s7_451 - 3.3000000000000003*(work.s7_15 - s7_442);
  const double s7_452 = work.a_chassis_z + 0.45*(work.s7_19 - work.s7_445);
  const double s7_453 = s7_452 - 0.44999999999999996*(work.s7_448 - work.s7_22);
  work.a_arb_rear_left_z = s7_453 - 3.3000000000000003*(work.s7_16 - work.s7_443);
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s7_454 = work.alpha_rear_axle_x + work.w_rear_axle_y*work.s4_38;
  const double zdd_wheel_rear_right = derivative.zdd[Coordinate::wheel_rear_right];
  const double s7_455 = zdd_wheel_rear_right*work.R_rear_axle_x_y;
  work.alpha_wheel_rear_right_x = s7_454 - work.w_rear_axle_z*work.s4_37 + s7_455;
  const double s7_456 = work.alpha_rear_axle_y + work.w_rear_axle_z*work.s4_36;
  const double s7_457 = zdd_wheel_rear_right*work.R_rear_axle_y_y;
  work.alpha_wheel_rear_right_y = s7_456 - work.w_rear_axle_x*work.s4_38 + s7_457;
  const double s7_458 = work.alpha_rear_axle_z + work.w_rear_axle_x*work.s4_37;
  const double s7_459 = zdd_wheel_rear_right*work.R_rear_axle_z_y;
  work.alpha_wheel_rear_right_z = s7_458 - work.w_rear_axle_y*work.s4_36 + s7_459;
  const double s7_460 = work.w_wheel_rear_right_x*work.w_wheel_rear_right_x;
  const double s7_461 = work.w_wheel_rear_right_y*work.w_wheel_rear_right_y;
  const double s7_462 = work.w_wheel_rear_right_z*work.w_wheel_rear_right_z;
  const double s7_463 = work.w_wheel_rear_right_x*work.w_wheel_rear_right_y;
  const double s7_464 = work.w_wheel_rear_right_x*work.w_wheel_rear_right_z;
  const double s7_465 = work.w_wheel_rear_right_y*work.w_wheel_rear_right_z;
  work.s7_466 = s7_461 + s7_462;
  work.s7_467 = work.alpha_wheel_rear_right_z + s7_463;
  work.s7_468 = s7_464 - work.alpha_wheel_rear_right_y;
  work.s7_469 = s7_463 - work.alpha_wheel_rear_right_z;
  work.s7_470 = s7_460 + s7_462;
  work.s7_471 = work.alpha_wheel_rear_right_x + s7_465;
  work.s7_472 = work.alpha_wheel_rear_right_y + s7_464;
  work.s7_473 = s7_465 - work.alpha_wheel_rear_right_x;
  work.s7_474 = s7_460 + s7_461;
  const double s7_475 = work.r_wheel_rear_right_y*(work.s7_396 - work.s7_469);
  const double s7_476 = work.r_wheel_rear_right_z*(work.s7_399 - work.s7_472);
  const double s7_477 = work.r_wheel_rear_right_x*(work.s7_466 - work.s7_393);
  work.a_wheel_rear_right_x = work.a_rear_axle_x + s7_475 + s7_476 + s7_477;
  const double s7_478 = work.r_wheel_rear_right_y*(work.s7_470 - work.s7_397);
  const double s7_479 = work.r_wheel_rear_right_z*(work.s7_400 - work.s7_473);
  const double s7_480 = work.r_wheel_rear_right_x*(work.s7_394 - work.s7_467);
  work.a_wheel_rear_right_y = work.a_rear_axle_y + s7_478 + s7_479 + s7_480;
  const double s7_481 = work.r_wheel_rear_right_y*(work.s7_398 - work.s7_471);
  const double s7_482 = work.r_wheel_rear_right_z*(work.s7_474 - work.s7_401);
  const double s7_483 = work.r_wheel_rear_right_x*(work.s7_395 - work.s7_468);
  work.a_wheel_rear_right_z = work.a_rear_axle_z + s7_481 + s7_482 + s7_483;
  // arb_rear_right: arb_rear_right, revolute, chassis
  work.alpha_arb_rear_right_y = derivative.zdd[Coordinate::arb_rear_right] + work.alpha_chassis_y;
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  work.alpha_arb_rear_right_x = work.alpha_chassis_x - zd_arb_rear_right*work.w_chassis_z;
  work.alpha_arb_rear_right_z = work.alpha_chassis_z + zd_arb_rear_right*work.w_chassis_x;
  const double s7_484 = work.w_arb_rear_right_y*work.w_arb_rear_right_y;
  const double s7_485 = work.w_chassis_x*work.w_arb_rear_right_y;
  const double s7_486 = work.w_chassis_z*work.w_arb_rear_right_y;
  work.s7_487 = work.s7_6 + s7_484;
  const double s7_488 = work.alpha_arb_rear_right_z + s7_485;
  work.s7_489 = work.s7_14 - work.alpha_arb_rear_right_y;
  work.s7_490 = s7_485 - work.alpha_arb_rear_right_z;
  work.s7_491 = work.alpha_arb_rear_right_x + s7_486;
  work.s7_492 = work.s7_14 + work.alpha_arb_rear_right_y;
  const double s7_493 = s7_486 - work.alpha_arb_rear_right_x;
  work.s7_494 = work.s7_12 + s7_484;
  const double s7_495 = work.a_chassis_x - 0.45*(work.s7_17 - work.s7_490);
  const double s7_496 = s7_495 - 0.44999999999999996*(work.s7_20 - work.s7_492);
  work.a_arb_rear_right_x = s7_496 - 3.3000000000000003*(work.s7_487 - work.s7_8);
  const double s7_497 = work.a_chassis_y - 0.44999999999999996*(work.s7_21 - s7_493);
  const double a_arb_rear_right_y = s7_497 - 3.3000000000000003*(work.s7_15 - s7_488);
  const double s7_498 = work.a_chassis_z - 0.45*(work.s7_19 - work.s7_491);
  const double s7_499 = s7_498 - 0.44999999999999996*(work.s7_494 - work.s7_22);
  work.a_arb_rear_right_z = s7_499 - 3.3000000000000003*(work.s7_16 - work.s7_489);
  // arb_link_front_left
  const double s7_500 = work.a_carrier_left_x + work.s1_362*work.s7_97 + work.s1_365*work.s7_100;
  const double s7_501 = work.a_carrier_left_z + work.s1_362*work.s7_99 + work.s1_359*work.s7_96;
  work.s7_502 = 0.3333333333333333*(s7_500 - work.s1_359*work.s7_94);
  work.s7_503 = 0.3333333333333333*(s7_501 - work.s1_365*work.s7_102);
  const double s7_504 = 0.72*work.s7_18;
  const double s7_505 = work.a_arb_front_left_x + 0.72*work.s7_155 + work.s1_369*work.s7_157;
  const double s7_506 = work.a_arb_front_left_y - s7_504 + work.s1_369*work.s7_158;
  const double s7_507 = work.a_arb_front_left_z + 0.72*work.s7_156 + work.s1_367*work.s7_154;
  work.s7_508 = 0.3333333333333333*(s7_505 - work.s1_367*work.s7_152);
  work.s7_509 = 0.3333333333333333*(s7_506 + work.s1_367*work.s7_153);
  work.s7_510 = 0.3333333333333333*(s7_507 - work.s1_369*work.s7_159);
  // arb_link_front_right
  const double s7_511 = work.a_carrier_right_x + work.s1_375*work.s7_240;
  const double s7_512 = work.a_carrier_right_z + work.s1_375*work.s7_242;
  const double s7_513 = s7_511 + work.s1_378*work.s7_243 - work.s1_371*work.s7_237;
  work.s7_514 = 0.3333333333333333*s7_513;
  const double s7_515 = s7_512 + work.s1_371*work.s7_239 - work.s1_378*work.s7_245;
  work.s7_516 = 0.3333333333333333*s7_515;
  const double s7_517 = work.a_arb_front_right_x + work.s1_382*work.s7_302;
  const double s7_518 = work.a_arb_front_right_z + work.s1_380*work.s7_299;
  work.s7_519 = 0.3333333333333333*(s7_517 - work.s1_380*work.s7_297 - 0.72*work.s7_300);
  const double s7_520 = a_arb_front_right_y + s7_504 + work.s1_382*s7_303 + work.s1_380*s7_298;
  work.s7_521 = 0.3333333333333333*s7_520;
  work.s7_522 = 0.3333333333333333*(s7_518 - work.s1_382*work.s7_304 - 0.72*work.s7_301);
  // drag_link
  work.s7_523 = a_bell_crank_x - 0.6*s7_332;
  const double s7_524 = a_bell_crank_z + 0.6*work.s7_22;
  work.s7_525 = 1.5*(work.s7_523 + work.s1_383*work.s7_329 - work.s1_384*work.s7_326);
  work.s7_526 = 1.5*(s7_524 + work.s1_383*s7_331 + work.s1_384*s7_328);
  work.s7_527 = a_pitman_arm_x + 0.5*s7_316;
  const double s7_528 = a_pitman_arm_y + work.s1_385*s7_314 - work.s1_386*s7_319;
  work.s7_529 = 1.5*(work.s7_527 - work.s1_386*work.s7_318 - work.s1_385*work.s7_313);
  work.s7_530 = 1.5*(s7_528 - 0.5*work.s7_18);
  // tie_rod_left
  const double s7_531 = work.a_carrier_left_x + work.s1_393*work.s7_97 + work.s1_397*work.s7_100;
  const double s7_532 = work.a_carrier_left_y + work.s1_397*work.s7_101 + work.s1_389*work.s7_95;
  work.s7_533 = 1.1666666666666667*(s7_531 - work.s1_389*work.s7_94);
  work.s7_534 = 1.1666666666666667*(s7_532 - work.s1_393*work.s7_98);
  work.s7_535 = a_bell_crank_y - 0.6*s7_333;
  const double s7_536 = work.s7_523 + work.s1_402*work.s7_329 - work.s1_403*work.s7_326;
  work.s7_537 = 1.1666666666666667*s7_536;
  const double s7_538 = work.s7_535 + work.s1_403*work.s7_327 - work.s1_402*work.s7_330;
  work.s7_539 = 1.1666666666666667*s7_538;
  work.s7_540 = 1.1666666666666667*(s7_524 + work.s1_402*s7_331 + work.s1_403*s7_328);
  // tie_rod_right
  const double s7_541 = work.a_carrier_right_x + work.s1_410*work.s7_240;
  const double s7_542 = work.a_carrier_right_y + work.s1_413*work.s7_244;
  const double s7_543 = s7_541 + work.s1_413*work.s7_243 - work.s1_406*work.s7_237;
  work.s7_544 = 1.1666666666666667*s7_543;
  const double s7_545 = s7_542 + work.s1_406*work.s7_238 - work.s1_410*work.s7_241;
  work.s7_546 = 1.1666666666666667*s7_545;
  const double s7_547 = work.s7_523 - work.s1_414*work.s7_329 - work.s1_415*work.s7_326;
  work.s7_548 = 1.1666666666666667*s7_547;
  const double s7_549 = work.s7_535 + work.s1_414*work.s7_330 + work.s1_415*work.s7_327;
  work.s7_550 = 1.1666666666666667*s7_549;
  work.s7_551 = 1.1666666666666667*(s7_524 + work.s1_415*s7_328 - work.s1_414*s7_331);
  // long_rod_left
  const double s7_552 = 0.55*work.s7_17;
  const double s7_553 = 0.55*work.s7_18;
  const double s7_554 = 0.55*work.s7_21 + 1.6*work.s7_15;
  const double s7_555 = 0.55*work.s7_19;
  const double s7_556 = work.a_chassis_x + (1.6*work.s7_8 - 0.55*work.s7_20);
  const double s7_557 = work.a_chassis_z + (0.55*work.s7_22 - 1.6*work.s7_16);
  work.s7_558 = 3.0*(s7_552 + s7_556);
  work.s7_559 = 3.0*(work.a_chassis_y - s7_553 - s7_554);
  work.s7_560 = 3.0*(s7_555 + s7_557);
  // diag_rod_left
  const double s7_561 = 0.4*work.s7_17;
  const double s7_562 = 0.4*work.s7_18;
  const double s7_563 = 0.15000000000000002*work.s7_21 + 1.6999999999999997*work.s7_15;
  const double s7_564 = 0.4*work.s7_19;
  const double s7_565 = 1.6999999999999997*work.s7_8 - 0.15000000000000002*work.s7_20;
  const double s7_566 = work.a_chassis_x + s7_565;
  const double s7_567 = 0.15000000000000002*work.s7_22 - 1.6999999999999997*work.s7_16;
  const double s7_568 = work.a_chassis_z + s7_567;
  work.s7_569 = 2.6666666666666665*(s7_561 + s7_566);
  work.s7_570 = 2.6666666666666665*(work.a_chassis_y - s7_562 - s7_563);
  work.s7_571 = 2.6666666666666665*(s7_564 + s7_568);
  // arb_link_rear_left
  const double s7_572 = work.a_rear_axle_x + work.s1_445*work.s7_396 + work.s1_448*work.s7_399;
  const double s7_573 = work.a_rear_axle_z + work.s1_445*work.s7_398 + work.s1_444*work.s7_395;
  work.s7_574 = 0.3333333333333333*(s7_572 - work.s1_444*work.s7_393);
  work.s7_575 = 0.3333333333333333*(s7_573 - work.s1_448*work.s7_401);
  const double s7_576 = 0.6*work.s7_18;
  const double s7_577 = work.a_arb_rear_left_x + 0.6*work.s7_444 - work.s1_450*work.s7_446;
  const double s7_578 = work.a_arb_rear_left_z + 0.6*work.s7_445 + work.s1_450*work.s7_448;
  work.s7_579 = 0.3333333333333333*(s7_577 - work.s1_449*work.s7_441);
  const double s7_580 = a_arb_rear_left_y - s7_576 + work.s1_449*s7_442 - work.s1_450*s7_447;
  work.s7_581 = 0.3333333333333333*s7_580;
  work.s7_582 = 0.3333333333333333*(s7_578 + work.s1_449*work.s7_443);
  // long_rod_right
  work.s7_583 = 3.0*(s7_556 - s7_552);
  work.s7_584 = 3.0*(work.a_chassis_y + s7_553 - s7_554);
  work.s7_585 = 3.0*(s7_557 - s7_555);
  // diag_rod_right
  work.s7_586 = 2.6666666666666665*(s7_566 - s7_561);
  work.s7_587 = 2.6666666666666665*(work.a_chassis_y + s7_562 - s7_563);
  work.s7_588 = 2.6666666666666665*(s7_568 - s7_564);
  // arb_link_rear_right
  const double s7_589 = work.a_rear_axle_x + work.s1_458*work.s7_396 + work.s1_459*work.s7_399;
  const double s7_590 = work.a_rear_axle_z + work.s1_458*work.s7_398 + work.s1_457*work.s7_395;
  work.s7_591 = 0.3333333333333333*(s7_589 - work.s1_457*work.s7_393);
  work.s7_592 = 0.3333333333333333*(s7_590 - work.s1_459*work.s7_401);
  const double s7_593 = work.a_arb_rear_right_x - 0.6*work.s7_490 - work.s1_461*work.s7_492;
  const double s7_594 = work.a_arb_rear_right_z + work.s1_461*work.s7_494;
  work.s7_595 = 0.3333333333333333*(s7_593 - work.s1_460*work.s7_487);
  const double s7_596 = a_arb_rear_right_y + s7_576 + work.s1_460*s7_488 - work.s1_461*s7_493;
  work.s7_597 = 0.3333333333333333*s7_596;
  work.s7_598 = 0.3333333333333333*(s7_594 + work.s1_460*work.s7_489 - 0.6*work.s7_491);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s7_599 = work.a_lower_arm_left_y + work.s1_65*work.s7_32 + 3.6*work.s7_26;
  const double s7_600 = work.a_lower_arm_left_z + work.s1_63*work.s7_30 + 3.6*work.s7_27;
  work.s7_601 = 25.0*(s7_599 - work.s1_63*work.s7_29);
  work.s7_602 = 25.0*(s7_600 - work.s1_65*work.s7_33);
  work.s7_603 = work.s1_69*work.w_chassis_y + work.s1_71*work.w_chassis_z;
  work.s7_604 = work.s1_71*work.w_chassis_y + work.s1_70*work.w_chassis_z;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_605 = work.a_carrier_left_x + work.s1_78*work.s7_97 + work.s1_82*work.s7_100;
  const double s7_606 = work.a_carrier_left_y + work.s1_82*work.s7_101 + work.s1_74*work.s7_95;
  const double s7_607 = work.a_carrier_left_z + work.s1_78*work.s7_99 + work.s1_74*work.s7_96;
  work.s7_608 = 113.0*(s7_605 - work.s1_74*work.s7_94);
  work.s7_609 = 113.0*(s7_606 - work.s1_78*work.s7_98);
  work.s7_610 = 113.0*(s7_607 - work.s1_82*work.s7_102);
  const double s7_611 = work.s1_116*work.w_carrier_left_y + work.s1_118*work.w_carrier_left_z;
  work.s7_612 = s7_611 + work.s1_110*work.w_carrier_left_x;
  const double s7_613 = work.s1_112*work.w_carrier_left_y + work.s1_120*work.w_carrier_left_z;
  work.s7_614 = s7_613 + work.s1_116*work.w_carrier_left_x;
  const double s7_615 = work.s1_120*work.w_carrier_left_y + work.s1_114*work.w_carrier_left_z;
  work.s7_616 = s7_615 + work.s1_118*work.w_carrier_left_x;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s7_617 = work.a_wheel_front_left_x + work.r_wheel_front_left_y*work.s7_123;
  const double s7_618 = s7_617 + work.r_wheel_front_left_z*work.s7_126;
  const double s7_619 = work.a_wheel_front_left_y + work.r_wheel_front_left_z*work.s7_127;
  const double s7_620 = s7_619 + work.r_wheel_front_left_x*work.s7_121;
  const double s7_621 = work.a_wheel_front_left_z + work.r_wheel_front_left_y*work.s7_125;
  const double s7_622 = s7_621 + work.r_wheel_front_left_x*work.s7_122;
  work.s7_623 = 105.0*(s7_618 - work.r_wheel_front_left_x*work.s7_120);
  work.s7_624 = 105.0*(s7_620 - work.r_wheel_front_left_y*work.s7_124);
  work.s7_625 = 105.0*(s7_622 - work.r_wheel_front_left_z*work.s7_128);
  const double s7_626 = work.s1_135*work.w_wheel_front_left_y;
  const double s7_627 = s7_626 + work.s1_137*work.w_wheel_front_left_z;
  work.s7_628 = s7_627 + work.s1_129*work.w_wheel_front_left_x;
  const double s7_629 = work.s1_131*work.w_wheel_front_left_y;
  const double s7_630 = s7_629 + work.s1_139*work.w_wheel_front_left_z;
  work.s7_631 = s7_630 + work.s1_135*work.w_wheel_front_left_x;
  const double s7_632 = work.s1_139*work.w_wheel_front_left_y;
  const double s7_633 = s7_632 + work.s1_133*work.w_wheel_front_left_z;
  work.s7_634 = s7_633 + work.s1_137*work.w_wheel_front_left_x;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double s7_635 = work.a_upper_arm_left_y + work.s1_143*work.s7_143 + 3.6*work.s7_139;
  const double s7_636 = work.a_upper_arm_left_z + work.s1_141*work.s7_142 + 3.6*work.s7_140;
  work.s7_637 = 15.0*(s7_635 - work.s1_141*work.s7_141);
  work.s7_638 = 15.0*(s7_636 - work.s1_143*work.s7_144);
  work.s7_639 = work.s1_147*work.w_chassis_y + work.s1_149*work.w_chassis_z;
  work.s7_640 = work.s1_149*work.w_chassis_y + work.s1_148*work.w_chassis_z;
  // arb_front_left: arb_front_left, revolute, chassis
  const double s7_641 = work.a_arb_front_left_x + 0.5169230769230769*work.s7_155;
  const double s7_642 = work.a_arb_front_left_z + 0.5169230769230769*work.s7_156;
  const double s7_643 = s7_641 + work.s1_153*work.s7_157 - work.s1_151*work.s7_152;
  work.s7_644 = 8.666666666666666*s7_643;
  const double s7_645 = s7_642 + work.s1_151*work.s7_154 - work.s1_153*work.s7_159;
  work.s7_646 = 8.666666666666666*s7_645;
  const double s7_647 = work.s1_156*work.w_arb_front_left_y + work.s1_166*work.w_chassis_z;
  work.s7_648 = s7_647 + work.s1_164*work.w_chassis_x;
  const double s7_649 = work.s1_165*work.w_chassis_z + work.s1_166*work.w_chassis_x;
  work.s7_650 = s7_649 - work.s1_160*work.w_arb_front_left_y;
  work.s7_651 = work.s7_502 + work.s7_644;
  work.s7_652 = work.s7_503 + work.s7_646;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double s7_653 = work.a_lower_arm_right_y + 3.6*work.s7_167 - work.s1_170*work.s7_173;
  const double s7_654 = work.a_lower_arm_right_z + work.s1_168*work.s7_171;
  work.s7_655 = 25.0*(s7_653 - work.s1_168*work.s7_170);
  work.s7_656 = 25.0*(s7_654 + work.s1_170*work.s7_174 + 3.6*work.s7_168);
  work.s7_657 = work.s1_174*work.w_chassis_y + work.s1_176*work.w_chassis_z;
  work.s7_658 = work.s1_176*work.w_chassis_y + work.s1_175*work.w_chassis_z;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_659 = work.a_carrier_right_x + work.s1_183*work.s7_240;
  const double s7_660 = work.a_carrier_right_y + work.s1_186*work.s7_244;
  const double s7_661 = work.a_carrier_right_z + work.s1_183*work.s7_242;
  work.s7_662 = 113.0*(s7_659 + work.s1_186*work.s7_243 - work.s1_179*work.s7_237);
  work.s7_663 = 113.0*(s7_660 + work.s1_179*work.s7_238 - work.s1_183*work.s7_241);
  work.s7_664 = 113.0*(s7_661 + work.s1_179*work.s7_239 - work.s1_186*work.s7_245);
  const double s7_665 = work.s1_219*work.w_carrier_right_y + work.s1_221*work.w_carrier_right_z;
  work.s7_666 = s7_665 + work.s1_213*work.w_carrier_right_x;
  const double s7_667 = work.s1_215*work.w_carrier_right_y + work.s1_223*work.w_carrier_right_z;
  work.s7_668 = s7_667 + work.s1_219*work.w_carrier_right_x;
  const double s7_669 = work.s1_223*work.w_carrier_right_y + work.s1_217*work.w_carrier_right_z;
  work.s7_670 = s7_669 + work.s1_221*work.w_carrier_right_x;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  work.s7_671 = work.a_wheel_front_right_x + work.r_wheel_front_right_y*work.s7_266;
}

/// Part 4 of compute_multipliers: step 7: accelerations Zdot and accumulated forces QR - PR (51),
/// (52).
[[gnu::noinline]] void compute_multipliers_4(const State& state, const double* tau,
    ConstraintForcesWork& __restrict work, ConstraintForces& __restrict result) noexcept {
  // --- step 7: accelerations Zdot and accumulated forces QR - PR (51), (52), continued ---
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s7_672 = work.s7_671 + work.r_wheel_front_right_z*work.s7_269;
  const double s7_673 = work.a_wheel_front_right_y + work.r_wheel_front_right_z*work.s7_270;
  const double s7_674 = s7_673 + work.r_wheel_front_right_x*work.s7_264;
  const double s7_675 = work.a_wheel_front_right_z + work.r_wheel_front_right_y*work.s7_268;
  const double s7_676 = s7_675 + work.r_wheel_front_right_x*work.s7_265;
  const double s7_677 = 105.0*(s7_672 - work.r_wheel_front_right_x*work.s7_263);
  const double s7_678 = 105.0*(s7_674 - work.r_wheel_front_right_y*work.s7_267);
  const double s7_679 = 105.0*(s7_676 - work.r_wheel_front_right_z*work.s7_271);
  const double s7_680 = work.s1_238*work.w_wheel_front_right_y;
  const double s7_681 = s7_680 + work.s1_240*work.w_wheel_front_right_z;
  const double s7_682 = s7_681 + work.s1_232*work.w_wheel_front_right_x;
  const double s7_683 = work.s1_234*work.w_wheel_front_right_y;
  const double s7_684 = s7_683 + work.s1_242*work.w_wheel_front_right_z;
  const double s7_685 = s7_684 + work.s1_238*work.w_wheel_front_right_x;
  const double s7_686 = work.s1_242*work.w_wheel_front_right_y;
  const double s7_687 = s7_686 + work.s1_236*work.w_wheel_front_right_z;
  const double s7_688 = s7_687 + work.s1_240*work.w_wheel_front_right_x;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double s7_689 = work.a_upper_arm_right_y + 3.6*work.s7_284 - work.s1_246*work.s7_288;
  const double s7_690 = work.a_upper_arm_right_z + work.s1_244*work.s7_287;
  // arb_front_right: arb_front_right, revolute, chassis
  const double s7_691 = work.a_arb_front_right_x + work.s1_256*work.s7_302;
  const double s7_692 = work.a_arb_front_right_z + work.s1_254*work.s7_299;
  const double s7_693 = s7_691 - work.s1_254*work.s7_297 - 0.5169230769230769*work.s7_300;
  const double s7_694 = 8.666666666666666*s7_693;
  const double s7_695 = s7_692 - work.s1_256*work.s7_304 - 0.5169230769230769*work.s7_301;
  const double s7_696 = 8.666666666666666*s7_695;
  const double s7_697 = work.s1_259*work.w_arb_front_right_y + work.s1_269*work.w_chassis_z;
  const double s7_698 = work.s1_263*work.w_arb_front_right_y + work.s1_268*work.w_chassis_z;
  // pitman_arm: pitman_arm, revolute, chassis
  const double s7_699 = work.a_pitman_arm_z + 0.5*work.s7_317 + work.s1_271*work.s7_320;
  const double s7_700 = 9.0*(work.s7_527 - work.s1_271*work.s7_318 - work.s1_270*work.s7_313);
  const double s7_701 = 9.0*(s7_699 + work.s1_270*work.s7_315);
  // bell_crank: bell_crank, revolute, chassis
  const double s7_702 = work.s7_523 + work.s1_279*work.s7_329 - work.s1_281*work.s7_326;
  const double s7_703 = work.s7_535 + work.s1_281*work.s7_327 - work.s1_279*work.s7_330;
  const double s7_704 = 16.666666666666668*s7_703;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_705 = work.a_rear_axle_x + work.s1_293*work.s7_396 + work.s1_295*work.s7_399;
  const double s7_706 = work.a_rear_axle_y + work.s1_295*work.s7_400 + work.s1_291*work.s7_394;
  const double s7_707 = work.a_rear_axle_z + work.s1_293*work.s7_398 + work.s1_291*work.s7_395;
  const double s7_708 = 774.0*(s7_705 - work.s1_291*work.s7_393);
  const double s7_709 = 774.0*(s7_706 - work.s1_293*work.s7_397);
  const double s7_710 = 774.0*(s7_707 - work.s1_295*work.s7_401);
  const double s7_711 = work.s1_314*work.w_rear_axle_y + work.s1_316*work.w_rear_axle_z;
  const double s7_712 = s7_711 + work.s1_309*work.w_rear_axle_x;
  const double s7_713 = work.s1_311*work.w_rear_axle_y + work.s1_318*work.w_rear_axle_z;
  const double s7_714 = s7_713 + work.s1_314*work.w_rear_axle_x;
  const double s7_715 = work.s1_318*work.w_rear_axle_y + work.s1_312*work.w_rear_axle_z;
  const double s7_716 = s7_715 + work.s1_316*work.w_rear_axle_x;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s7_717 = work.a_wheel_rear_left_x + work.r_wheel_rear_left_y*work.s7_423;
  const double s7_718 = s7_717 + work.r_wheel_rear_left_z*work.s7_426;
  const double s7_719 = work.a_wheel_rear_left_y + work.r_wheel_rear_left_z*work.s7_427;
  const double s7_720 = s7_719 + work.r_wheel_rear_left_x*work.s7_421;
  const double s7_721 = work.a_wheel_rear_left_z + work.r_wheel_rear_left_y*work.s7_425;
  const double s7_722 = s7_721 + work.r_wheel_rear_left_x*work.s7_422;
  const double s7_723 = 200.0*(s7_718 - work.r_wheel_rear_left_x*work.s7_420);
  const double s7_724 = 200.0*(s7_720 - work.r_wheel_rear_left_y*work.s7_424);
  const double s7_725 = 200.0*(s7_722 - work.r_wheel_rear_left_z*work.s7_428);
  const double s7_726 = work.s1_332*work.w_wheel_rear_left_y;
  const double s7_727 = s7_726 + work.s1_334*work.w_wheel_rear_left_z;
  const double s7_728 = s7_727 + work.s1_327*work.w_wheel_rear_left_x;
  const double s7_729 = work.s1_329*work.w_wheel_rear_left_y;
  const double s7_730 = s7_729 + work.s1_336*work.w_wheel_rear_left_z;
  const double s7_731 = s7_730 + work.s1_332*work.w_wheel_rear_left_x;
  const double s7_732 = work.s1_336*work.w_wheel_rear_left_y;
  const double s7_733 = s7_732 + work.s1_330*work.w_wheel_rear_left_z;
  const double s7_734 = s7_733 + work.s1_334*work.w_wheel_rear_left_x;
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s7_735 = work.a_arb_rear_left_x + 0.5076923076923077*work.s7_444;
  const double s7_736 = work.a_arb_rear_left_z + 0.5076923076923077*work.s7_445;
  const double s7_737 = s7_735 - work.s1_338*work.s7_446 - work.s1_337*work.s7_441;
  const double s7_738 = 8.666666666666666*s7_737;
  const double s7_739 = s7_736 + work.s1_338*work.s7_448 + work.s1_337*work.s7_443;
  const double s7_740 = 8.666666666666666*s7_739;
  const double s7_741 = work.s1_346*work.w_chassis_z + work.s1_344*work.w_chassis_x;
  const double s7_742 = work.s1_341*work.w_arb_rear_left_y + work.s1_345*work.w_chassis_z;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s7_743 = work.a_wheel_rear_right_x + work.r_wheel_rear_right_y*work.s7_469;
  const double s7_744 = s7_743 + work.r_wheel_rear_right_z*work.s7_472;
  const double s7_745 = work.a_wheel_rear_right_y + work.r_wheel_rear_right_z*work.s7_473;
  const double s7_746 = s7_745 + work.r_wheel_rear_right_x*work.s7_467;
  const double s7_747 = work.a_wheel_rear_right_z + work.r_wheel_rear_right_y*work.s7_471;
  const double s7_748 = s7_747 + work.r_wheel_rear_right_x*work.s7_468;
  const double s7_749 = 200.0*(s7_744 - work.r_wheel_rear_right_x*work.s7_466);
  const double s7_750 = 200.0*(s7_746 - work.r_wheel_rear_right_y*work.s7_470);
  const double s7_751 = 200.0*(s7_748 - work.r_wheel_rear_right_z*work.s7_474);
  const double s7_752 = work.s1_332*work.w_wheel_rear_right_y;
  const double s7_753 = s7_752 + work.s1_334*work.w_wheel_rear_right_z;
  const double s7_754 = s7_753 + work.s1_327*work.w_wheel_rear_right_x;
  const double s7_755 = work.s1_329*work.w_wheel_rear_right_y;
  const double s7_756 = s7_755 + work.s1_336*work.w_wheel_rear_right_z;
  const double s7_757 = s7_756 + work.s1_332*work.w_wheel_rear_right_x;
  const double s7_758 = work.s1_336*work.w_wheel_rear_right_y;
  const double s7_759 = s7_758 + work.s1_330*work.w_wheel_rear_right_z;
  const double s7_760 = s7_759 + work.s1_334*work.w_wheel_rear_right_x;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s7_761 = work.a_arb_rear_right_x - 0.5076923076923077*work.s7_490;
  const double s7_762 = work.a_arb_rear_right_z + work.s1_348*work.s7_494;
  const double s7_763 = s7_761 - work.s1_348*work.s7_492 - work.s1_347*work.s7_487;
  const double s7_764 = 8.666666666666666*s7_763;
  const double s7_765 = s7_762 + work.s1_347*work.s7_489 - 0.5076923076923077*work.s7_491;
  const double s7_766 = 8.666666666666666*s7_765;
  const double s7_767 = work.s1_349*work.w_arb_rear_right_y + work.s1_356*work.w_chassis_z;
  const double s7_768 = work.s1_355*work.w_chassis_z + work.s1_356*work.w_chassis_x;
  const double s7_769 = tau[Coordinate::arb_rear_right] + work.s1_460*work.s7_592;
  const double s7_770 = work.w_chassis_z*(s7_767 + work.s1_354*work.w_chassis_x);
  const double s7_771 = work.w_chassis_x*(s7_768 - work.s1_351*work.w_arb_rear_right_y);
  const double s7_772 = s7_769 + work.s1_461*work.s7_591 - s7_770 + s7_771;
  const double s7_773 = s7_772 - 0.14461538461538465*work.alpha_arb_rear_right_y;
  const double s7_774 = s7_773 - work.s1_349*work.alpha_arb_rear_right_x;
  const double s7_775 = s7_774 + work.s1_351*work.alpha_arb_rear_right_z + work.s1_347*s7_766;
  const double s7_776 = s7_775 + work.s1_348*s7_764 + 3.3000000000000003*(work.s7_592 + s7_766);
  work.Q_arb_rear_right = s7_776 - 0.44999999999999996*(work.s7_591 + s7_764);
  result.missing[21] = work.Q_arb_rear_right;
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s7_777 = tau[Coordinate::arb_rear_left] + work.s1_449*work.s7_575;
  const double s7_778 = work.w_chassis_z*(s7_741 - work.s1_339*work.w_arb_rear_left_y);
  const double s7_779 = work.w_chassis_x*(s7_742 + work.s1_346*work.w_chassis_x);
  const double s7_780 = s7_777 + work.s1_450*work.s7_574 - s7_778 + s7_779;
  const double s7_781 = s7_780 - 0.14461538461538465*work.alpha_arb_rear_left_y;
  const double s7_782 = s7_781 - work.s1_341*work.alpha_arb_rear_left_z;
  const double s7_783 = s7_782 + work.s1_339*work.alpha_arb_rear_left_x + work.s1_337*s7_740;
  const double s7_784 = s7_783 + work.s1_338*s7_738 + 3.3000000000000003*(work.s7_575 + s7_740);
  work.Q_arb_rear_left = s7_784 - 0.44999999999999996*(work.s7_574 + s7_738);
  result.missing[20] = work.Q_arb_rear_left;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s7_785 = work.s7_583 + (work.s7_586 + (work.s7_595 + (s7_708 + s7_749)));
  const double s7_786 = s7_723 + (work.s7_558 + (work.s7_569 + (work.s7_579 + s7_785)));
  const double s7_787 = work.s7_584 + (work.s7_587 + (work.s7_597 + (s7_709 + s7_750)));
  const double s7_788 = s7_724 + (work.s7_559 + (work.s7_570 + (work.s7_581 + s7_787)));
  const double s7_789 = work.s7_585 + (work.s7_588 + (work.s7_598 + (s7_710 + s7_751)));
  const double s7_790 = s7_725 + (work.s7_560 + (work.s7_571 + (work.s7_582 + s7_789)));
  const double s7_791 = work.alpha_wheel_rear_left_x + work.alpha_wheel_rear_right_x;
  const double s7_792 = work.alpha_wheel_rear_left_y + work.alpha_wheel_rear_right_y;
  const double s7_793 = work.alpha_wheel_rear_left_z + work.alpha_wheel_rear_right_z;
  const double s7_794 = work.s1_427*work.s7_559 - work.s1_426*work.s7_560;
  const double s7_795 = s7_794 + work.s1_436*work.s7_570 - work.s1_434*work.s7_571;
  const double s7_796 = s7_795 + work.s1_448*work.s7_581 - work.s1_445*work.s7_582;
  const double s7_797 = s7_796 + work.s1_453*work.s7_584 - work.s1_452*work.s7_585;
  const double s7_798 = s7_797 + work.s1_456*work.s7_587 - work.s1_455*work.s7_588;
  const double s7_799 = s7_798 + work.s1_459*work.s7_597 - work.s1_458*work.s7_598;
  const double s7_800 = s7_799 - work.w_rear_axle_y*s7_716 + work.w_rear_axle_z*s7_714;
  const double s7_801 = s7_800 - work.s1_314*work.alpha_rear_axle_y;
  const double s7_802 = s7_801 - work.s1_316*work.alpha_rear_axle_z;
  const double s7_803 = s7_802 - work.s1_309*work.alpha_rear_axle_x - work.s1_293*s7_710;
  const double s7_804 = s7_803 + work.s1_295*s7_709 - work.w_wheel_rear_right_y*s7_760;
  const double s7_805 = s7_804 + work.w_wheel_rear_right_z*s7_757;
  const double s7_806 = s7_805 - work.r_wheel_rear_right_y*s7_751;
  const double s7_807 = s7_806 + work.r_wheel_rear_right_z*s7_750;
  const double s7_808 = s7_807 - work.w_wheel_rear_left_y*s7_734;
  const double s7_809 = s7_808 + work.w_wheel_rear_left_z*s7_731;
  const double s7_810 = s7_809 - work.r_wheel_rear_left_y*s7_725;
  const double s7_811 = s7_810 + work.r_wheel_rear_left_z*s7_724 - work.s1_327*s7_791;
  const double s7_812 = s7_811 - work.s1_332*s7_792 - work.s1_334*s7_793;
  const double s7_813 = work.s1_424*work.s7_560 - work.s1_427*work.s7_558;
  const double s7_814 = s7_813 + work.s1_432*work.s7_571 - work.s1_436*work.s7_569;
  const double s7_815 = s7_814 + work.s1_444*work.s7_582 - work.s1_448*work.s7_579;
  const double s7_816 = s7_815 + work.s1_451*work.s7_585 - work.s1_453*work.s7_583;
  const double s7_817 = s7_816 + work.s1_454*work.s7_588 - work.s1_456*work.s7_586;
  const double s7_818 = s7_817 + work.s1_457*work.s7_598 - work.s1_459*work.s7_595;
  const double s7_819 = s7_818 - work.w_rear_axle_z*s7_712 + work.w_rear_axle_x*s7_716;
  const double s7_820 = s7_819 - work.s1_311*work.alpha_rear_axle_y;
  const double s7_821 = s7_820 - work.s1_318*work.alpha_rear_axle_z;
  const double s7_822 = s7_821 - work.s1_314*work.alpha_rear_axle_x - work.s1_295*s7_708;
  const double s7_823 = s7_822 + work.s1_291*s7_710 - work.w_wheel_rear_right_z*s7_754;
  const double s7_824 = s7_823 + work.w_wheel_rear_right_x*s7_760;
  const double s7_825 = s7_824 - work.r_wheel_rear_right_z*s7_749;
  const double s7_826 = s7_825 + work.r_wheel_rear_right_x*s7_751;
  const double s7_827 = s7_826 - work.w_wheel_rear_left_z*s7_728;
  const double s7_828 = s7_827 + work.w_wheel_rear_left_x*s7_734;
  const double s7_829 = s7_828 - work.r_wheel_rear_left_z*s7_723;
  const double s7_830 = s7_829 + work.r_wheel_rear_left_x*s7_725 - work.s1_329*s7_792;
  const double s7_831 = s7_830 - work.s1_332*s7_791 - work.s1_336*s7_793;
  const double s7_832 = work.s1_426*work.s7_558 - work.s1_424*work.s7_559;
  const double s7_833 = s7_832 + work.s1_434*work.s7_569 - work.s1_432*work.s7_570;
  const double s7_834 = s7_833 + work.s1_445*work.s7_579 - work.s1_444*work.s7_581;
  const double s7_835 = s7_834 + work.s1_452*work.s7_583 - work.s1_451*work.s7_584;
  const double s7_836 = s7_835 + work.s1_455*work.s7_586 - work.s1_454*work.s7_587;
  const double s7_837 = s7_836 + work.s1_458*work.s7_595 - work.s1_457*work.s7_597;
  const double s7_838 = s7_837 - work.w_rear_axle_x*s7_714 + work.w_rear_axle_y*s7_712;
  const double s7_839 = s7_838 - work.s1_318*work.alpha_rear_axle_y;
  const double s7_840 = s7_839 - work.s1_312*work.alpha_rear_axle_z;
  const double s7_841 = s7_840 - work.s1_316*work.alpha_rear_axle_x - work.s1_291*s7_709;
  const double s7_842 = s7_841 + work.s1_293*s7_708 - work.w_wheel_rear_right_x*s7_757;
  const double s7_843 = s7_842 + work.w_wheel_rear_right_y*s7_754;
  const double s7_844 = s7_843 - work.r_wheel_rear_right_x*s7_750;
  const double s7_845 = s7_844 + work.r_wheel_rear_right_y*s7_749;
  const double s7_846 = s7_845 - work.w_wheel_rear_left_x*s7_731;
  const double s7_847 = s7_846 + work.w_wheel_rear_left_y*s7_728;
  const double s7_848 = s7_847 - work.r_wheel_rear_left_x*s7_724;
  const double s7_849 = s7_848 + work.r_wheel_rear_left_y*s7_723 - work.s1_330*s7_793;
  const double s7_850 = s7_849 - work.s1_334*s7_791 - work.s1_336*s7_792;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_851 = tau[Coordinate::rear_axle_rx] + work.R_rear_axle_aux5_y_x*s7_831;
  const double s7_852 = s7_851 + work.R_rear_axle_aux5_x_x*s7_812 - work.sines[18]*s7_850;
  const double s7_853 = s7_852 + work.s1_56*s7_786 - work.b_rear_axle_rx_z*s7_790;
  result.missing[19] = s7_853 - work.b_rear_axle_rx_y*s7_788;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double s7_854 = tau[Coordinate::rear_axle_ry] + work.cosines[17]*s7_831;
  const double s7_855 = s7_854 - work.sines[17]*s7_812 + work.s1_52*s7_788 + work.s1_51*s7_786;
  work.Q_rear_axle_ry = s7_855 - work.b_rear_axle_ry_z*s7_790;
  result.missing[18] = work.Q_rear_axle_ry;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double s7_856 = tau[Coordinate::rear_axle_rz] + s7_850 + work.r_rear_axle_aux1_x*s7_788;
  work.Q_rear_axle_rz = s7_856 - state.z[Coordinate::rear_axle_ty]*s7_786;
  result.missing[17] = work.Q_rear_axle_rz;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  result.missing[16] = tau[Coordinate::rear_axle_tz] - s7_790;
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  work.Q_rear_axle_ty = tau[Coordinate::rear_axle_ty] - s7_788;
  result.missing[15] = work.Q_rear_axle_ty;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.Q_rear_axle_tx = tau[Coordinate::rear_axle_tx] - s7_786;
  result.missing[14] = work.Q_rear_axle_tx;
  // bell_crank: bell_crank, revolute, chassis
  const double s7_857 = tau[Coordinate::bell_crank] + work.s1_383*work.s7_529;
  const double s7_858 = s7_857 - work.s1_384*work.s7_530 + work.s1_402*work.s7_533;
  const double s7_859 = s7_858 - work.s1_403*work.s7_534 - work.s1_414*work.s7_544;
  const double s7_860 = work.s1_288*work.w_chassis_y + work.s1_289*work.w_chassis_x;
  const double s7_861 = work.s1_289*work.w_chassis_y + work.s1_287*work.w_chassis_x;
  const double s7_862 = s7_859 - work.s1_415*work.s7_546 - work.w_chassis_x*s7_860;
  const double s7_863 = 0.40412866666666675*work.alpha_bell_crank_z;
  const double s7_864 = s7_862 + work.w_chassis_y*s7_861 - s7_863 - work.s1_281*s7_704;
  const double s7_865 = 3.25*(work.s7_534 + (work.s7_530 + (work.s7_546 + s7_704)));
  result.missing[13] = s7_864 + work.s1_279*(16.666666666666668*s7_702) + s7_865;
  // pitman_arm: pitman_arm, revolute, chassis
  const double s7_866 = tau[Coordinate::pitman_arm] + work.s1_385*work.s7_526;
  const double s7_867 = work.s1_277*work.w_chassis_z + work.s1_275*work.w_chassis_x;
  const double s7_868 = work.s1_276*work.w_chassis_z + work.s1_277*work.w_chassis_x;
  const double s7_869 = s7_866 + work.s1_386*work.s7_525 - work.w_chassis_z*s7_867;
  const double s7_870 = s7_869 + work.w_chassis_x*s7_868 - 0.0842*work.alpha_pitman_arm_y;
  const double s7_871 = s7_870 + work.s1_270*s7_701 + work.s1_271*s7_700;
  work.Q_pitman_arm = s7_871 - 4.4*(work.s7_526 + s7_701) - 0.4*(work.s7_525 + s7_700);
  result.missing[12] = work.Q_pitman_arm;
  // arb_front_right: arb_front_right, revolute, chassis
  const double s7_872 = tau[Coordinate::arb_front_right] + work.s1_380*work.s7_516;
  const double s7_873 = work.w_chassis_z*(s7_697 + work.s1_267*work.w_chassis_x);
  const double s7_874 = work.w_chassis_x*(s7_698 + work.s1_269*work.w_chassis_x);
  const double s7_875 = s7_872 - work.s1_382*work.s7_514 - s7_873 + s7_874;
  const double s7_876 = s7_875 - 0.1304*work.alpha_arb_front_right_y;
  const double s7_877 = s7_876 - work.s1_263*work.alpha_arb_front_right_z;
  const double s7_878 = s7_877 - work.s1_259*work.alpha_arb_front_right_x - work.s1_256*s7_694;
  const double s7_879 = s7_878 + work.s1_254*s7_696 - 3.95*(work.s7_516 + s7_696);
  work.Q_arb_front_right = s7_879 - 0.5*(work.s7_514 + s7_694);
  result.missing[11] = work.Q_arb_front_right;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double s7_880 = work.s1_252*work.w_chassis_y + work.s1_251*work.w_chassis_z;
  const double s7_881 = work.s1_250*work.w_chassis_y + work.s1_252*work.w_chassis_z;
  const double s7_882 = tau[Coordinate::upper_arm_right] - work.w_chassis_y*s7_880;
  const double s7_883 = s7_882 + work.w_chassis_z*s7_881 - 0.2*work.alpha_upper_arm_right_x;
  const double s7_884 = 15.0*(s7_690 + work.s1_246*work.s7_289 + 3.6*work.s7_285);
  const double s7_885 = s7_883 + 15.0*(s7_689 - work.s1_244*work.s7_286)*(0.28 - work.s1_246);
  work.Q_upper_arm_right = s7_885 - s7_884*(0.5 + work.s1_244);
  result.missing[10] = work.Q_upper_arm_right;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s7_886 = work.s7_548 + (work.s7_519 + (work.s7_662 + s7_677));
  const double s7_887 = work.s7_550 + (work.s7_521 + (work.s7_663 + s7_678));
  const double s7_888 = work.s7_551 + (work.s7_522 + (work.s7_664 + s7_679));
  const double s7_889 = work.s1_378*work.s7_521 - work.s1_375*work.s7_522;
  const double s7_890 = s7_889 + work.s1_413*work.s7_550 - work.s1_410*work.s7_551;
  const double s7_891 = s7_890 - work.w_carrier_right_y*work.s7_670;
  const double s7_892 = s7_891 + work.w_carrier_right_z*work.s7_668;
  const double s7_893 = s7_892 - work.s1_219*work.alpha_carrier_right_y;
  const double s7_894 = s7_893 - work.s1_221*work.alpha_carrier_right_z;
  const double s7_895 = s7_894 - work.s1_213*work.alpha_carrier_right_x;
  const double s7_896 = s7_895 - work.s1_183*work.s7_664 + work.s1_186*work.s7_663;
  const double s7_897 = s7_896 - work.w_wheel_front_right_y*s7_688;
  const double s7_898 = s7_897 + work.w_wheel_front_right_z*s7_685;
  const double s7_899 = s7_898 - work.s1_238*work.alpha_wheel_front_right_y;
  const double s7_900 = s7_899 - work.s1_240*work.alpha_wheel_front_right_z;
  const double s7_901 = s7_900 - work.s1_232*work.alpha_wheel_front_right_x;
  const double s7_902 = s7_901 - work.r_wheel_front_right_y*s7_679;
  const double s7_903 = s7_902 + work.r_wheel_front_right_z*s7_678;
  const double s7_904 = work.s1_371*work.s7_522 - work.s1_378*work.s7_519;
  const double s7_905 = s7_904 + work.s1_406*work.s7_551 - work.s1_413*work.s7_548;
  const double s7_906 = s7_905 - work.w_carrier_right_z*work.s7_666;
  const double s7_907 = s7_906 + work.w_carrier_right_x*work.s7_670;
  const double s7_908 = s7_907 - work.s1_215*work.alpha_carrier_right_y;
  const double s7_909 = s7_908 - work.s1_223*work.alpha_carrier_right_z;
  const double s7_910 = s7_909 - work.s1_219*work.alpha_carrier_right_x;
  const double s7_911 = s7_910 - work.s1_186*work.s7_662 + work.s1_179*work.s7_664;
  const double s7_912 = s7_911 - work.w_wheel_front_right_z*s7_682;
  const double s7_913 = s7_912 + work.w_wheel_front_right_x*s7_688;
  const double s7_914 = s7_913 - work.s1_234*work.alpha_wheel_front_right_y;
  const double s7_915 = s7_914 - work.s1_242*work.alpha_wheel_front_right_z;
  const double s7_916 = s7_915 - work.s1_238*work.alpha_wheel_front_right_x;
  const double s7_917 = s7_916 - work.r_wheel_front_right_z*s7_677;
  const double s7_918 = s7_917 + work.r_wheel_front_right_x*s7_679;
  const double s7_919 = work.s1_375*work.s7_519 - work.s1_371*work.s7_521;
  const double s7_920 = s7_919 + work.s1_410*work.s7_548 - work.s1_406*work.s7_550;
  const double s7_921 = s7_920 - work.w_carrier_right_x*work.s7_668;
  const double s7_922 = s7_921 + work.w_carrier_right_y*work.s7_666;
  const double s7_923 = s7_922 - work.s1_223*work.alpha_carrier_right_y;
  const double s7_924 = s7_923 - work.s1_217*work.alpha_carrier_right_z;
  const double s7_925 = s7_924 - work.s1_221*work.alpha_carrier_right_x;
  const double s7_926 = s7_925 - work.s1_179*work.s7_663 + work.s1_183*work.s7_662;
  const double s7_927 = s7_926 - work.w_wheel_front_right_x*s7_685;
  const double s7_928 = s7_927 + work.w_wheel_front_right_y*s7_682;
  const double s7_929 = s7_928 - work.s1_242*work.alpha_wheel_front_right_y;
  const double s7_930 = s7_929 - work.s1_236*work.alpha_wheel_front_right_z;
  const double s7_931 = s7_930 - work.s1_240*work.alpha_wheel_front_right_x;
  const double s7_932 = s7_931 - work.r_wheel_front_right_x*s7_678;
  const double s7_933 = s7_932 + work.r_wheel_front_right_y*s7_677;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_934 = tau[Coordinate::carrier_right_ry] + work.R_carrier_right_aux2_y_y*s7_918;
  const double s7_935 = s7_934 + work.R_carrier_right_aux2_z_y*s7_933 - work.s1_36*s7_903;
  const double s7_936 = s7_935 - work.b_carrier_right_ry_y*s7_887;
  const double s7_937 = s7_936 - work.b_carrier_right_ry_z*s7_888;
  work.Q_carrier_right_ry = s7_937 - work.b_carrier_right_ry_x*s7_886;
  result.missing[9] = work.Q_carrier_right_ry;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s7_938 = tau[Coordinate::carrier_right_rx] + work.R_carrier_right_aux1_y_x*s7_918;
  const double s7_939 = s7_938 + work.R_carrier_right_aux1_z_x*s7_933 + work.cosines[10]*s7_903;
  const double s7_940 = s7_939 + work.s1_40*s7_887 - work.b_carrier_right_rx_z*s7_888;
  work.Q_carrier_right_rx = s7_940 - work.b_carrier_right_rx_x*s7_886;
  result.missing[8] = work.Q_carrier_right_rx;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s7_941 = tau[Coordinate::carrier_right_rz] + work.cosines[9]*s7_933;
  const double s7_942 = s7_941 - work.sines[9]*s7_918 + work.s1_33*s7_887 + work.s1_34*s7_888;
  work.Q_carrier_right_rz = s7_942 - work.b_carrier_right_rz_x*s7_886;
  result.missing[7] = work.Q_carrier_right_rz;
  const double s7_943 = work.s7_655 + s7_887;
  const double s7_944 = work.s7_656 + s7_888;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double s7_945 = tau[Coordinate::lower_arm_right] + s7_903 - work.w_chassis_y*work.s7_658;
  const double s7_946 = s7_945 + work.w_chassis_z*work.s7_657 - 0.6*work.alpha_lower_arm_right_x;
  const double s7_947 = s7_946 - work.s1_170*work.s7_655 - work.s1_168*work.s7_656 + 0.62*s7_943;
  result.missing[6] = s7_947 - 0.4*s7_944;
  // arb_front_left: arb_front_left, revolute, chassis
  const double s7_948 = tau[Coordinate::arb_front_left] + work.s1_367*work.s7_503;
  const double s7_949 = s7_948 - work.s1_369*work.s7_502 - work.w_chassis_z*work.s7_648;
  const double s7_950 = s7_949 + work.w_chassis_x*work.s7_650;
  const double s7_951 = s7_950 - 0.1304*work.alpha_arb_front_left_y;
  const double s7_952 = s7_951 - work.s1_156*work.alpha_arb_front_left_x;
  const double s7_953 = s7_952 + work.s1_160*work.alpha_arb_front_left_z;
  const double s7_954 = s7_953 - work.s1_153*work.s7_644 + work.s1_151*work.s7_646;
  work.Q_arb_front_left = s7_954 - 3.95*work.s7_652 - 0.5*work.s7_651;
  result.missing[5] = work.Q_arb_front_left;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double s7_955 = tau[Coordinate::upper_arm_left] - work.w_chassis_y*work.s7_640;
  const double s7_956 = s7_955 + work.w_chassis_z*work.s7_639 - 0.2*work.alpha_upper_arm_left_x;
  const double s7_957 = s7_956 + work.s7_637*(0.28 + work.s1_143);
  work.Q_upper_arm_left = s7_957 + work.s7_638*(0.5 - work.s1_141);
  result.missing[4] = work.Q_upper_arm_left;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s7_958 = work.s7_537 + (work.s7_508 + (work.s7_608 + work.s7_623));
  const double s7_959 = work.s7_539 + (work.s7_509 + (work.s7_609 + work.s7_624));
  const double s7_960 = work.s7_540 + (work.s7_510 + (work.s7_610 + work.s7_625));
  const double s7_961 = work.s1_365*work.s7_509 - work.s1_362*work.s7_510;
  const double s7_962 = s7_961 + work.s1_397*work.s7_539 - work.s1_393*work.s7_540;
  const double s7_963 = s7_962 - work.w_carrier_left_y*work.s7_616;
  const double s7_964 = s7_963 + work.w_carrier_left_z*work.s7_614;
  const double s7_965 = s7_964 - work.s1_116*work.alpha_carrier_left_y;
  const double s7_966 = s7_965 - work.s1_118*work.alpha_carrier_left_z;
  const double s7_967 = s7_966 - work.s1_110*work.alpha_carrier_left_x - work.s1_78*work.s7_610;
  const double s7_968 = s7_967 + work.s1_82*work.s7_609 - work.w_wheel_front_left_y*work.s7_634;
  const double s7_969 = s7_968 + work.w_wheel_front_left_z*work.s7_631;
  const double s7_970 = s7_969 - work.s1_135*work.alpha_wheel_front_left_y;
  const double s7_971 = s7_970 - work.s1_137*work.alpha_wheel_front_left_z;
  const double s7_972 = s7_971 - work.s1_129*work.alpha_wheel_front_left_x;
  const double s7_973 = s7_972 - work.r_wheel_front_left_y*work.s7_625;
  const double s7_974 = s7_973 + work.r_wheel_front_left_z*work.s7_624;
  const double s7_975 = work.s1_359*work.s7_510 - work.s1_365*work.s7_508;
  const double s7_976 = s7_975 + work.s1_389*work.s7_540 - work.s1_397*work.s7_537;
  const double s7_977 = s7_976 - work.w_carrier_left_z*work.s7_612;
  const double s7_978 = s7_977 + work.w_carrier_left_x*work.s7_616;
  const double s7_979 = s7_978 - work.s1_112*work.alpha_carrier_left_y;
  const double s7_980 = s7_979 - work.s1_120*work.alpha_carrier_left_z;
  const double s7_981 = s7_980 - work.s1_116*work.alpha_carrier_left_x - work.s1_82*work.s7_608;
  const double s7_982 = s7_981 + work.s1_74*work.s7_610 - work.w_wheel_front_left_z*work.s7_628;
  const double s7_983 = s7_982 + work.w_wheel_front_left_x*work.s7_634;
  const double s7_984 = s7_983 - work.s1_131*work.alpha_wheel_front_left_y;
  const double s7_985 = s7_984 - work.s1_139*work.alpha_wheel_front_left_z;
  const double s7_986 = s7_985 - work.s1_135*work.alpha_wheel_front_left_x;
  const double s7_987 = s7_986 - work.r_wheel_front_left_z*work.s7_623;
  const double s7_988 = s7_987 + work.r_wheel_front_left_x*work.s7_625;
  const double s7_989 = work.s1_362*work.s7_508 - work.s1_359*work.s7_509;
  const double s7_990 = s7_989 + work.s1_393*work.s7_537 - work.s1_389*work.s7_539;
  const double s7_991 = s7_990 - work.w_carrier_left_x*work.s7_614;
  const double s7_992 = s7_991 + work.w_carrier_left_y*work.s7_612;
  const double s7_993 = s7_992 - work.s1_120*work.alpha_carrier_left_y;
  const double s7_994 = s7_993 - work.s1_114*work.alpha_carrier_left_z;
  const double s7_995 = s7_994 - work.s1_118*work.alpha_carrier_left_x - work.s1_74*work.s7_609;
  const double s7_996 = s7_995 + work.s1_78*work.s7_608 - work.w_wheel_front_left_x*work.s7_631;
  const double s7_997 = s7_996 + work.w_wheel_front_left_y*work.s7_628;
  const double s7_998 = s7_997 - work.s1_139*work.alpha_wheel_front_left_y;
  const double s7_999 = s7_998 - work.s1_133*work.alpha_wheel_front_left_z;
  const double s7_1000 = s7_999 - work.s1_137*work.alpha_wheel_front_left_x;
  const double s7_1001 = s7_1000 - work.r_wheel_front_left_x*work.s7_624;
  const double s7_1002 = s7_1001 + work.r_wheel_front_left_y*work.s7_623;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_1003 = tau[Coordinate::carrier_left_ry] + work.R_carrier_left_aux2_y_y*s7_988;
  const double s7_1004 = s7_1003 + work.R_carrier_left_aux2_z_y*s7_1002 - work.s1_13*s7_974;
  const double s7_1005 = s7_1004 + work.s1_22*s7_959 - work.b_carrier_left_ry_z*s7_960;
  work.Q_carrier_left_ry = s7_1005 - work.b_carrier_left_ry_x*s7_958;
  result.missing[3] = work.Q_carrier_left_ry;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s7_1006 = tau[Coordinate::carrier_left_rx] + work.R_carrier_left_aux1_y_x*s7_988;
  const double s7_1007 = s7_1006 + work.R_carrier_left_aux1_z_x*s7_1002 + work.cosines[4]*s7_974;
  const double s7_1008 = s7_1007 - work.b_carrier_left_rx_y*s7_959;
  const double s7_1009 = s7_1008 - work.b_carrier_left_rx_z*s7_960;
  work.Q_carrier_left_rx = s7_1009 - work.b_carrier_left_rx_x*s7_958;
  result.missing[2] = work.Q_carrier_left_rx;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s7_1010 = tau[Coordinate::carrier_left_rz] + work.cosines[3]*s7_1002;
  const double s7_1011 = s7_1010 - work.sines[3]*s7_988 + work.s1_10*s7_959 + work.s1_11*s7_960;
  work.Q_carrier_left_rz = s7_1011 - work.b_carrier_left_rz_x*s7_958;
  result.missing[1] = work.Q_carrier_left_rz;
  const double s7_1012 = work.s7_601 + s7_959;
  const double s7_1013 = work.s7_602 + s7_960;
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s7_1014 = tau[Coordinate::lower_arm_left] + s7_974 - work.w_chassis_y*work.s7_604;
  const double s7_1015 = s7_1014 + work.w_chassis_z*work.s7_603 - 0.6*work.alpha_lower_arm_left_x;
  const double s7_1016 = s7_1015 - work.s1_63*work.s7_602 + work.s1_65*work.s7_601 + 0.62*s7_1012;
  result.missing[0] = s7_1016 + 0.4*s7_1013;
  // operations: 1452 add, 1209 multiply
}

/// Part 5 of compute_multipliers: step 9: independent and all accelerations (63), (62).
[[gnu::noinline]] void compute_multipliers_5(const State& state,
    ConstraintForcesWork& __restrict work, ConstraintForces& __restrict result) noexcept {
  // --- step 9: independent and all accelerations (63), (62) ---
  // upper_ball_left
  const double s9_1 = work.s1_387 + 0.36999999999999994*work.R_carrier_left_x_z;
  const double s9_2 = work.s1_391 + 0.36999999999999994*work.R_carrier_left_y_z;
  const double s9_3 = work.s1_395 + 0.36999999999999994*work.R_carrier_left_z_z;
  const double R_lower_arm_left_z_y = work.sines[3];
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double s9_4 = work.b_carrier_left_rz_x - R_lower_arm_left_z_y*s9_3;
  const double J_upper_ball_left_carrier_left_rz = s9_4 - R_lower_arm_left_y_y*s9_2;
  const double s9_5 = work.b_carrier_left_rx_x + work.R_carrier_left_aux1_y_x*s9_3;
  const double J_upper_ball_left_carrier_left_rx = s9_5 - work.R_carrier_left_aux1_z_x*s9_2;
  const double s9_6 = work.b_carrier_left_ry_x + work.R_carrier_left_aux2_y_y*s9_3;
  const double J_upper_ball_left_carrier_left_ry = s9_6 - work.R_carrier_left_aux2_z_y*s9_2;
  const double J_upper_ball_left_carrier_left_rz_2 = R_lower_arm_left_y_y*s9_1 - work.s1_10;
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double s9_7 = work.b_carrier_left_rx_y + work.R_carrier_left_aux1_z_x*s9_1;
  const double J_upper_ball_left_carrier_left_rx_2 = s9_7 - R_carrier_left_aux1_x_x*s9_3;
  const double J_upper_ball_left_carrier_left_ry_2 = work.R_carrier_left_aux2_z_y*s9_1 - work.s1_22
      + work.s1_13*s9_3;
  const double R_upper_arm_left_z_y = work.sines[7];
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double s9_8 = 0.020000000000000018*R_upper_arm_left_y_y;
  const double J_upper_ball_left_upper_arm_left = 0.30000000000000004*R_upper_arm_left_z_y - s9_8;
  const double J_upper_ball_left_carrier_left_rz_3 = R_lower_arm_left_z_y*s9_1 - work.s1_11;
  const double s9_9 = work.b_carrier_left_rx_z + R_carrier_left_aux1_x_x*s9_2;
  const double J_upper_ball_left_carrier_left_rx_3 = s9_9 - work.R_carrier_left_aux1_y_x*s9_1;
  const double s9_10 = work.b_carrier_left_ry_z - work.R_carrier_left_aux2_y_y*s9_1;
  const double J_upper_ball_left_carrier_left_ry_3 = s9_10 - work.s1_13*s9_2;
  const double s9_11 = 0.020000000000000018*R_upper_arm_left_z_y;
  const double s9_12 = 0.30000000000000004*R_upper_arm_left_y_y + s9_11;
  // upper_ball_right
  const double s9_13 = work.s1_404 + 0.36999999999999994*work.R_carrier_right_x_z;
  const double s9_14 = work.s1_408 + 0.36999999999999994*work.R_carrier_right_y_z;
  const double s9_15 = work.s1_411 + 0.36999999999999994*work.R_carrier_right_z_z;
  const double R_lower_arm_right_z_y = work.sines[9];
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s9_16 = work.b_carrier_right_rz_x - R_lower_arm_right_z_y*s9_15;
  const double J_upper_ball_right_carrier_right_rz = s9_16 - R_lower_arm_right_y_y*s9_14;
  const double s9_17 = work.b_carrier_right_rx_x + work.R_carrier_right_aux1_y_x*s9_15;
  const double J_upper_ball_right_carrier_right_rx = s9_17 - work.R_carrier_right_aux1_z_x*s9_14;
  const double s9_18 = work.b_carrier_right_ry_x + work.R_carrier_right_aux2_y_y*s9_15;
  const double J_upper_ball_right_carrier_right_ry = s9_18 - work.R_carrier_right_aux2_z_y*s9_14;
  const double J_upper_ball_right_carrier_right_rz_2 = R_lower_arm_right_y_y*s9_13 - work.s1_33;
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double s9_19 = work.R_carrier_right_aux1_z_x*s9_13 - work.s1_40;
  const double J_upper_ball_right_carrier_right_rx_2 = s9_19 - R_carrier_right_aux1_x_x*s9_15;
  const double s9_20 = work.b_carrier_right_ry_y + work.R_carrier_right_aux2_z_y*s9_13;
  const double J_upper_ball_right_carrier_right_ry_2 = s9_20 + work.s1_36*s9_15;
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s9_21 = 0.020000000000000018*R_upper_arm_right_y_y;
  const double s9_22 = 0.30000000000000004*R_upper_arm_right_z_y + s9_21;
  const double J_upper_ball_right_carrier_right_rz_3 = R_lower_arm_right_z_y*s9_13 - work.s1_34;
  const double s9_23 = work.b_carrier_right_rx_z + R_carrier_right_aux1_x_x*s9_14;
  const double J_upper_ball_right_carrier_right_rx_3 = s9_23 - work.R_carrier_right_aux1_y_x*s9_13;
  const double s9_24 = work.b_carrier_right_ry_z - work.R_carrier_right_aux2_y_y*s9_13;
  const double J_upper_ball_right_carrier_right_ry_3 = s9_24 - work.s1_36*s9_14;
  const double s9_25 = 0.020000000000000018*R_upper_arm_right_z_y;
  const double s9_26 = s9_25 - 0.30000000000000004*R_upper_arm_right_y_y;
  // arb_link_front_left
  const double s9_27 = 3.846153846153846*(work.s1_367 - work.s1_359);
  const double s9_28 = 3.846153846153846*(0.72 - work.s1_362);
  const double s9_29 = 3.846153846153846*(work.s1_369 - work.s1_365);
  const double s9_30 = work.s1_362*s9_29 - work.s1_365*s9_28;
  const double s9_31 = work.s1_365*s9_27 - work.s1_359*s9_29;
  const double s9_32 = work.s1_359*s9_28 - work.s1_362*s9_27;
  const double s9_33 = R_lower_arm_left_y_y*s9_32 - R_lower_arm_left_z_y*s9_31;
  const double s9_34 = s9_33 + work.b_carrier_left_rz_x*s9_27 - work.s1_11*s9_29;
  const double s9_35 = s9_34 - work.s1_10*s9_28;
  const double s9_36 = work.R_carrier_left_aux1_y_x*s9_31 + work.R_carrier_left_aux1_z_x*s9_32;
  const double s9_37 = s9_36 + R_carrier_left_aux1_x_x*s9_30 + work.b_carrier_left_rx_y*s9_28;
  const double s9_38 = s9_37 + work.b_carrier_left_rx_z*s9_29 + work.b_carrier_left_rx_x*s9_27;
  const double s9_39 = work.R_carrier_left_aux2_y_y*s9_31 + work.R_carrier_left_aux2_z_y*s9_32;
  const double s9_40 = s9_39 - work.s1_13*s9_30 + work.b_carrier_left_ry_z*s9_29;
  const double s9_41 = s9_40 + work.b_carrier_left_ry_x*s9_27 - work.s1_22*s9_28;
  const double J_arb_link_front_left_arb_front_left = s9_27*(0.5 + work.s1_369) + s9_29*(3.95 -
      work.s1_367);
  // arb_link_front_right
  const double s9_42 = 3.846153846153846*(work.s1_380 - work.s1_371);
  const double s9_43 = 3.846153846153846*(0.72 + work.s1_375);
  const double s9_44 = 3.846153846153846*(work.s1_382 - work.s1_378);
  const double s9_45 = work.s1_378*s9_43 + work.s1_375*s9_44;
  const double s9_46 = work.s1_378*s9_42 - work.s1_371*s9_44;
  const double s9_47 = work.s1_375*s9_42 + work.s1_371*s9_43;
  const double s9_48 = work.s1_33*s9_43 + work.b_carrier_right_rz_x*s9_42 - work.s1_34*s9_44;
  const double s9_49 = s9_48 - R_lower_arm_right_z_y*s9_46 - R_lower_arm_right_y_y*s9_47;
  const double s9_50 = work.R_carrier_right_aux1_y_x*s9_46 + R_carrier_right_aux1_x_x*s9_45;
  const double s9_51 = s9_50 - work.R_carrier_right_aux1_z_x*s9_47 + work.s1_40*s9_43;
  const double s9_52 = s9_51 + work.b_carrier_right_rx_z*s9_44;
  const double s9_53 = s9_52 + work.b_carrier_right_rx_x*s9_42;
  const double s9_54 = work.R_carrier_right_aux2_y_y*s9_46;
  const double s9_55 = s9_54 - work.R_carrier_right_aux2_z_y*s9_47 - work.s1_36*s9_45;
  const double s9_56 = s9_55 + work.b_carrier_right_ry_z*s9_44;
  const double s9_57 = s9_56 + work.b_carrier_right_ry_x*s9_42;
  const double s9_58 = s9_57 - work.b_carrier_right_ry_y*s9_43;
  const double J_arb_link_front_right_arb_front_right = s9_42*(0.5 + work.s1_382) + s9_44*(3.95 -
      work.s1_380);
  // drag_link
  const double s9_59 = 0.8565801464479955*(work.s1_385 - work.s1_384)*(0.4 - work.s1_386);
  const double J_drag_link_pitman_arm = s9_59 + 0.8565801464479955*(0.6 - work.s1_386)*(4.4 -
      work.s1_385);
  // tie_rod_left
  const double s9_60 = 1.2625900317976169*(work.s1_403 - work.s1_389);
  const double s9_61 = 1.2625900317976169*(work.s1_402 - work.s1_393);
  const double s9_62 = 1.2625900317976169*(0.6 + work.s1_397);
  const double s9_63 = work.s1_397*s9_61 + work.s1_393*s9_62;
  const double s9_64 = work.s1_389*s9_62 + work.s1_397*s9_60;
  const double s9_65 = work.s1_389*s9_61 - work.s1_393*s9_60;
  const double s9_66 = R_lower_arm_left_y_y*s9_65 - R_lower_arm_left_z_y*s9_64;
  const double s9_67 = s9_66 + work.s1_11*s9_62 + work.b_carrier_left_rz_x*s9_60;
  const double s9_68 = s9_67 - work.s1_10*s9_61;
  const double s9_69 = work.R_carrier_left_aux1_y_x*s9_64 + work.R_carrier_left_aux1_z_x*s9_65;
  const double s9_70 = s9_69 - R_carrier_left_aux1_x_x*s9_63 + work.b_carrier_left_rx_y*s9_61;
  const double s9_71 = s9_70 + work.b_carrier_left_rx_x*s9_60 - work.b_carrier_left_rx_z*s9_62;
  const double s9_72 = work.R_carrier_left_aux2_y_y*s9_64 + work.R_carrier_left_aux2_z_y*s9_65;
  const double s9_73 = s9_72 + work.s1_13*s9_63 + work.b_carrier_left_ry_x*s9_60;
  const double s9_74 = s9_73 - work.b_carrier_left_ry_z*s9_62 - work.s1_22*s9_61;
  // tie_rod_right
  const double s9_75 = 1.2625900317976169*(work.s1_415 - work.s1_406);
  const double s9_76 = 1.2625900317976169*(work.s1_410 + work.s1_414);
  const double s9_77 = 1.2625900317976169*(0.6 + work.s1_413);
  const double s9_78 = work.s1_413*s9_76 - work.s1_410*s9_77;
  const double s9_79 = work.s1_406*s9_77 + work.s1_413*s9_75;
  const double s9_80 = work.s1_410*s9_75 + work.s1_406*s9_76;
  const double s9_81 = work.s1_33*s9_76 + work.s1_34*s9_77 + work.b_carrier_right_rz_x*s9_75;
  const double s9_82 = s9_81 - R_lower_arm_right_z_y*s9_79 - R_lower_arm_right_y_y*s9_80;
  const double s9_83 = work.R_carrier_right_aux1_y_x*s9_79 + R_carrier_right_aux1_x_x*s9_78;
  const double s9_84 = s9_83 - work.R_carrier_right_aux1_z_x*s9_80 + work.s1_40*s9_76;
  const double s9_85 = s9_84 + work.b_carrier_right_rx_x*s9_75;
  const double s9_86 = s9_85 - work.b_carrier_right_rx_z*s9_77;
  const double s9_87 = work.R_carrier_right_aux2_y_y*s9_79;
  const double s9_88 = s9_87 - work.R_carrier_right_aux2_z_y*s9_80 - work.s1_36*s9_78;
  const double s9_89 = s9_88 + work.b_carrier_right_ry_x*s9_75;
  const double s9_90 = s9_89 - work.b_carrier_right_ry_z*s9_77;
  const double s9_91 = s9_90 - work.b_carrier_right_ry_y*s9_76;
  // loop block 0
  const double s9_92 = 4.291271972095581*std::abs(J_arb_link_front_right_arb_front_right);
  const double s9_93 = mbgen::min(4.625980413576839*std::abs(J_drag_link_pitman_arm), s9_92);
  const double s9_94 = 4.336650753223258*std::abs(J_arb_link_front_left_arb_front_left);
  const double s9_95 = 1.0/s9_26;
  const double s9_96 = 1.0/s9_82;
  const double s9_97 = mbgen::min(mbgen::min(s9_93, s9_94), 3.3503257942070226*std::abs(s9_26));
  const double s9_98 = J_upper_ball_right_carrier_right_rz*s9_96;
  const double s9_99 = J_upper_ball_right_carrier_right_rx - s9_86*s9_98;
  const double s9_100 = J_upper_ball_right_carrier_right_ry - s9_91*s9_98;
  const double s9_101 = 1.0/s9_100;
  const double s9_102 = mbgen::min(s9_97, 5.556930741705859*std::abs(s9_82));
  const double s9_103 = s9_22*s9_95;
  const double s9_104 = J_upper_ball_right_carrier_right_rz_3*s9_103;
  const double s9_105 = s9_96*(J_upper_ball_right_carrier_right_rz_2 - s9_104);
  const double s9_106 = J_upper_ball_right_carrier_right_ry_3*s9_103;
  const double s9_107 = s9_101*(J_upper_ball_right_carrier_right_ry_2 - s9_106 - s9_91*s9_105);
  const double s9_108 = J_upper_ball_right_carrier_right_rx_3*s9_103;
  const double s9_109 = J_upper_ball_right_carrier_right_rx_2 - s9_108 - s9_86*s9_105;
  const double s9_110 = s9_109 - s9_99*s9_107;
  const double s9_111 = mbgen::min(s9_102, 2.6620449619787987*std::abs(s9_100));
  const double s9_112 = 1.0/s9_12;
  const double s9_113 = mbgen::min(s9_111, 2.732781487945307*std::abs(s9_110));
  const double s9_114 = 1.0/s9_71;
  const double s9_115 = mbgen::min(s9_113, 3.3514772255331233*std::abs(s9_12));
  const double s9_116 = J_upper_ball_left_upper_arm_left*s9_112;
  const double s9_117 = J_upper_ball_left_carrier_left_rx_3*s9_116;
  const double s9_118 = s9_114*(J_upper_ball_left_carrier_left_rx_2 + s9_117);
  const double s9_119 = J_upper_ball_left_carrier_left_rz_3*s9_116;
  const double s9_120 = J_upper_ball_left_carrier_left_rz_2 + s9_119 - s9_68*s9_118;
  const double s9_121 = J_upper_ball_left_carrier_left_ry_3*s9_116;
  const double s9_122 = J_upper_ball_left_carrier_left_ry_2 + s9_121 - s9_74*s9_118;
  const double s9_123 = 1.0/s9_122;
  const double s9_124 = mbgen::min(s9_115, 15.714736645766752*std::abs(s9_71));
  const double s9_125 = J_upper_ball_left_carrier_left_rx*s9_114;
  const double s9_126 = s9_123*(J_upper_ball_left_carrier_left_ry - s9_74*s9_125);
  const double s9_127 = J_upper_ball_left_carrier_left_rz - s9_68*s9_125 - s9_120*s9_126;
  const double s9_128 = mbgen::min(s9_124, 5.864463449986124*std::abs(s9_122));
  result.pivot[0] = mbgen::min(s9_128, 0.43888841273380513*std::abs(s9_127));
  result.lambda[8] = work.Q_pitman_arm*(1.0/J_drag_link_pitman_arm);
  const double s9_129 = work.Q_arb_front_right*(1.0/J_arb_link_front_right_arb_front_right);
  result.lambda[7] = s9_129;
  const double s9_130 = work.Q_arb_front_left*(1.0/J_arb_link_front_left_arb_front_left);
  result.lambda[6] = s9_130;
  const double s9_131 = work.Q_upper_arm_right*s9_95;
  const double s9_132 = J_upper_ball_right_carrier_right_rz_3*s9_131;
  const double s9_133 = s9_96*(work.Q_carrier_right_rz + s9_49*s9_129 + s9_132);
  const double s9_134 = J_upper_ball_right_carrier_right_ry_3*s9_131;
  const double s9_135 = s9_101*(work.Q_carrier_right_ry + s9_58*s9_129 + s9_134 - s9_91*s9_133);
  const double s9_136 = J_upper_ball_right_carrier_right_rx_3*s9_131;
  const double s9_137 = work.Q_carrier_right_rx + s9_53*s9_129 + s9_136 - s9_86*s9_133;
  const double s9_138 = 1.0/s9_110*(s9_137 - s9_99*s9_135);
  result.lambda[4] = s9_138;
  const double s9_139 = work.Q_upper_arm_left*s9_112;
  const double s9_140 = J_upper_ball_left_carrier_left_rx_3*s9_139;
  const double s9_141 = s9_114*(work.Q_carrier_left_rx + s9_38*s9_130 + s9_140);
  const double s9_142 = J_upper_ball_left_carrier_left_ry_3*s9_139;
  const double s9_143 = s9_123*(work.Q_carrier_left_ry + s9_41*s9_130 + s9_142 - s9_74*s9_141);
  const double s9_144 = J_upper_ball_left_carrier_left_rz_3*s9_139;
  const double s9_145 = work.Q_carrier_left_rz + s9_35*s9_130 + s9_144 - s9_68*s9_141;
  const double s9_146 = 1.0/s9_127*(s9_145 - s9_120*s9_143);
  result.lambda[0] = s9_146;
  const double s9_147 = s9_143 - s9_126*s9_146;
  result.lambda[1] = s9_147;
  result.lambda[9] = s9_118*s9_147 - s9_141 + s9_125*s9_146;
  result.lambda[2] = s9_116*s9_147 - s9_139;
  const double s9_148 = s9_135 - s9_107*s9_138;
  result.lambda[3] = s9_148;
  result.lambda[10] = s9_98*s9_148 - s9_133 + s9_105*s9_138;
  result.lambda[5] = -(s9_131 + s9_103*s9_138);
  // long_rod_left
  const double J_long_rod_left_rear_axle_tx = 1.1757385222540742*(1.6 + work.s1_424);
  const double s9_149 = 1.1757385222540742*(0.55 - work.s1_426);
  const double J_long_rod_left_rear_axle_tz = 1.1757385222540742*(0.55 + work.s1_427);
  const double s9_150 = work.s1_427*s9_149 + work.s1_426*J_long_rod_left_rear_axle_tz;
  const double s9_151 = work.s1_424*J_long_rod_left_rear_axle_tz;
  const double s9_152 = s9_151 - work.s1_427*J_long_rod_left_rear_axle_tx;
  // diag_rod_left
  const double J_diag_rod_left_rear_axle_tx = 1.162476387438193*(1.6999999999999997 + work.s1_432);
  const double s9_153 = 1.162476387438193*(0.4 - work.s1_434);
  const double J_diag_rod_left_rear_axle_tz = 1.162476387438193*(0.15000000000000002 + work.s1_436);
  const double s9_154 = work.s1_436*s9_153 + work.s1_434*J_diag_rod_left_rear_axle_tz;
  const double s9_155 = work.s1_432*J_diag_rod_left_rear_axle_tz;
  const double s9_156 = s9_155 - work.s1_436*J_diag_rod_left_rear_axle_tx;
  // arb_link_rear_left
  const double s9_157 = 4.472135954999581*(work.s1_449 - work.s1_444);
  const double s9_158 = 4.472135954999581*(0.6 - work.s1_445);
  const double J_arb_link_rear_left_rear_axle_tz = 4.472135954999581*(work.s1_448 + work.s1_450);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s9_159 = s9_158*(work.s1_444 - work.r_rear_axle_aux1_x);
  const double s9_160 = s9_157*(z_rear_axle_ty - work.s1_445) + s9_159;
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double s9_161 = work.s1_444*J_arb_link_rear_left_rear_axle_tz + work.s1_448*s9_157;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  const double s9_162 = work.s1_448*s9_158 + work.s1_445*J_arb_link_rear_left_rear_axle_tz;
  const double s9_163 = R_rear_axle_aux4_x_x*s9_161 + R_rear_axle_aux4_y_x*s9_162;
  const double s9_164 = work.b_rear_axle_ry_z*J_arb_link_rear_left_rear_axle_tz;
  const double s9_165 = s9_163 - work.s1_52*s9_158 - s9_164 - work.s1_51*s9_157;
  const double s9_166 = J_arb_link_rear_left_rear_axle_tz*(3.3000000000000003 + work.s1_449);
  const double J_arb_link_rear_left_arb_rear_left = s9_157*(0.44999999999999996 - work.s1_450) +
      s9_166;
  // long_rod_right
  const double J_long_rod_right_rear_axle_tx = 1.1757385222540742*(1.6 + work.s1_451);
  const double J_long_rod_right_rear_axle_ty = 1.1757385222540742*(0.55 + work.s1_452);
  const double J_long_rod_right_rear_axle_tz = 1.1757385222540742*(0.55 + work.s1_453);
  const double s9_167 = work.s1_453*J_long_rod_right_rear_axle_ty;
  const double s9_168 = s9_167 - work.s1_452*J_long_rod_right_rear_axle_tz;
  const double s9_169 = work.s1_451*J_long_rod_right_rear_axle_tz;
  const double s9_170 = s9_169 - work.s1_453*J_long_rod_right_rear_axle_tx;
  // diag_rod_right
  const double J_diag_rod_right_rear_axle_tx = 1.162476387438193*(1.6999999999999997 + work.s1_454);
  const double J_diag_rod_right_rear_axle_ty = 1.162476387438193*(0.4 + work.s1_455);
  const double J_diag_rod_right_rear_axle_tz = 1.162476387438193*(0.15000000000000002 +
      work.s1_456);
  const double s9_171 = work.s1_456*J_diag_rod_right_rear_axle_ty;
  const double s9_172 = work.s1_454*J_diag_rod_right_rear_axle_tz;
  const double s9_173 = J_diag_rod_right_rear_axle_ty*(work.r_rear_axle_aux1_x - work.s1_454);
  const double s9_174 = J_diag_rod_right_rear_axle_tx*(work.s1_455 - z_rear_axle_ty) + s9_173;
  const double s9_175 = s9_172 - work.s1_456*J_diag_rod_right_rear_axle_tx;
  const double s9_176 = s9_171 - work.s1_455*J_diag_rod_right_rear_axle_tz;
  const double s9_177 = R_rear_axle_aux4_x_x*s9_175 - R_rear_axle_aux4_y_x*s9_176;
  const double s9_178 = s9_177 + work.s1_52*J_diag_rod_right_rear_axle_ty;
  const double s9_179 = work.b_rear_axle_ry_z*J_diag_rod_right_rear_axle_tz;
  const double s9_180 = s9_178 + work.s1_51*J_diag_rod_right_rear_axle_tx - s9_179;
  // arb_link_rear_right
  const double s9_181 = 4.472135954999581*(work.s1_460 - work.s1_457);
  const double J_arb_link_rear_right_rear_axle_ty = 4.472135954999581*(0.6 + work.s1_458);
  const double J_arb_link_rear_right_rear_axle_tz = 4.472135954999581*(work.s1_459 + work.s1_461);
  const double s9_182 = work.s1_459*J_arb_link_rear_right_rear_axle_ty;
  const double s9_183 = work.r_rear_axle_aux1_x - work.s1_457;
  const double s9_184 = J_arb_link_rear_right_rear_axle_ty*s9_183;
  const double s9_185 = s9_181*(z_rear_axle_ty - work.s1_458) + s9_184;
  const double s9_186 = work.s1_457*J_arb_link_rear_right_rear_axle_tz + work.s1_459*s9_181;
  const double s9_187 = s9_182 - work.s1_458*J_arb_link_rear_right_rear_axle_tz;
  const double s9_188 = R_rear_axle_aux4_x_x*s9_186 - R_rear_axle_aux4_y_x*s9_187;
  const double s9_189 = work.b_rear_axle_ry_z*J_arb_link_rear_right_rear_axle_tz;
  const double s9_190 = s9_188 + work.s1_52*J_arb_link_rear_right_rear_axle_ty - s9_189;
  const double s9_191 = s9_190 - work.s1_51*s9_181;
  const double s9_192 = J_arb_link_rear_right_rear_axle_tz*(3.3000000000000003 + work.s1_460);
  const double J_arb_link_rear_right_arb_rear_right = s9_181*(0.44999999999999996 - work.s1_461) +
      s9_192;
  // loop block 1
  const double s9_193 = 3.204642123170383*std::abs(J_arb_link_rear_right_arb_rear_right);
  const double s9_194 = 3.194382824999693*std::abs(J_arb_link_rear_left_arb_rear_left);
  const double s9_195 = 1.0/J_diag_rod_right_rear_axle_tx;
  const double s9_196 = 1.0748203921841*std::abs(J_diag_rod_right_rear_axle_tx);
  const double s9_197 = J_long_rod_left_rear_axle_tx*s9_195;
  const double s9_198 = s9_149 + J_diag_rod_right_rear_axle_ty*s9_197;
  const double s9_199 = J_long_rod_left_rear_axle_tx*(z_rear_axle_ty - work.s1_426);
  const double s9_200 = s9_174*s9_197 + s9_199 + s9_149*(work.r_rear_axle_aux1_x - work.s1_424);
  const double s9_201 = s9_180*s9_197 - R_rear_axle_aux4_x_x*s9_152;
  const double s9_202 = work.s1_51*J_long_rod_left_rear_axle_tx;
  const double s9_203 = work.b_rear_axle_ry_z*J_long_rod_left_rear_axle_tz;
  const double s9_204 = s9_201 - R_rear_axle_aux4_y_x*s9_150 - s9_202 + s9_203;
  const double s9_205 = s9_204 + work.s1_52*s9_149;
  const double s9_206 = 1.0/s9_200;
  const double s9_207 = mbgen::min(mbgen::min(s9_193, s9_194), s9_196);
  const double s9_208 = J_long_rod_right_rear_axle_tx*s9_195;
  const double s9_209 = J_long_rod_right_rear_axle_tx*(z_rear_axle_ty - work.s1_452);
  const double s9_210 = J_long_rod_right_rear_axle_ty*(work.s1_451 - work.r_rear_axle_aux1_x);
  const double s9_211 = s9_206*(s9_174*s9_208 + s9_209 + s9_210);
  const double s9_212 = J_long_rod_right_rear_axle_ty - J_diag_rod_right_rear_axle_ty*s9_208;
  const double s9_213 = s9_212 + s9_198*s9_211;
  const double s9_214 = s9_180*s9_208 - R_rear_axle_aux4_x_x*s9_170;
  const double s9_215 = work.s1_52*J_long_rod_right_rear_axle_ty;
  const double s9_216 = s9_214 + R_rear_axle_aux4_y_x*s9_168 - s9_215;
  const double s9_217 = work.b_rear_axle_ry_z*J_long_rod_right_rear_axle_tz;
  const double s9_218 = s9_216 - work.s1_51*J_long_rod_right_rear_axle_tx + s9_217;
  const double s9_219 = s9_218 - s9_205*s9_211;
  const double s9_220 = 1.0/s9_219;
  const double s9_221 = mbgen::min(s9_207, 1.5318884572025857*std::abs(s9_200));
  const double s9_222 = J_diag_rod_left_rear_axle_tx*s9_195;
  const double s9_223 = J_diag_rod_left_rear_axle_tx*(z_rear_axle_ty - work.s1_434);
  const double s9_224 = s9_174*s9_222 + s9_223 + s9_153*(work.r_rear_axle_aux1_x - work.s1_432);
  const double s9_225 = s9_206*s9_224;
  const double s9_226 = s9_180*s9_222 - R_rear_axle_aux4_x_x*s9_156;
  const double s9_227 = work.s1_51*J_diag_rod_left_rear_axle_tx;
  const double s9_228 = work.b_rear_axle_ry_z*J_diag_rod_left_rear_axle_tz;
  const double s9_229 = s9_226 - R_rear_axle_aux4_y_x*s9_154 - s9_227 + s9_228;
  const double s9_230 = s9_220*(s9_229 + work.s1_52*s9_153 - s9_205*s9_225);
  const double s9_231 = s9_198*s9_225 - s9_153 - J_diag_rod_right_rear_axle_ty*s9_222;
  const double s9_232 = s9_231 - s9_213*s9_230;
  const double s9_233 = mbgen::min(s9_221, 1.7893247478820993*std::abs(s9_219));
  result.pivot[1] = mbgen::min(s9_233, 1.4337752588788297*std::abs(s9_232));
  const double s9_234 = work.Q_arb_rear_right*(1.0/J_arb_link_rear_right_arb_rear_right);
  result.lambda[16] = s9_234;
  const double s9_235 = work.Q_arb_rear_left*(1.0/J_arb_link_rear_left_arb_rear_left);
  result.lambda[13] = s9_235;
  const double s9_236 = s9_195*(work.Q_rear_axle_tx + s9_181*s9_234 + s9_157*s9_235);
  const double s9_237 = work.Q_rear_axle_rz + s9_185*s9_234 + s9_160*s9_235 + s9_174*s9_236;
  const double s9_238 = s9_206*s9_237;
  const double s9_239 = work.Q_rear_axle_ry + s9_191*s9_234 + s9_165*s9_235 + s9_180*s9_236;
  const double s9_240 = s9_220*(s9_239 - s9_205*s9_238);
  const double s9_241 = work.Q_rear_axle_ty - J_arb_link_rear_right_rear_axle_ty*s9_234;
  const double s9_242 = s9_241 + s9_158*s9_235 - J_diag_rod_right_rear_axle_ty*s9_236;
  const double s9_243 = 1.0/s9_232*(s9_242 + s9_198*s9_238 - s9_213*s9_240);
  result.lambda[12] = s9_243;
  const double s9_244 = s9_240 - s9_230*s9_243;
  result.lambda[14] = s9_244;
  const double s9_245 = s9_238 - s9_211*s9_244 - s9_225*s9_243;
  result.lambda[11] = s9_245;
  result.lambda[15] = s9_236 - s9_197*s9_245 - s9_208*s9_244 - s9_222*s9_243;
  // operations: 287 add, 370 multiply, 17 divide, 32 other
}

/// Multipliers of the closures and generalised driving forces, at given accelerations.
void compute_multipliers(const Parameters& /*parameters*/, const Inputs& /*inputs*/,
    const State& state, const double* tau, const Derivative& derivative,
    ConstraintForces& __restrict result) noexcept {
  ConstraintForcesWork work;
  compute_multipliers_1(state, work);
  compute_multipliers_2(state, derivative, work);
  compute_multipliers_3(state, derivative, work);
  compute_multipliers_4(state, tau, work, result);
  compute_multipliers_5(state, work, result);
}

/// Result of compute_closure_terms.
struct ClosureTerms {
  double Phi[17];  ///< residuals
  double Jz[202];  ///< Jacobian of each block, row by row
  double ct[17];  ///< right-hand side of the velocities
  double c[17];  ///< right-hand side of the accelerations
  double driven_position[32];  ///< of driven coordinates, by their motions
  double driven_velocity[32];  ///< of driven coordinates
  double driven_acceleration[32];  ///< of driven coordinates
};

/// Values of compute_closure_terms that cross its parts.
struct ClosureTermsWork {
  double
      sines[19], cosines[19], R_carrier_left_aux1_y_x, R_carrier_left_aux1_z_x, s1_5, s1_8,
      R_carrier_left_aux2_y_y, R_carrier_left_aux2_z_y, b_carrier_left_rx_x, b_carrier_left_rx_y,
      b_carrier_left_rx_z, b_carrier_left_ry_x, s1_17, b_carrier_left_ry_z,
      R_carrier_right_aux1_y_x, R_carrier_right_aux1_z_x, b_carrier_right_rz_x, s1_23, s1_24, s1_26,
      R_carrier_right_aux2_y_y, R_carrier_right_aux2_z_y, b_carrier_right_rx_x, s1_30,
      b_carrier_right_rx_z, R_carrier_right_x_x, R_carrier_right_y_x, R_carrier_right_z_x,
      R_carrier_right_x_z, R_carrier_right_y_z, R_carrier_right_z_z, b_carrier_right_ry_x,
      b_carrier_right_ry_y, b_carrier_right_ry_z, r_rear_axle_aux1_x, r_rear_axle_aux3_z,
      R_rear_axle_aux5_x_x, R_rear_axle_aux5_y_x, s1_36, s1_37, b_rear_axle_ry_z, R_rear_axle_x_y,
      R_rear_axle_y_y, R_rear_axle_z_y, R_rear_axle_x_z, R_rear_axle_y_z, R_rear_axle_z_z, s1_41,
      b_rear_axle_rx_y, b_rear_axle_rx_z, s2_73, s2_75, s2_78, s2_79, s2_80, s2_81, s2_91, s2_92,
      s2_93, s2_94, s2_95, s2_96, s2_97, s2_98, s2_99, s2_100, s2_102, s2_104, s2_108, s2_109,
      s2_110, s2_129, s2_132, s2_134, s2_252, s2_253, s2_254, s2_255, s2_256, s2_257, s2_261,
      s2_262, s2_263, s2_269, s2_270, s2_271, s2_272, s2_274, s2_276, s2_277, s2_279;
};

/// Part 1 of compute_closure_terms: step 1: poses, axes b, accumulated inertias MR (50); step 2:
/// closure Jacobian Phi_z and its factors (60).
[[gnu::noinline]] void compute_closure_terms_1(const State& state,
    ClosureTermsWork& __restrict work, ClosureTerms& __restrict result) noexcept {
  // --- step 1: poses, axes b, accumulated inertias MR (50) ---
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
  const double R_lower_arm_left_z_y = work.sines[0];
  const double s1_1 = 0.4 + 0.44999999999999996*R_lower_arm_left_y_y;
  const double r_carrier_left_aux1_y = s1_1 + 0.04999999999999999*R_lower_arm_left_z_y;
  const double s1_2 = 0.44999999999999996*R_lower_arm_left_z_y - 0.62;
  const double r_carrier_left_aux1_z = s1_2 - 0.04999999999999999*R_lower_arm_left_y_y;
  const double s1_3 = work.sines[1];
  work.R_carrier_left_aux1_y_x = R_lower_arm_left_y_y*s1_3;
  work.R_carrier_left_aux1_z_x = R_lower_arm_left_z_y*s1_3;
  const double R_carrier_left_aux1_x_x = work.cosines[1];
  const double R_carrier_left_aux1_y_y = R_lower_arm_left_y_y*R_carrier_left_aux1_x_x;
  const double R_carrier_left_aux1_z_y = R_lower_arm_left_z_y*R_carrier_left_aux1_x_x;
  const double s1_4 = R_lower_arm_left_z_y*r_carrier_left_aux1_z;
  const double b_carrier_left_rz_x = s1_4 + R_lower_arm_left_y_y*r_carrier_left_aux1_y;
  work.s1_5 = 3.6*R_lower_arm_left_y_y;
  const double s1_6 = 3.6*R_lower_arm_left_z_y;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_7 = work.cosines[2];
  work.s1_8 = s1_3*s1_7;
  const double s1_9 = work.sines[2];
  work.R_carrier_left_aux2_y_y = R_carrier_left_aux1_y_y*s1_7 - R_lower_arm_left_z_y*s1_9;
  work.R_carrier_left_aux2_z_y = R_carrier_left_aux1_z_y*s1_7 + R_lower_arm_left_y_y*s1_9;
  const double R_carrier_left_aux2_x_z = s1_3*s1_9;
  const double s1_10 = R_carrier_left_aux1_y_y*s1_9 + R_lower_arm_left_z_y*s1_7;
  const double R_carrier_left_aux2_z_z = R_lower_arm_left_y_y*s1_7 - R_carrier_left_aux1_z_y*s1_9;
  const double s1_11 = r_carrier_left_aux1_y*work.R_carrier_left_aux1_z_x;
  work.b_carrier_left_rx_x = s1_11 - r_carrier_left_aux1_z*work.R_carrier_left_aux1_y_x;
  const double s1_12 = r_carrier_left_aux1_z*R_carrier_left_aux1_x_x;
  work.b_carrier_left_rx_y = s1_12 - 3.6*work.R_carrier_left_aux1_z_x;
  const double s1_13 = r_carrier_left_aux1_y*R_carrier_left_aux1_x_x;
  work.b_carrier_left_rx_z = 3.6*work.R_carrier_left_aux1_y_x - s1_13;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_14 = work.cosines[3];
  const double s1_15 = work.sines[3];
  const double R_carrier_left_x_x = R_carrier_left_aux1_x_x*s1_14 - R_carrier_left_aux2_x_z*s1_15;
  const double R_carrier_left_y_x = s1_10*s1_15 + work.R_carrier_left_aux1_y_x*s1_14;
  const double R_carrier_left_z_x = work.R_carrier_left_aux1_z_x*s1_14 -
      R_carrier_left_aux2_z_z*s1_15;
  const double R_carrier_left_x_z = R_carrier_left_aux2_x_z*s1_14 + R_carrier_left_aux1_x_x*s1_15;
  const double R_carrier_left_y_z = work.R_carrier_left_aux1_y_x*s1_15 - s1_10*s1_14;
  const double R_carrier_left_z_z = R_carrier_left_aux2_z_z*s1_14 +
      work.R_carrier_left_aux1_z_x*s1_15;
  const double s1_16 = r_carrier_left_aux1_y*work.R_carrier_left_aux2_z_y;
  work.b_carrier_left_ry_x = s1_16 - r_carrier_left_aux1_z*work.R_carrier_left_aux2_y_y;
  work.s1_17 = 3.6*work.R_carrier_left_aux2_z_y + r_carrier_left_aux1_z*work.s1_8;
  work.b_carrier_left_ry_z = r_carrier_left_aux1_y*work.s1_8 + 3.6*work.R_carrier_left_aux2_y_y;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_z_y = work.sines[6];
  const double R_lower_arm_right_y_y = work.cosines[6];
  const double s1_18 = 0.04999999999999999*R_lower_arm_right_z_y - 0.4;
  const double r_carrier_right_aux1_y = s1_18 - 0.44999999999999996*R_lower_arm_right_y_y;
  const double s1_19 = 0.62 + 0.44999999999999996*R_lower_arm_right_z_y;
  const double s1_20 = s1_19 + 0.04999999999999999*R_lower_arm_right_y_y;
  const double s1_21 = work.sines[7];
  work.R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_21;
  work.R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_21;
  const double R_carrier_right_aux1_x_x = work.cosines[7];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  const double s1_22 = R_lower_arm_right_y_y*r_carrier_right_aux1_y;
  work.b_carrier_right_rz_x = s1_22 - R_lower_arm_right_z_y*s1_20;
  work.s1_23 = 3.6*R_lower_arm_right_y_y;
  work.s1_24 = 3.6*R_lower_arm_right_z_y;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_25 = work.cosines[8];
  work.s1_26 = s1_21*s1_25;
  const double s1_27 = work.sines[8];
  work.R_carrier_right_aux2_y_y = R_carrier_right_aux1_y_y*s1_25 - R_lower_arm_right_z_y*s1_27;
  work.R_carrier_right_aux2_z_y = R_carrier_right_aux1_z_y*s1_25 + R_lower_arm_right_y_y*s1_27;
  const double R_carrier_right_aux2_x_z = s1_21*s1_27;
  const double s1_28 = R_carrier_right_aux1_y_y*s1_27 + R_lower_arm_right_z_y*s1_25;
  const double R_carrier_right_aux2_z_z = R_lower_arm_right_y_y*s1_25 -
      R_carrier_right_aux1_z_y*s1_27;
  const double s1_29 = r_carrier_right_aux1_y*work.R_carrier_right_aux1_z_x;
  work.b_carrier_right_rx_x = s1_20*work.R_carrier_right_aux1_y_x + s1_29;
  work.s1_30 = 3.6*work.R_carrier_right_aux1_z_x + s1_20*R_carrier_right_aux1_x_x;
  const double s1_31 = r_carrier_right_aux1_y*R_carrier_right_aux1_x_x;
  work.b_carrier_right_rx_z = 3.6*work.R_carrier_right_aux1_y_x - s1_31;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_32 = work.cosines[9];
  const double s1_33 = work.sines[9];
  work.R_carrier_right_x_x = R_carrier_right_aux1_x_x*s1_32 - R_carrier_right_aux2_x_z*s1_33;
  work.R_carrier_right_y_x = s1_28*s1_33 + work.R_carrier_right_aux1_y_x*s1_32;
  work.R_carrier_right_z_x = work.R_carrier_right_aux1_z_x*s1_32 - R_carrier_right_aux2_z_z*s1_33;
  work.R_carrier_right_x_z = R_carrier_right_aux2_x_z*s1_32 + R_carrier_right_aux1_x_x*s1_33;
  work.R_carrier_right_y_z = work.R_carrier_right_aux1_y_x*s1_33 - s1_28*s1_32;
  work.R_carrier_right_z_z = R_carrier_right_aux2_z_z*s1_32 + work.R_carrier_right_aux1_z_x*s1_33;
  const double s1_34 = r_carrier_right_aux1_y*work.R_carrier_right_aux2_z_y;
  work.b_carrier_right_ry_x = s1_20*work.R_carrier_right_aux2_y_y + s1_34;
  work.b_carrier_right_ry_y = s1_20*work.s1_26 - 3.6*work.R_carrier_right_aux2_z_y;
  work.b_carrier_right_ry_z = r_carrier_right_aux1_y*work.s1_26 + 3.6*work.R_carrier_right_aux2_y_y;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - 2.4999999999999996;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  work.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] - 0.5;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[14];
  const double R_rear_axle_aux5_z_z = work.cosines[15];
  work.R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double R_rear_axle_aux4_y_x = work.sines[14];
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double s1_35 = work.sines[15];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_35;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_35;
  work.s1_36 = work.r_rear_axle_aux3_z*R_rear_axle_aux4_x_x;
  work.s1_37 = work.r_rear_axle_aux3_z*R_rear_axle_aux4_y_x;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s1_38 = work.r_rear_axle_aux1_x*R_rear_axle_aux4_x_x;
  work.b_rear_axle_ry_z = z_rear_axle_ty*R_rear_axle_aux4_y_x + s1_38;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_39 = work.sines[16];
  const double s1_40 = work.cosines[16];
  work.R_rear_axle_x_y = R_rear_axle_aux5_x_z*s1_39 - R_rear_axle_aux4_y_x*s1_40;
  work.R_rear_axle_y_y = R_rear_axle_aux4_x_x*s1_40 + R_rear_axle_aux5_y_z*s1_39;
  work.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_39;
  work.R_rear_axle_x_z = R_rear_axle_aux4_y_x*s1_39 + R_rear_axle_aux5_x_z*s1_40;
  work.R_rear_axle_y_z = R_rear_axle_aux5_y_z*s1_40 - R_rear_axle_aux4_x_x*s1_39;
  work.R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_40;
  work.s1_41 = work.r_rear_axle_aux3_z*work.R_rear_axle_aux5_y_x + z_rear_axle_ty*s1_35;
  const double s1_42 = work.r_rear_axle_aux3_z*work.R_rear_axle_aux5_x_x;
  work.b_rear_axle_rx_y = work.r_rear_axle_aux1_x*s1_35 + s1_42;
  const double s1_43 = work.r_rear_axle_aux1_x*work.R_rear_axle_aux5_y_x;
  work.b_rear_axle_rx_z = s1_43 - z_rear_axle_ty*work.R_rear_axle_aux5_x_x;
  // operations: 52 add, 116 multiply, 38 sin cos

  // --- step 2: closure Jacobian Phi_z and its factors (60) ---
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s2_1 = zd_lower_arm_left*zd_lower_arm_left;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  const double s2_2 = zd_carrier_left_rz*R_lower_arm_left_z_y;
  const double s2_3 = zd_carrier_left_rz*R_lower_arm_left_y_y;
  const double s2_4 = zd_lower_arm_left*s2_3;
  const double s2_5 = zd_lower_arm_left*s2_2;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  const double s2_6 = zd_carrier_left_rx*R_carrier_left_aux1_x_x;
  const double s2_7 = zd_carrier_left_rx*work.R_carrier_left_aux1_y_x;
  const double s2_8 = zd_carrier_left_rx*work.R_carrier_left_aux1_z_x;
  const double s2_9 = zd_lower_arm_left + s2_6;
  const double s2_10 = s2_7 - s2_2;
  const double s2_11 = s2_3 + s2_8;
  const double s2_12 = s2_3*s2_7 + s2_2*s2_8;
  const double s2_13 = s2_3*s2_6 - s2_4 - zd_lower_arm_left*s2_8;
  const double s2_14 = s2_2*s2_6 - s2_5 + zd_lower_arm_left*s2_7;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  const double s2_15 = zd_carrier_left_ry*work.s1_8;
  const double s2_16 = zd_carrier_left_ry*work.R_carrier_left_aux2_y_y;
  const double s2_17 = zd_carrier_left_ry*work.R_carrier_left_aux2_z_y;
  const double s2_18 = zd_carrier_left_rx*work.b_carrier_left_rx_x;
  const double s2_19 = zd_carrier_left_rz*b_carrier_left_rz_x + s2_18;
  const double s2_20 = s2_19 + zd_carrier_left_ry*work.b_carrier_left_ry_x;
  const double s2_21 = zd_carrier_left_rx*work.b_carrier_left_rx_y - 0.62*zd_lower_arm_left;
  const double s2_22 = s2_21 - zd_carrier_left_rz*work.s1_5 - zd_carrier_left_ry*work.s1_17;
  const double s2_23 = zd_carrier_left_rx*work.b_carrier_left_rx_z - 0.4*zd_lower_arm_left;
  const double s2_24 = zd_carrier_left_ry*work.b_carrier_left_ry_z;
  const double s2_25 = s2_23 - zd_carrier_left_rz*s1_6 + s2_24;
  const double s2_26 = s2_9 - s2_15;
  const double s2_27 = s2_10 + s2_16;
  const double s2_28 = s2_11 + s2_17;
  const double s2_29 = s2_10*s2_17 - s2_12 - s2_11*s2_16;
  const double s2_30 = s2_13 - s2_9*s2_17 - s2_11*s2_15;
  const double s2_31 = s2_14 + s2_10*s2_15 + s2_9*s2_16;
  const double s2_32 = s2_26*s2_26;
  const double s2_33 = s2_27*s2_27;
  const double s2_34 = s2_28*s2_28;
  const double s2_35 = s2_26*s2_27;
  const double s2_36 = s2_26*s2_28;
  const double s2_37 = s2_27*s2_28;
  const double s2_38 = s2_33 + s2_34;
  const double s2_39 = s2_31 + s2_35;
  const double s2_40 = s2_36 - s2_30;
  const double s2_41 = s2_35 - s2_31;
  const double s2_42 = s2_32 + s2_34;
  const double s2_43 = s2_29 + s2_37;
  const double s2_44 = s2_30 + s2_36;
  const double s2_45 = s2_37 - s2_29;
  const double s2_46 = s2_32 + s2_33;
  const double s2_47 = 3.6*s2_38 - r_carrier_left_aux1_y*s2_41 - r_carrier_left_aux1_z*s2_44;
  const double s2_48 = 0.4*s2_1 - 3.6*s2_39 + r_carrier_left_aux1_y*(s2_42 - s2_1);
  const double s2_49 = s2_48 - r_carrier_left_aux1_z*s2_45;
  const double s2_50 = 3.6*s2_40 + 0.62*s2_1 + r_carrier_left_aux1_y*s2_43;
  const double s2_51 = r_carrier_left_aux1_z*(s2_46 - s2_1) - s2_50;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  const double s2_52 = zd_upper_arm_left*zd_upper_arm_left;
  // arb_front_left: arb_front_left, revolute, chassis
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  const double s2_53 = zd_arb_front_left*zd_arb_front_left;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double s2_54 = zd_lower_arm_right*zd_lower_arm_right;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  const double s2_55 = zd_carrier_right_rz*R_lower_arm_right_z_y;
  const double s2_56 = zd_carrier_right_rz*R_lower_arm_right_y_y;
  const double s2_57 = zd_lower_arm_right*s2_56;
  const double s2_58 = zd_lower_arm_right*s2_55;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  const double s2_59 = zd_carrier_right_rx*R_carrier_right_aux1_x_x;
  const double s2_60 = zd_carrier_right_rx*work.R_carrier_right_aux1_y_x;
  const double s2_61 = zd_carrier_right_rx*work.R_carrier_right_aux1_z_x;
  const double s2_62 = zd_lower_arm_right + s2_59;
  const double s2_63 = s2_60 - s2_55;
  const double s2_64 = s2_56 + s2_61;
  const double s2_65 = s2_56*s2_60 + s2_55*s2_61;
  const double s2_66 = s2_56*s2_59 - s2_57 - zd_lower_arm_right*s2_61;
  const double s2_67 = s2_55*s2_59 - s2_58 + zd_lower_arm_right*s2_60;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  const double s2_68 = zd_carrier_right_ry*work.s1_26;
  const double s2_69 = zd_carrier_right_ry*work.R_carrier_right_aux2_y_y;
  const double s2_70 = zd_carrier_right_ry*work.R_carrier_right_aux2_z_y;
  const double s2_71 = zd_carrier_right_rz*work.b_carrier_right_rz_x;
  const double s2_72 = s2_71 + zd_carrier_right_rx*work.b_carrier_right_rx_x;
  work.s2_73 = s2_72 + zd_carrier_right_ry*work.b_carrier_right_ry_x;
  const double s2_74 = zd_carrier_right_ry*work.b_carrier_right_ry_y - 0.62*zd_lower_arm_right;
  work.s2_75 = s2_74 - zd_carrier_right_rz*work.s1_23 - zd_carrier_right_rx*work.s1_30;
  const double s2_76 = 0.4*zd_lower_arm_right - zd_carrier_right_rz*work.s1_24;
  const double s2_77 = s2_76 + zd_carrier_right_rx*work.b_carrier_right_rx_z;
  work.s2_78 = s2_77 + zd_carrier_right_ry*work.b_carrier_right_ry_z;
  work.s2_79 = s2_62 - s2_68;
  work.s2_80 = s2_63 + s2_69;
  work.s2_81 = s2_64 + s2_70;
  const double s2_82 = s2_63*s2_70 - s2_65 - s2_64*s2_69;
  const double s2_83 = s2_66 - s2_62*s2_70 - s2_64*s2_68;
  const double s2_84 = s2_67 + s2_63*s2_68 + s2_62*s2_69;
  const double s2_85 = work.s2_79*work.s2_79;
  const double s2_86 = work.s2_80*work.s2_80;
  const double s2_87 = work.s2_81*work.s2_81;
  const double s2_88 = work.s2_79*work.s2_80;
  const double s2_89 = work.s2_79*work.s2_81;
  const double s2_90 = work.s2_80*work.s2_81;
  work.s2_91 = s2_86 + s2_87;
  work.s2_92 = s2_84 + s2_88;
  work.s2_93 = s2_89 - s2_83;
  work.s2_94 = s2_88 - s2_84;
  work.s2_95 = s2_85 + s2_87;
  work.s2_96 = s2_82 + s2_90;
  work.s2_97 = s2_83 + s2_89;
  work.s2_98 = s2_90 - s2_82;
  work.s2_99 = s2_85 + s2_86;
  work.s2_100 = 3.6*work.s2_91 - r_carrier_right_aux1_y*work.s2_94 + s1_20*work.s2_97;
  const double s2_101 = r_carrier_right_aux1_y*(work.s2_95 - s2_54);
  work.s2_102 = s2_101 - (3.6*work.s2_92 + 0.4*s2_54) + s1_20*work.s2_98;
  const double s2_103 = 3.6*work.s2_93 + 0.62*s2_54 + r_carrier_right_aux1_y*work.s2_96;
  work.s2_104 = s2_103 + s1_20*(work.s2_99 - s2_54);
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  const double s2_105 = zd_upper_arm_right*zd_upper_arm_right;
  // arb_front_right: arb_front_right, revolute, chassis
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  const double s2_106 = zd_arb_front_right*zd_arb_front_right;
  // pitman_arm: pitman_arm, revolute, chassis
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double s2_107 = zd_pitman_arm*zd_pitman_arm;
  // bell_crank: bell_crank, revolute, chassis
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  work.s2_108 = 3.25*zd_bell_crank;
  work.s2_109 = zd_bell_crank*zd_bell_crank;
  work.s2_110 = 3.25*work.s2_109;
  // upper_ball_left
  const double s2_111 = 3.6 + 0.04999999999999993*work.s1_8;
  const double s2_112 = s2_111 + 0.36999999999999994*R_carrier_left_x_z;
  const double s2_113 = r_carrier_left_aux1_y - 0.04999999999999993*work.R_carrier_left_aux2_y_y;
  const double s2_114 = s2_113 + 0.36999999999999994*R_carrier_left_y_z;
  const double s2_115 = r_carrier_left_aux1_z - 0.04999999999999993*work.R_carrier_left_aux2_z_y;
  const double s2_116 = s2_115 + 0.36999999999999994*R_carrier_left_z_z;
  const double R_upper_arm_left_y_y = work.cosines[4];
  const double R_upper_arm_left_z_y = work.sines[4];
  const double s2_117 = 0.5 + 0.30000000000000004*R_upper_arm_left_y_y;
  const double s2_118 = s2_117 + 0.020000000000000018*R_upper_arm_left_z_y;
  const double s2_119 = 0.30000000000000004*R_upper_arm_left_z_y - 0.28;
  const double s2_120 = s2_119 - 0.020000000000000018*R_upper_arm_left_y_y;
  result.Phi[0] = s2_112 - 3.6;
  result.Phi[1] = s2_114 - s2_118;
  result.Phi[2] = s2_116 - s2_120;
  const double s2_121 = b_carrier_left_rz_x - R_lower_arm_left_z_y*s2_116;
  result.Jz[1] = s2_121 - R_lower_arm_left_y_y*s2_114;
  const double s2_122 = work.b_carrier_left_rx_x + work.R_carrier_left_aux1_y_x*s2_116;
  result.Jz[2] = s2_122 - work.R_carrier_left_aux1_z_x*s2_114;
  const double s2_123 = work.b_carrier_left_ry_x + work.R_carrier_left_aux2_y_y*s2_116;
  result.Jz[3] = s2_123 - work.R_carrier_left_aux2_z_y*s2_114;
  result.c[0] = s2_38*s2_112 - s2_47 - s2_41*s2_114 - s2_44*s2_116;
  result.Jz[14] = -(0.62 + s2_116);
  result.Jz[15] = R_lower_arm_left_y_y*s2_112 - work.s1_5;
  const double s2_124 = work.b_carrier_left_rx_y + work.R_carrier_left_aux1_z_x*s2_112;
  result.Jz[16] = s2_124 - R_carrier_left_aux1_x_x*s2_116;
  result.Jz[17] = work.R_carrier_left_aux2_z_y*s2_112 - work.s1_17 + work.s1_8*s2_116;
  const double J_upper_ball_left_upper_arm_left = 0.28 + s2_120;
  result.Jz[18] = J_upper_ball_left_upper_arm_left;
  const double J_upper_ball_left_upper_arm_left_2 = 0.5 - s2_118;
  result.Jz[32] = J_upper_ball_left_upper_arm_left_2;
  const double s2_125 = s2_42*s2_114 - s2_49 - s2_45*s2_116 - s2_39*s2_112;
  result.c[1] = s2_125 + s2_52*J_upper_ball_left_upper_arm_left_2;
  result.Jz[28] = s2_114 - 0.4;
  result.Jz[29] = R_lower_arm_left_z_y*s2_112 - s1_6;
  const double s2_126 = work.b_carrier_left_rx_z + R_carrier_left_aux1_x_x*s2_114;
  result.Jz[30] = s2_126 - work.R_carrier_left_aux1_y_x*s2_112;
  const double s2_127 = work.b_carrier_left_ry_z - work.R_carrier_left_aux2_y_y*s2_112;
  result.Jz[31] = s2_127 - work.s1_8*s2_114;
  const double s2_128 = s2_46*s2_116 - s2_51 - s2_43*s2_114 - s2_40*s2_112;
  result.c[2] = s2_128 - s2_52*J_upper_ball_left_upper_arm_left;
  // upper_ball_right
  work.s2_129 = 3.6 - 0.04999999999999993*work.s1_26;
  const double s2_130 = work.s2_129 + 0.36999999999999994*work.R_carrier_right_x_z;
  const double s2_131 = 0.04999999999999993*work.R_carrier_right_aux2_y_y;
  work.s2_132 = r_carrier_right_aux1_y + s2_131;
  const double s2_133 = work.s2_132 + 0.36999999999999994*work.R_carrier_right_y_z;
  work.s2_134 = 0.04999999999999993*work.R_carrier_right_aux2_z_y - s1_20;
  const double s2_135 = work.s2_134 + 0.36999999999999994*work.R_carrier_right_z_z;
  const double R_upper_arm_right_z_y = work.sines[10];
  const double R_upper_arm_right_y_y = work.cosines[10];
  const double s2_136 = 0.020000000000000018*R_upper_arm_right_z_y - 0.5;
  const double s2_137 = s2_136 - 0.30000000000000004*R_upper_arm_right_y_y;
  const double s2_138 = 0.28 + 0.30000000000000004*R_upper_arm_right_z_y;
  const double s2_139 = s2_138 + 0.020000000000000018*R_upper_arm_right_y_y;
  result.Phi[3] = s2_130 - 3.6;
  result.Phi[4] = s2_133 - s2_137;
  result.Phi[5] = s2_135 + s2_139;
  const double s2_140 = work.b_carrier_right_rz_x - R_lower_arm_right_z_y*s2_135;
  result.Jz[49] = s2_140 - R_lower_arm_right_y_y*s2_133;
  const double s2_141 = work.b_carrier_right_rx_x + work.R_carrier_right_aux1_y_x*s2_135;
  result.Jz[50] = s2_141 - work.R_carrier_right_aux1_z_x*s2_133;
  const double s2_142 = work.b_carrier_right_ry_x + work.R_carrier_right_aux2_y_y*s2_135;
  result.Jz[51] = s2_142 - work.R_carrier_right_aux2_z_y*s2_133;
  result.c[3] = work.s2_91*s2_130 - work.s2_100 - work.s2_94*s2_133 - work.s2_97*s2_135;
  result.Jz[62] = -(0.62 + s2_135);
  result.Jz[63] = R_lower_arm_right_y_y*s2_130 - work.s1_23;
  const double s2_143 = work.R_carrier_right_aux1_z_x*s2_130 - work.s1_30;
  result.Jz[64] = s2_143 - R_carrier_right_aux1_x_x*s2_135;
  const double s2_144 = work.b_carrier_right_ry_y + work.R_carrier_right_aux2_z_y*s2_130;
  result.Jz[65] = s2_144 + work.s1_26*s2_135;
  result.Jz[66] = 0.28 - s2_139;
  const double s2_145 = 0.5 + s2_137;
  const double s2_146 = work.s2_95*s2_133 - work.s2_102 - work.s2_98*s2_135 - work.s2_92*s2_130;
  result.c[4] = s2_146 - s2_105*s2_145;
  result.Jz[76] = 0.4 + s2_133;
  result.Jz[77] = R_lower_arm_right_z_y*s2_130 - work.s1_24;
  const double s2_147 = work.b_carrier_right_rx_z + R_carrier_right_aux1_x_x*s2_133;
  result.Jz[78] = s2_147 - work.R_carrier_right_aux1_y_x*s2_130;
  const double s2_148 = work.b_carrier_right_ry_z - work.R_carrier_right_aux2_y_y*s2_130;
  result.Jz[79] = s2_148 - work.s1_26*s2_133;
  result.Jz[80] = -s2_145;
  const double s2_149 = work.s2_104 + work.s2_99*s2_135 - work.s2_96*s2_133 - work.s2_93*s2_130;
  result.c[5] = s2_149 + s2_105*(s2_139 - 0.28);
  // arb_link_front_left
  const double s2_150 = 0.02999999999999997*R_carrier_left_x_z;
  const double s2_151 = 3.6 + 0.030000000000000027*work.s1_8 + s2_150 + 0.1*R_carrier_left_x_x;
  const double s2_152 = r_carrier_left_aux1_y + 0.02999999999999997*R_carrier_left_y_z;
  const double s2_153 = 0.030000000000000027*work.R_carrier_left_aux2_y_y;
  const double s2_154 = s2_152 + 0.1*R_carrier_left_y_x - s2_153;
  const double s2_155 = r_carrier_left_aux1_z + 0.02999999999999997*R_carrier_left_z_z;
  const double s2_156 = 0.030000000000000027*work.R_carrier_left_aux2_z_y;
  const double s2_157 = s2_155 + 0.1*R_carrier_left_z_x - s2_156;
  const double R_arb_front_left_x_z = work.sines[5];
  const double R_arb_front_left_x_x = work.cosines[5];
  const double s2_158 = 3.95 + 0.09999999999999998*R_arb_front_left_x_z;
  const double s2_159 = s2_158 - 0.24999999999999997*R_arb_front_left_x_x;
  const double s2_160 = 0.09999999999999998*R_arb_front_left_x_x - 0.5;
  const double s2_161 = s2_160 + 0.24999999999999997*R_arb_front_left_x_z;
  const double s2_162 = s2_159 - s2_151;
  const double s2_163 = 0.72 - s2_154;
  const double s2_164 = s2_161 - s2_157;
  const double s2_165 = 3.846153846153846*s2_162;
  const double s2_166 = 3.846153846153846*s2_163;
  const double s2_167 = 3.846153846153846*s2_164;
  const double s2_168 = s2_22 + s2_28*s2_151 - s2_26*s2_157;
  const double s2_169 = 0.5 + s2_161;
  const double s2_170 = s2_28*s2_154 - s2_20 - s2_27*s2_157 + zd_arb_front_left*s2_169;
  const double s2_171 = 3.95 - s2_159;
  const double s2_172 = s2_27*s2_151 - s2_25 - s2_26*s2_154 + zd_arb_front_left*s2_171;
  result.Phi[6] = 0.5*(s2_163*s2_166 - 0.26 + s2_164*s2_167 + s2_162*s2_165);
  const double s2_173 = s2_154*s2_167 - s2_157*s2_166;
  const double s2_174 = s2_157*s2_165 - s2_151*s2_167;
  const double s2_175 = s2_151*s2_166 - s2_154*s2_165;
  result.Jz[84] = 0.62*s2_166 - s2_173 + 0.4*s2_167;
  const double s2_176 = R_lower_arm_left_z_y*s2_174 - R_lower_arm_left_y_y*s2_175;
  result.Jz[85] = s2_176 - b_carrier_left_rz_x*s2_165 + s1_6*s2_167 + work.s1_5*s2_166;
  const double s2_177 = work.R_carrier_left_aux1_y_x*s2_174;
  const double s2_178 = s2_177 + work.R_carrier_left_aux1_z_x*s2_175;
  const double s2_179 = s2_178 + R_carrier_left_aux1_x_x*s2_173;
  const double s2_180 = s2_179 + work.b_carrier_left_rx_y*s2_166;
  const double s2_181 = s2_180 + work.b_carrier_left_rx_z*s2_167;
  result.Jz[86] = -(s2_181 + work.b_carrier_left_rx_x*s2_165);
  const double s2_182 = work.s1_8*s2_173 - work.R_carrier_left_aux2_y_y*s2_174;
  const double s2_183 = s2_182 - work.R_carrier_left_aux2_z_y*s2_175;
  const double s2_184 = s2_183 - work.b_carrier_left_ry_z*s2_167;
  result.Jz[87] = s2_184 - work.b_carrier_left_ry_x*s2_165 + work.s1_17*s2_166;
  result.Jz[89] = s2_165*s2_169 + s2_167*s2_171;
  const double s2_185 = s2_51 + s2_43*s2_154 + s2_40*s2_151 - s2_46*s2_157 + s2_53*s2_169;
  const double s2_186 = s2_38*s2_151 - s2_47 - s2_41*s2_154 - s2_44*s2_157 + s2_53*s2_171;
  const double s2_187 = s2_166*(s2_49 + s2_45*s2_157 + s2_39*s2_151 - s2_42*s2_154);
  const double s2_188 = 3.846153846153846*(s2_168*s2_168 + s2_172*s2_172 + s2_170*s2_170);
  result.c[6] = s2_167*s2_185 - s2_165*s2_186 + s2_187 - s2_188;
  // arb_link_front_right
  const double s2_189 = 3.6 + 0.02999999999999997*work.R_carrier_right_x_z;
  const double s2_190 = s2_189 + 0.1*work.R_carrier_right_x_x - 0.030000000000000027*work.s1_26;
  const double s2_191 = 0.030000000000000027*work.R_carrier_right_aux2_y_y;
  const double s2_192 = 0.02999999999999997*work.R_carrier_right_y_z;
  const double s2_193 = r_carrier_right_aux1_y + s2_191 + s2_192 + 0.1*work.R_carrier_right_y_x;
  const double s2_194 = 0.030000000000000027*work.R_carrier_right_aux2_z_y - s1_20;
  const double s2_195 = s2_194 + 0.02999999999999997*work.R_carrier_right_z_z;
  const double s2_196 = s2_195 + 0.1*work.R_carrier_right_z_x;
  const double R_arb_front_right_x_z = work.sines[11];
  const double R_arb_front_right_x_x = work.cosines[11];
  const double s2_197 = 3.95 + 0.09999999999999998*R_arb_front_right_x_z;
  const double s2_198 = s2_197 - 0.24999999999999997*R_arb_front_right_x_x;
  const double s2_199 = 0.09999999999999998*R_arb_front_right_x_x - 0.5;
  const double s2_200 = s2_199 + 0.24999999999999997*R_arb_front_right_x_z;
  const double s2_201 = s2_198 - s2_190;
  const double s2_202 = 0.72 + s2_193;
  const double s2_203 = s2_200 - s2_196;
  const double s2_204 = 3.846153846153846*s2_201;
  const double s2_205 = 3.846153846153846*s2_202;
  const double s2_206 = 3.846153846153846*s2_203;
  const double s2_207 = work.s2_75 + work.s2_81*s2_190 - work.s2_79*s2_196;
  const double s2_208 = 0.5 + s2_200;
  const double s2_209 = work.s2_81*s2_193 - work.s2_73 - work.s2_80*s2_196;
  const double s2_210 = s2_209 + zd_arb_front_right*s2_208;
  const double s2_211 = 3.95 - s2_198;
  const double s2_212 = work.s2_80*s2_190 - work.s2_78 - work.s2_79*s2_193;
  const double s2_213 = s2_212 + zd_arb_front_right*s2_211;
  result.Phi[7] = 0.5*(s2_202*s2_205 - 0.26 + s2_203*s2_206 + s2_201*s2_204);
  const double s2_214 = s2_196*s2_205 + s2_193*s2_206;
  const double s2_215 = s2_196*s2_204 - s2_190*s2_206;
  const double s2_216 = s2_193*s2_204 + s2_190*s2_205;
  const double s2_217 = work.s2_91*s2_190 - work.s2_100 - work.s2_94*s2_193 - work.s2_97*s2_196;
  const double s2_218 = work.s2_96*s2_193 - work.s2_104 + work.s2_93*s2_190 - work.s2_99*s2_196;
  result.Jz[104] = -(s2_214 + 0.62*s2_205 + 0.4*s2_206);
  const double s2_219 = work.s1_24*s2_206 - work.s1_23*s2_205 - work.b_carrier_right_rz_x*s2_204;
  result.Jz[105] = s2_219 + R_lower_arm_right_z_y*s2_215 + R_lower_arm_right_y_y*s2_216;
  const double s2_220 = work.R_carrier_right_aux1_z_x*s2_216;
  const double s2_221 = s2_220 - work.R_carrier_right_aux1_y_x*s2_215;
  const double s2_222 = s2_221 - R_carrier_right_aux1_x_x*s2_214 - work.s1_30*s2_205;
  const double s2_223 = s2_222 - work.b_carrier_right_rx_z*s2_206;
  result.Jz[106] = s2_223 - work.b_carrier_right_rx_x*s2_204;
  const double s2_224 = work.R_carrier_right_aux2_z_y*s2_216;
  const double s2_225 = s2_224 - work.R_carrier_right_aux2_y_y*s2_215 + work.s1_26*s2_214;
  const double s2_226 = s2_225 - work.b_carrier_right_ry_z*s2_206;
  const double s2_227 = s2_226 - work.b_carrier_right_ry_x*s2_204;
  result.Jz[107] = s2_227 + work.b_carrier_right_ry_y*s2_205;
  result.Jz[109] = s2_204*s2_208 + s2_206*s2_211;
  const double s2_228 = work.s2_102 + work.s2_98*s2_196 + work.s2_92*s2_190 - work.s2_95*s2_193;
  const double s2_229 = s2_206*(s2_218 + s2_106*s2_208) - s2_205*s2_228;
  const double s2_230 = 3.846153846153846*(s2_207*s2_207 + s2_213*s2_213 + s2_210*s2_210);
  result.c[7] = s2_229 - s2_204*(s2_217 + s2_106*s2_211) - s2_230;
  // drag_link
  const double R_bell_crank_x_x = work.cosines[13];
  const double s2_231 = 0.3*R_bell_crank_x_x;
  const double R_bell_crank_y_x = work.sines[13];
  const double s2_232 = 3.25 - 0.3*R_bell_crank_y_x;
  const double s2_233 = 4.4 - 0.21999999999999997*work.sines[12];
  const double s2_234 = 0.4 + 0.21999999999999997*work.cosines[12];
  const double s2_235 = s2_233 - s2_232;
  const double s2_236 = 0.5 - s2_231;
  const double s2_237 = 0.6 - s2_234;
  const double s2_238 = 0.8565801464479955*s2_235;
  const double s2_239 = 0.8565801464479955*s2_236;
  const double s2_240 = 0.8565801464479955*s2_237;
  const double s2_241 = zd_bell_crank*s2_232 - work.s2_108;
  const double s2_242 = 4.4 - s2_233;
  const double s2_243 = zd_pitman_arm*s2_242;
  const double s2_244 = 0.4 - s2_234;
  const double s2_245 = zd_bell_crank*s2_231 + zd_pitman_arm*s2_244;
  result.Phi[8] = 0.5*(s2_236*s2_239 - 1.1674330815939729 + s2_237*s2_240 + s2_235*s2_238);
  result.Jz[124] = s2_238*s2_244 + s2_240*s2_242;
  result.Jz[125] = s2_231*s2_238 + s2_239*(3.25 - s2_232);
  const double s2_246 = s2_239*(work.s2_109*s2_231) + s2_240*(s2_107*(s2_234 - 0.4));
  const double s2_247 = s2_246 + s2_238*(work.s2_109*s2_232 - work.s2_110 + s2_107*s2_242);
  const double s2_248 = 0.8565801464479955*(s2_241*s2_241 + s2_243*s2_243 + s2_245*s2_245);
  result.c[8] = -(s2_247 + s2_248);
  // tie_rod_left
  const double s2_249 = s2_111 + 0.07*R_carrier_left_x_z - 0.22*R_carrier_left_x_x;
  const double s2_250 = s2_113 + 0.07*R_carrier_left_y_z - 0.22*R_carrier_left_y_x;
  const double s2_251 = s2_115 + 0.07*R_carrier_left_z_z - 0.22*R_carrier_left_z_x;
  work.s2_252 = 0.08*R_bell_crank_y_x;
  work.s2_253 = 0.20000000000000007*R_bell_crank_x_x;
  work.s2_254 = 0.08*R_bell_crank_x_x;
  work.s2_255 = 0.20000000000000007*R_bell_crank_y_x;
  work.s2_256 = work.s2_254 - work.s2_255;
  work.s2_257 = 3.25 - work.s2_252 - work.s2_253;
  const double s2_258 = work.s2_257 - s2_249;
  const double s2_259 = work.s2_256 - s2_250;
  const double s2_260 = 0.6 + s2_251;
  work.s2_261 = 1.2625900317976169*s2_258;
  work.s2_262 = 1.2625900317976169*s2_259;
  work.s2_263 = 1.2625900317976169*s2_260;
  const double s2_264 = s2_25 + s2_26*s2_250 - s2_27*s2_249;
  const double s2_265 = s2_20 + s2_27*s2_251 - s2_28*s2_250 + zd_bell_crank*work.s2_256;
  const double s2_266 = zd_bell_crank*work.s2_257 - work.s2_108 - s2_22 - s2_28*s2_249;
  const double s2_267 = s2_266 + s2_26*s2_251;
  const double s2_268 = s2_259*work.s2_262 - 0.7920227269466452 + s2_260*work.s2_263;
  result.Phi[9] = 0.5*(s2_268 + s2_258*work.s2_261);
  work.s2_269 = s2_251*work.s2_262 + s2_250*work.s2_263;
  work.s2_270 = s2_249*work.s2_263 + s2_251*work.s2_261;
  work.s2_271 = s2_249*work.s2_262 - s2_250*work.s2_261;
  work.s2_272 = s2_51 + s2_43*s2_250 + s2_40*s2_249 - s2_46*s2_251;
  const double s2_273 = work.s2_110 - s2_47 - work.s2_109*work.s2_257 - s2_41*s2_250;
  work.s2_274 = s2_273 - s2_44*s2_251 + s2_38*s2_249;
  const double s2_275 = s2_49 + s2_45*s2_251 + s2_39*s2_249 - s2_42*s2_250;
  work.s2_276 = s2_275 + work.s2_109*work.s2_256;
  work.s2_277 = s2_267*s2_267 + s2_264*s2_264 + s2_265*s2_265;
  result.Jz[126] = work.s2_269 - 0.4*work.s2_263 + 0.62*work.s2_262;
  const double s2_278 = R_lower_arm_left_z_y*work.s2_270 - R_lower_arm_left_y_y*work.s2_271;
  work.s2_279 = s2_278 - s1_6*work.s2_263 - b_carrier_left_rz_x*work.s2_261;
}

/// Part 2 of compute_closure_terms: step 2: closure Jacobian Phi_z and its factors (60).
[[gnu::noinline]] void compute_closure_terms_2(const State& state,
    ClosureTermsWork& __restrict work, ClosureTerms& __restrict result) noexcept {
  // --- step 2: closure Jacobian Phi_z and its factors (60), continued ---
  // tie_rod_left
  result.Jz[127] = work.s2_279 + work.s1_5*work.s2_262;
  const double s2_280 = work.cosines[1]*work.s2_269 - work.R_carrier_left_aux1_y_x*work.s2_270;
  const double s2_281 = s2_280 - work.R_carrier_left_aux1_z_x*work.s2_271;
  const double s2_282 = s2_281 - work.b_carrier_left_rx_y*work.s2_262;
  const double s2_283 = s2_282 - work.b_carrier_left_rx_x*work.s2_261;
  result.Jz[128] = s2_283 + work.b_carrier_left_rx_z*work.s2_263;
  const double s2_284 = work.R_carrier_left_aux2_y_y*work.s2_270;
  const double s2_285 = work.b_carrier_left_ry_z*work.s2_263 - s2_284;
  const double s2_286 = s2_285 - work.R_carrier_left_aux2_z_y*work.s2_271;
  const double s2_287 = s2_286 - work.s1_8*work.s2_269 - work.b_carrier_left_ry_x*work.s2_261;
  result.Jz[129] = s2_287 + work.s1_17*work.s2_262;
  result.Jz[139] = work.s2_262*(work.s2_257 - 3.25) - work.s2_256*work.s2_261;
  const double s2_288 = work.s2_262*work.s2_276 - work.s2_263*work.s2_272;
  result.c[9] = s2_288 - work.s2_261*work.s2_274 - 1.2625900317976169*work.s2_277;
  // tie_rod_right
  const double s2_289 = work.s2_129 + 0.07*work.R_carrier_right_x_z;
  const double s2_290 = s2_289 - 0.22*work.R_carrier_right_x_x;
  const double s2_291 = work.s2_132 + 0.07*work.R_carrier_right_y_z;
  const double s2_292 = s2_291 - 0.22*work.R_carrier_right_y_x;
  const double s2_293 = work.s2_134 + 0.07*work.R_carrier_right_z_z;
  const double s2_294 = s2_293 - 0.22*work.R_carrier_right_z_x;
  const double s2_295 = work.s2_254 + work.s2_255;
  const double s2_296 = 3.25 + (work.s2_252 - work.s2_253);
  const double s2_297 = s2_296 - s2_290;
  const double s2_298 = s2_292 + s2_295;
  const double s2_299 = 0.6 + s2_294;
  const double s2_300 = 1.2625900317976169*s2_297;
  const double s2_301 = 1.2625900317976169*s2_298;
  const double s2_302 = 1.2625900317976169*s2_299;
  const double s2_303 = work.s2_78 + work.s2_79*s2_292 - work.s2_80*s2_290;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s2_304 = zd_bell_crank*s2_295 - work.s2_73 - work.s2_80*s2_294;
  const double s2_305 = s2_304 + work.s2_81*s2_292;
  const double s2_306 = zd_bell_crank*s2_296 - work.s2_108 - work.s2_75 - work.s2_81*s2_290;
  const double s2_307 = s2_306 + work.s2_79*s2_294;
  result.Phi[10] = 0.5*(s2_298*s2_301 - 0.7920227269466452 + s2_299*s2_302 + s2_297*s2_300);
  const double s2_308 = s2_294*s2_301 - s2_292*s2_302;
  const double s2_309 = s2_290*s2_302 + s2_294*s2_300;
  const double s2_310 = s2_292*s2_300 + s2_290*s2_301;
  const double s2_311 = work.s2_110 - work.s2_100 - work.s2_109*s2_296 - work.s2_94*s2_292;
  const double s2_312 = work.s2_109*s2_295 - work.s2_102 - work.s2_98*s2_294 - work.s2_92*s2_290;
  result.Jz[146] = 0.4*s2_302 - s2_308 - 0.62*s2_301;
  const double s2_313 = work.sines[6]*s2_309 - work.s1_23*s2_301 - work.s1_24*s2_302;
  result.Jz[147] = s2_313 - work.b_carrier_right_rz_x*s2_300 + work.cosines[6]*s2_310;
  const double s2_314 = work.R_carrier_right_aux1_z_x*s2_310;
  const double s2_315 = s2_314 - work.R_carrier_right_aux1_y_x*s2_309 - work.cosines[7]*s2_308;
  const double s2_316 = s2_315 - work.s1_30*s2_301 - work.b_carrier_right_rx_x*s2_300;
  result.Jz[148] = s2_316 + work.b_carrier_right_rx_z*s2_302;
  const double s2_317 = work.R_carrier_right_aux2_z_y*s2_310;
  const double s2_318 = s2_317 - work.R_carrier_right_aux2_y_y*s2_309 + work.s1_26*s2_308;
  const double s2_319 = s2_318 - work.b_carrier_right_ry_x*s2_300;
  const double s2_320 = s2_319 + work.b_carrier_right_ry_z*s2_302;
  result.Jz[149] = s2_320 + work.b_carrier_right_ry_y*s2_301;
  result.Jz[153] = s2_295*s2_300 + s2_301*(3.25 - s2_296);
  const double s2_321 = work.s2_96*s2_292 - work.s2_104 + work.s2_93*s2_290 - work.s2_99*s2_294;
  const double s2_322 = s2_300*(s2_311 - work.s2_97*s2_294 + work.s2_91*s2_290);
  const double s2_323 = 1.2625900317976169*(s2_307*s2_307 + s2_303*s2_303 + s2_305*s2_305);
  result.c[10] = s2_301*(s2_312 + work.s2_95*s2_292) - s2_302*s2_321 - s2_322 - s2_323;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  const double R_rear_axle_aux4_y_x = work.sines[14];
  const double s2_324 = zd_rear_axle_ry*R_rear_axle_aux4_y_x;
  const double R_rear_axle_aux4_x_x = work.cosines[14];
  const double s2_325 = zd_rear_axle_ry*R_rear_axle_aux4_x_x;
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  const double s2_326 = zd_rear_axle_rz*s2_325;
  const double s2_327 = zd_rear_axle_rz*s2_324;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  const double s2_328 = zd_rear_axle_rx*work.R_rear_axle_aux5_x_x;
  const double s2_329 = zd_rear_axle_rx*work.R_rear_axle_aux5_y_x;
  const double s1_35 = work.sines[15];
  const double s2_330 = zd_rear_axle_rx*s1_35;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s2_331 = state.zd[Coordinate::rear_axle_tx] + z_rear_axle_ty*zd_rear_axle_rz;
  const double s2_332 = s2_331 - zd_rear_axle_ry*work.s1_36 - zd_rear_axle_rx*work.s1_41;
  const double s2_333 = zd_rear_axle_rz*work.r_rear_axle_aux1_x;
  const double s2_334 = state.zd[Coordinate::rear_axle_ty] - s2_333 - zd_rear_axle_ry*work.s1_37;
  const double s2_335 = s2_334 + zd_rear_axle_rx*work.b_rear_axle_rx_y;
  const double s2_336 = zd_rear_axle_ry*work.b_rear_axle_ry_z;
  const double s2_337 = state.zd[Coordinate::rear_axle_tz] + s2_336;
  const double s2_338 = s2_337 + zd_rear_axle_rx*work.b_rear_axle_rx_z;
  const double s2_339 = s2_328 - s2_324;
  const double s2_340 = s2_325 + s2_329;
  const double s2_341 = zd_rear_axle_rz - s2_330;
  const double s2_342 = s2_325*s2_328 + s2_324*s2_329;
  const double s2_343 = s2_326 + zd_rear_axle_rz*s2_329 + s2_325*s2_330;
  const double s2_344 = zd_rear_axle_rz*s2_328 - s2_327 - s2_324*s2_330;
  const double s2_345 = s2_339*s2_339;
  const double s2_346 = s2_340*s2_340;
  const double s2_347 = s2_341*s2_341;
  const double s2_348 = s2_339*s2_340;
  const double s2_349 = s2_339*s2_341;
  const double s2_350 = s2_340*s2_341;
  const double s2_351 = s2_346 + s2_347;
  const double s2_352 = s2_348 - s2_342;
  const double s2_353 = s2_349 - s2_344;
  const double s2_354 = s2_342 + s2_348;
  const double s2_355 = s2_345 + s2_347;
  const double s2_356 = s2_350 - s2_343;
  const double s2_357 = s2_344 + s2_349;
  const double s2_358 = s2_343 + s2_350;
  const double s2_359 = s2_345 + s2_346;
  const double s2_360 = work.r_rear_axle_aux1_x*s2_351 - z_rear_axle_ty*s2_354;
  const double s2_361 = s2_360 - work.r_rear_axle_aux3_z*s2_357;
  const double s2_362 = z_rear_axle_ty*s2_355 - work.r_rear_axle_aux1_x*s2_352;
  const double s2_363 = s2_362 - work.r_rear_axle_aux3_z*s2_358;
  const double s2_364 = work.r_rear_axle_aux3_z*s2_359 - work.r_rear_axle_aux1_x*s2_353;
  const double s2_365 = s2_364 - z_rear_axle_ty*s2_356;
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double s2_366 = zd_arb_rear_left*zd_arb_rear_left;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double s2_367 = zd_arb_rear_right*zd_arb_rear_right;
  // long_rod_left
  const double s2_368 = 0.55*work.R_rear_axle_x_y;
  const double s2_369 = 0.04999999999999982*work.R_rear_axle_aux5_x_x;
  const double s2_370 = 0.55*work.R_rear_axle_y_y;
  const double s2_371 = 0.04999999999999982*work.R_rear_axle_aux5_y_x;
  const double s2_372 = 0.55*work.R_rear_axle_z_y;
  const double s2_373 = 0.08000000000000002*work.R_rear_axle_z_z + 0.04999999999999982*s1_35;
  const double s2_374 = s2_369 - 0.08000000000000002*work.R_rear_axle_x_z;
  const double s2_375 = work.r_rear_axle_aux1_x + s2_374;
  const double s2_376 = s2_368 + s2_375;
  const double s2_377 = z_rear_axle_ty + (s2_371 - 0.08000000000000002*work.R_rear_axle_y_z);
  const double s2_378 = s2_370 + s2_377;
  const double s2_379 = work.r_rear_axle_aux3_z + s2_372 - s2_373;
  const double s2_380 = 1.6 + s2_376;
  const double s2_381 = 0.55 - s2_378;
  const double s2_382 = 0.55 + s2_379;
  const double J_long_rod_left_rear_axle_tx = 1.1757385222540742*s2_380;
  result.Jz[154] = J_long_rod_left_rear_axle_tx;
  const double s2_383 = 1.1757385222540742*s2_381;
  const double J_long_rod_left_rear_axle_tz = 1.1757385222540742*s2_382;
  result.Jz[156] = J_long_rod_left_rear_axle_tz;
  const double s2_384 = s2_332 + s2_340*s2_379 - s2_341*s2_378;
  const double s2_385 = s2_335 + s2_341*s2_376 - s2_339*s2_379;
  const double s2_386 = s2_338 + s2_339*s2_378 - s2_340*s2_376;
  const double s2_387 = s2_381*s2_383 - 0.8505292469985963 + s2_382*J_long_rod_left_rear_axle_tz;
  result.Phi[11] = 0.5*(s2_387 + s2_380*J_long_rod_left_rear_axle_tx);
  const double s2_388 = s2_379*s2_383 + s2_378*J_long_rod_left_rear_axle_tz;
  const double s2_389 = s2_376*J_long_rod_left_rear_axle_tz;
  const double s2_390 = s2_389 - s2_379*J_long_rod_left_rear_axle_tx;
  const double s2_391 = s2_378*J_long_rod_left_rear_axle_tx + s2_376*s2_383;
  result.Jz[155] = -s2_383;
  const double s2_392 = z_rear_axle_ty*J_long_rod_left_rear_axle_tx;
  result.Jz[157] = work.r_rear_axle_aux1_x*s2_383 - s2_391 + s2_392;
  const double s2_393 = work.b_rear_axle_ry_z*J_long_rod_left_rear_axle_tz;
  const double s2_394 = s2_393 - R_rear_axle_aux4_x_x*s2_390 - R_rear_axle_aux4_y_x*s2_388;
  result.Jz[158] = s2_394 - work.s1_36*J_long_rod_left_rear_axle_tx + work.s1_37*s2_383;
  const double s2_395 = s1_35*s2_391 - work.R_rear_axle_aux5_y_x*s2_390;
  const double s2_396 = s2_395 + work.R_rear_axle_aux5_x_x*s2_388 - work.b_rear_axle_rx_y*s2_383;
  const double s2_397 = work.b_rear_axle_rx_z*J_long_rod_left_rear_axle_tz;
  result.Jz[159] = s2_396 - work.s1_41*J_long_rod_left_rear_axle_tx + s2_397;
  const double s2_398 = s2_365 + s2_356*s2_378 + s2_353*s2_376 - s2_359*s2_379;
  const double s2_399 = s2_383*(s2_363 + s2_358*s2_379 + s2_352*s2_376 - s2_355*s2_378);
  const double s2_400 = s2_361 + s2_354*s2_378 + s2_357*s2_379 - s2_351*s2_376;
  const double s2_401 = s2_399 - J_long_rod_left_rear_axle_tz*s2_398;
  const double s2_402 = 1.1757385222540742*(s2_385*s2_385 + s2_386*s2_386 + s2_384*s2_384);
  result.c[11] = s2_401 - J_long_rod_left_rear_axle_tx*s2_400 - s2_402;
  // diag_rod_left
  const double s2_403 = 0.1*work.R_rear_axle_x_y;
  const double s2_404 = 0.1*work.R_rear_axle_y_y;
  const double s2_405 = 0.1*work.R_rear_axle_z_y;
  const double s2_406 = work.r_rear_axle_aux1_x + 0.25*work.R_rear_axle_x_z;
  const double s2_407 = s2_403 + s2_406;
  const double s2_408 = z_rear_axle_ty + 0.25*work.R_rear_axle_y_z;
  const double s2_409 = s2_404 + s2_408;
  const double s2_410 = work.r_rear_axle_aux3_z + 0.25*work.R_rear_axle_z_z;
  const double s2_411 = s2_405 + s2_410;
  const double s2_412 = 1.6999999999999997 + s2_407;
  const double s2_413 = 0.4 - s2_409;
  const double s2_414 = 0.15000000000000002 + s2_411;
  const double J_diag_rod_left_rear_axle_tx = 1.162476387438193*s2_412;
  result.Jz[162] = J_diag_rod_left_rear_axle_tx;
  const double s2_415 = 1.162476387438193*s2_413;
  const double J_diag_rod_left_rear_axle_tz = 1.162476387438193*s2_414;
  result.Jz[164] = J_diag_rod_left_rear_axle_tz;
  const double s2_416 = s2_332 + s2_340*s2_411 - s2_341*s2_409;
  const double s2_417 = s2_335 + s2_341*s2_407 - s2_339*s2_411;
  const double s2_418 = s2_338 + s2_339*s2_409 - s2_340*s2_407;
  const double s2_419 = s2_413*s2_415 - 0.8602325267042625 + s2_414*J_diag_rod_left_rear_axle_tz;
  result.Phi[12] = 0.5*(s2_419 + s2_412*J_diag_rod_left_rear_axle_tx);
  const double s2_420 = s2_411*s2_415 + s2_409*J_diag_rod_left_rear_axle_tz;
  const double s2_421 = s2_407*J_diag_rod_left_rear_axle_tz;
  const double s2_422 = s2_421 - s2_411*J_diag_rod_left_rear_axle_tx;
  const double s2_423 = s2_409*J_diag_rod_left_rear_axle_tx + s2_407*s2_415;
  result.Jz[163] = -s2_415;
  const double s2_424 = z_rear_axle_ty*J_diag_rod_left_rear_axle_tx;
  result.Jz[165] = work.r_rear_axle_aux1_x*s2_415 - s2_423 + s2_424;
  const double s2_425 = work.b_rear_axle_ry_z*J_diag_rod_left_rear_axle_tz;
  const double s2_426 = s2_425 - R_rear_axle_aux4_x_x*s2_422 - R_rear_axle_aux4_y_x*s2_420;
  result.Jz[166] = s2_426 - work.s1_36*J_diag_rod_left_rear_axle_tx + work.s1_37*s2_415;
  const double s2_427 = s1_35*s2_423 - work.R_rear_axle_aux5_y_x*s2_422;
  const double s2_428 = s2_427 + work.R_rear_axle_aux5_x_x*s2_420 - work.b_rear_axle_rx_y*s2_415;
  const double s2_429 = work.b_rear_axle_rx_z*J_diag_rod_left_rear_axle_tz;
  result.Jz[167] = s2_428 - work.s1_41*J_diag_rod_left_rear_axle_tx + s2_429;
  const double s2_430 = s2_365 + s2_356*s2_409 + s2_353*s2_407 - s2_359*s2_411;
  const double s2_431 = s2_415*(s2_363 + s2_358*s2_411 + s2_352*s2_407 - s2_355*s2_409);
  const double s2_432 = s2_361 + s2_354*s2_409 + s2_357*s2_411 - s2_351*s2_407;
  const double s2_433 = s2_431 - J_diag_rod_left_rear_axle_tz*s2_430;
  const double s2_434 = 1.162476387438193*(s2_417*s2_417 + s2_418*s2_418 + s2_416*s2_416);
  result.c[12] = s2_433 - J_diag_rod_left_rear_axle_tx*s2_432 - s2_434;
  // arb_link_rear_left
  const double s2_435 = 0.6*work.R_rear_axle_x_y;
  const double s2_436 = 0.35000000000000053*work.R_rear_axle_aux5_x_x;
  const double s2_437 = 0.15000000000000002*work.R_rear_axle_x_z + s2_436;
  const double s2_438 = 0.6*work.R_rear_axle_y_y;
  const double s2_439 = 0.35000000000000053*work.R_rear_axle_aux5_y_x;
  const double s2_440 = 0.15000000000000002*work.R_rear_axle_y_z + s2_439;
  const double s2_441 = 0.6*work.R_rear_axle_z_y;
  const double s2_442 = work.r_rear_axle_aux1_x + s2_435 - s2_437;
  const double s2_443 = z_rear_axle_ty + s2_438 - s2_440;
  const double s2_444 = 0.35000000000000053*s1_35 - 0.15000000000000002*work.R_rear_axle_z_z;
  const double s2_445 = work.r_rear_axle_aux3_z + s2_444;
  const double s2_446 = s2_441 + s2_445;
  const double s2_447 = 0.35000000000000053*work.cosines[17] - 3.3000000000000003;
  const double s2_448 = 0.44999999999999996 + 0.35000000000000053*work.sines[17];
  const double s2_449 = s2_447 - s2_442;
  const double s2_450 = 0.6 - s2_443;
  const double s2_451 = s2_446 + s2_448;
  const double s2_452 = 4.472135954999581*s2_449;
  const double s2_453 = 4.472135954999581*s2_450;
  const double J_arb_link_rear_left_rear_axle_tz = 4.472135954999581*s2_451;
  result.Jz[172] = J_arb_link_rear_left_rear_axle_tz;
  const double s2_454 = s2_335 + s2_341*s2_442 - s2_339*s2_446;
  const double s2_455 = 0.44999999999999996 - s2_448;
  const double s2_456 = s2_341*s2_443 - s2_332 - s2_340*s2_446 + zd_arb_rear_left*s2_455;
  const double s2_457 = 3.3000000000000003 + s2_447;
  const double s2_458 = s2_338 + s2_339*s2_443 - s2_340*s2_442 + zd_arb_rear_left*s2_457;
  const double s2_459 = s2_451*J_arb_link_rear_left_rear_axle_tz;
  result.Phi[13] = 0.5*(s2_450*s2_453 - 0.22360679774997888 + s2_459 + s2_449*s2_452);
  const double s2_460 = s2_446*s2_453 + s2_443*J_arb_link_rear_left_rear_axle_tz;
  const double s2_461 = s2_442*J_arb_link_rear_left_rear_axle_tz + s2_446*s2_452;
  const double s2_462 = s2_442*s2_453 - s2_443*s2_452;
  const double s2_463 = s2_359*s2_446 - s2_365 - s2_356*s2_443 - s2_353*s2_442;
  result.Jz[170] = -s2_452;
  result.Jz[171] = -s2_453;
  result.Jz[173] = work.r_rear_axle_aux1_x*s2_453 - s2_462 - z_rear_axle_ty*s2_452;
  const double s2_464 = work.s1_37*s2_453 - R_rear_axle_aux4_x_x*s2_461;
  const double s2_465 = work.b_rear_axle_ry_z*J_arb_link_rear_left_rear_axle_tz;
  result.Jz[174] = s2_464 - R_rear_axle_aux4_y_x*s2_460 + s2_465 + work.s1_36*s2_452;
  const double s2_466 = s1_35*s2_462 - work.R_rear_axle_aux5_y_x*s2_461;
  const double s2_467 = s2_466 + work.R_rear_axle_aux5_x_x*s2_460 - work.b_rear_axle_rx_y*s2_453;
  const double s2_468 = s2_467 + work.b_rear_axle_rx_z*J_arb_link_rear_left_rear_axle_tz;
  result.Jz[175] = s2_468 + work.s1_41*s2_452;
  result.Jz[176] = s2_452*s2_455 + J_arb_link_rear_left_rear_axle_tz*s2_457;
  const double s2_469 = 4.472135954999581*(s2_454*s2_454 + s2_458*s2_458 + s2_456*s2_456);
  const double s2_470 = s2_463 + s2_366*(s2_448 - 0.44999999999999996);
  const double s2_471 = s2_453*(s2_363 + s2_358*s2_446 + s2_352*s2_442 - s2_355*s2_443) - s2_469;
  const double s2_472 = s2_361 + s2_354*s2_443 + s2_357*s2_446 - s2_351*s2_442 + s2_366*s2_457;
  result.c[13] = s2_471 + J_arb_link_rear_left_rear_axle_tz*s2_470 + s2_452*s2_472;
  // long_rod_right
  const double s2_473 = s2_375 - s2_368;
  const double s2_474 = s2_377 - s2_370;
  const double s2_475 = work.r_rear_axle_aux3_z - s2_372 - s2_373;
  const double s2_476 = 1.6 + s2_473;
  const double s2_477 = 0.55 + s2_474;
  const double s2_478 = 0.55 + s2_475;
  const double J_long_rod_right_rear_axle_tx = 1.1757385222540742*s2_476;
  result.Jz[178] = J_long_rod_right_rear_axle_tx;
  const double J_long_rod_right_rear_axle_ty = 1.1757385222540742*s2_477;
  result.Jz[179] = J_long_rod_right_rear_axle_ty;
  const double J_long_rod_right_rear_axle_tz = 1.1757385222540742*s2_478;
  result.Jz[180] = J_long_rod_right_rear_axle_tz;
  const double s2_479 = s2_332 + s2_340*s2_475 - s2_341*s2_474;
  const double s2_480 = s2_335 + s2_341*s2_473 - s2_339*s2_475;
  const double s2_481 = s2_338 + s2_339*s2_474 - s2_340*s2_473;
  const double s2_482 = s2_477*J_long_rod_right_rear_axle_ty - 0.8505292469985963;
  const double s2_483 = s2_482 + s2_478*J_long_rod_right_rear_axle_tz;
  result.Phi[14] = 0.5*(s2_483 + s2_476*J_long_rod_right_rear_axle_tx);
  const double s2_484 = s2_475*J_long_rod_right_rear_axle_ty;
  const double s2_485 = s2_484 - s2_474*J_long_rod_right_rear_axle_tz;
  const double s2_486 = s2_473*J_long_rod_right_rear_axle_tz;
  const double s2_487 = s2_486 - s2_475*J_long_rod_right_rear_axle_tx;
  const double s2_488 = s2_474*J_long_rod_right_rear_axle_tx;
  const double s2_489 = s2_488 - s2_473*J_long_rod_right_rear_axle_ty;
  const double s2_490 = z_rear_axle_ty*J_long_rod_right_rear_axle_tx - s2_489;
  result.Jz[181] = s2_490 - work.r_rear_axle_aux1_x*J_long_rod_right_rear_axle_ty;
  const double s2_491 = R_rear_axle_aux4_y_x*s2_485 - R_rear_axle_aux4_x_x*s2_487;
  const double s2_492 = s2_491 - work.s1_37*J_long_rod_right_rear_axle_ty;
  const double s2_493 = work.b_rear_axle_ry_z*J_long_rod_right_rear_axle_tz;
  result.Jz[182] = s2_492 - work.s1_36*J_long_rod_right_rear_axle_tx + s2_493;
  const double s2_494 = s1_35*s2_489 - work.R_rear_axle_aux5_y_x*s2_487;
  const double s2_495 = s2_494 - work.R_rear_axle_aux5_x_x*s2_485;
  const double s2_496 = work.b_rear_axle_rx_z*J_long_rod_right_rear_axle_tz;
  const double s2_497 = s2_495 - work.s1_41*J_long_rod_right_rear_axle_tx + s2_496;
  result.Jz[183] = s2_497 + work.b_rear_axle_rx_y*J_long_rod_right_rear_axle_ty;
  const double s2_498 = s2_363 + s2_358*s2_475 + s2_352*s2_473 - s2_355*s2_474;
  const double s2_499 = s2_365 + s2_356*s2_474 + s2_353*s2_473 - s2_359*s2_475;
  const double s2_500 = J_long_rod_right_rear_axle_ty*s2_498;
  const double s2_501 = s2_361 + s2_354*s2_474 + s2_357*s2_475 - s2_351*s2_473;
  const double s2_502 = s2_500 + J_long_rod_right_rear_axle_tz*s2_499;
  const double s2_503 = 1.1757385222540742*(s2_480*s2_480 + s2_481*s2_481 + s2_479*s2_479);
  result.c[14] = -(s2_502 + J_long_rod_right_rear_axle_tx*s2_501 + s2_503);
  // diag_rod_right
  const double s2_504 = s2_406 - s2_403;
  const double s2_505 = s2_408 - s2_404;
  const double s2_506 = s2_410 - s2_405;
  const double s2_507 = 1.6999999999999997 + s2_504;
  const double s2_508 = 0.4 + s2_505;
  const double s2_509 = 0.15000000000000002 + s2_506;
  const double J_diag_rod_right_rear_axle_tx = 1.162476387438193*s2_507;
  result.Jz[186] = J_diag_rod_right_rear_axle_tx;
  const double J_diag_rod_right_rear_axle_ty = 1.162476387438193*s2_508;
  result.Jz[187] = J_diag_rod_right_rear_axle_ty;
  const double J_diag_rod_right_rear_axle_tz = 1.162476387438193*s2_509;
  result.Jz[188] = J_diag_rod_right_rear_axle_tz;
  const double s2_510 = s2_332 + s2_340*s2_506 - s2_341*s2_505;
  const double s2_511 = s2_335 + s2_341*s2_504 - s2_339*s2_506;
  const double s2_512 = s2_338 + s2_339*s2_505 - s2_340*s2_504;
  const double s2_513 = s2_508*J_diag_rod_right_rear_axle_ty - 0.8602325267042625;
  const double s2_514 = s2_513 + s2_509*J_diag_rod_right_rear_axle_tz;
  result.Phi[15] = 0.5*(s2_514 + s2_507*J_diag_rod_right_rear_axle_tx);
  const double s2_515 = s2_506*J_diag_rod_right_rear_axle_ty;
  const double s2_516 = s2_515 - s2_505*J_diag_rod_right_rear_axle_tz;
  const double s2_517 = s2_504*J_diag_rod_right_rear_axle_tz;
  const double s2_518 = s2_517 - s2_506*J_diag_rod_right_rear_axle_tx;
  const double s2_519 = s2_505*J_diag_rod_right_rear_axle_tx;
  const double s2_520 = s2_519 - s2_504*J_diag_rod_right_rear_axle_ty;
  const double s2_521 = z_rear_axle_ty*J_diag_rod_right_rear_axle_tx - s2_520;
  result.Jz[189] = s2_521 - work.r_rear_axle_aux1_x*J_diag_rod_right_rear_axle_ty;
  const double s2_522 = R_rear_axle_aux4_y_x*s2_516 - R_rear_axle_aux4_x_x*s2_518;
  const double s2_523 = s2_522 - work.s1_37*J_diag_rod_right_rear_axle_ty;
  const double s2_524 = work.b_rear_axle_ry_z*J_diag_rod_right_rear_axle_tz;
  result.Jz[190] = s2_523 - work.s1_36*J_diag_rod_right_rear_axle_tx + s2_524;
  const double s2_525 = s1_35*s2_520 - work.R_rear_axle_aux5_y_x*s2_518;
  const double s2_526 = s2_525 - work.R_rear_axle_aux5_x_x*s2_516;
  const double s2_527 = work.b_rear_axle_rx_z*J_diag_rod_right_rear_axle_tz;
  const double s2_528 = s2_526 - work.s1_41*J_diag_rod_right_rear_axle_tx + s2_527;
  result.Jz[191] = s2_528 + work.b_rear_axle_rx_y*J_diag_rod_right_rear_axle_ty;
  const double s2_529 = s2_363 + s2_358*s2_506 + s2_352*s2_504 - s2_355*s2_505;
  const double s2_530 = s2_365 + s2_356*s2_505 + s2_353*s2_504 - s2_359*s2_506;
  const double s2_531 = J_diag_rod_right_rear_axle_ty*s2_529;
  const double s2_532 = s2_361 + s2_354*s2_505 + s2_357*s2_506 - s2_351*s2_504;
  const double s2_533 = s2_531 + J_diag_rod_right_rear_axle_tz*s2_530;
  const double s2_534 = 1.162476387438193*(s2_511*s2_511 + s2_512*s2_512 + s2_510*s2_510);
  result.c[15] = -(s2_533 + J_diag_rod_right_rear_axle_tx*s2_532 + s2_534);
  // arb_link_rear_right
  const double s2_535 = work.r_rear_axle_aux1_x - s2_435 - s2_437;
  const double s2_536 = z_rear_axle_ty - s2_438 - s2_440;
  const double s2_537 = s2_445 - s2_441;
  const double s2_538 = 0.35000000000000053*work.cosines[18] - 3.3000000000000003;
  const double s2_539 = 0.44999999999999996 + 0.35000000000000053*work.sines[18];
  const double s2_540 = s2_538 - s2_535;
  const double s2_541 = 0.6 + s2_536;
  const double s2_542 = s2_537 + s2_539;
  const double s2_543 = 4.472135954999581*s2_540;
  const double J_arb_link_rear_right_rear_axle_ty = 4.472135954999581*s2_541;
  result.Jz[195] = J_arb_link_rear_right_rear_axle_ty;
  const double J_arb_link_rear_right_rear_axle_tz = 4.472135954999581*s2_542;
  result.Jz[196] = J_arb_link_rear_right_rear_axle_tz;
  const double s2_544 = s2_335 + s2_341*s2_535 - s2_339*s2_537;
  const double s2_545 = 0.44999999999999996 - s2_539;
  const double s2_546 = s2_341*s2_536 - s2_332 - s2_340*s2_537 + zd_arb_rear_right*s2_545;
  const double s2_547 = 3.3000000000000003 + s2_538;
  const double s2_548 = s2_338 + s2_339*s2_536 - s2_340*s2_535 + zd_arb_rear_right*s2_547;
  const double s2_549 = s2_541*J_arb_link_rear_right_rear_axle_ty - 0.22360679774997888;
  result.Phi[16] = 0.5*(s2_549 + s2_542*J_arb_link_rear_right_rear_axle_tz + s2_540*s2_543);
  const double s2_550 = s2_537*J_arb_link_rear_right_rear_axle_ty;
  const double s2_551 = s2_550 - s2_536*J_arb_link_rear_right_rear_axle_tz;
  const double s2_552 = s2_535*J_arb_link_rear_right_rear_axle_tz + s2_537*s2_543;
  const double s2_553 = s2_536*s2_543 + s2_535*J_arb_link_rear_right_rear_axle_ty;
  const double s2_554 = s2_359*s2_537 - s2_365 - s2_356*s2_536 - s2_353*s2_535;
  result.Jz[194] = -s2_543;
  const double s2_555 = s2_553 - work.r_rear_axle_aux1_x*J_arb_link_rear_right_rear_axle_ty;
  result.Jz[197] = s2_555 - z_rear_axle_ty*s2_543;
  const double s2_556 = R_rear_axle_aux4_y_x*s2_551 - R_rear_axle_aux4_x_x*s2_552;
  const double s2_557 = work.b_rear_axle_ry_z*J_arb_link_rear_right_rear_axle_tz;
  const double s2_558 = s2_556 - work.s1_37*J_arb_link_rear_right_rear_axle_ty + s2_557;
  result.Jz[198] = s2_558 + work.s1_36*s2_543;
  const double s2_559 = work.b_rear_axle_rx_y*J_arb_link_rear_right_rear_axle_ty;
  const double s2_560 = s2_559 - work.R_rear_axle_aux5_y_x*s2_552 - s1_35*s2_553;
  const double s2_561 = work.b_rear_axle_rx_z*J_arb_link_rear_right_rear_axle_tz;
  result.Jz[199] = s2_560 - work.R_rear_axle_aux5_x_x*s2_551 + s2_561 + work.s1_41*s2_543;
  result.Jz[201] = s2_543*s2_545 + J_arb_link_rear_right_rear_axle_tz*s2_547;
  const double s2_562 = s2_554 + s2_367*(s2_539 - 0.44999999999999996);
  const double s2_563 = s2_363 + s2_358*s2_537 + s2_352*s2_535 - s2_355*s2_536;
  const double s2_564 = J_arb_link_rear_right_rear_axle_tz*s2_562;
  const double s2_565 = s2_361 + s2_354*s2_536 + s2_357*s2_537 - s2_351*s2_535 + s2_367*s2_547;
  const double s2_566 = s2_564 - J_arb_link_rear_right_rear_axle_ty*s2_563 + s2_543*s2_565;
  const double s2_567 = 4.472135954999581*(s2_544*s2_544 + s2_548*s2_548 + s2_546*s2_546);
  result.c[16] = s2_566 - s2_567;
  // operations: 782 add, 862 multiply
  result.ct[0] = 0.0;
  result.ct[1] = 0.0;
  result.ct[2] = 0.0;
  result.ct[3] = 0.0;
  result.ct[4] = 0.0;
  result.ct[5] = 0.0;
  result.ct[6] = 0.0;
  result.ct[7] = 0.0;
  result.ct[8] = 0.0;
  result.ct[9] = 0.0;
  result.ct[10] = 0.0;
  result.Jz[0] = 0.0;
  result.Jz[4] = 0.0;
  result.Jz[5] = 0.0;
  result.Jz[6] = 0.0;
  result.Jz[7] = 0.0;
  result.Jz[8] = 0.0;
  result.Jz[9] = 0.0;
  result.Jz[10] = 0.0;
  result.Jz[11] = 0.0;
  result.Jz[12] = 0.0;
  result.Jz[13] = 0.0;
  result.Jz[19] = 0.0;
  result.Jz[20] = 0.0;
  result.Jz[21] = 0.0;
  result.Jz[22] = 0.0;
  result.Jz[23] = 0.0;
  result.Jz[24] = 0.0;
  result.Jz[25] = 0.0;
  result.Jz[26] = 0.0;
  result.Jz[27] = 0.0;
  result.Jz[33] = 0.0;
  result.Jz[34] = 0.0;
  result.Jz[35] = 0.0;
  result.Jz[36] = 0.0;
  result.Jz[37] = 0.0;
  result.Jz[38] = 0.0;
  result.Jz[39] = 0.0;
  result.Jz[40] = 0.0;
  result.Jz[41] = 0.0;
  result.Jz[42] = 0.0;
  result.Jz[43] = 0.0;
  result.Jz[44] = 0.0;
  result.Jz[45] = 0.0;
  result.Jz[46] = 0.0;
  result.Jz[47] = 0.0;
  result.Jz[48] = 0.0;
  result.Jz[52] = 0.0;
  result.Jz[53] = 0.0;
  result.Jz[54] = 0.0;
  result.Jz[55] = 0.0;
  result.Jz[56] = 0.0;
  result.Jz[57] = 0.0;
  result.Jz[58] = 0.0;
  result.Jz[59] = 0.0;
  result.Jz[60] = 0.0;
  result.Jz[61] = 0.0;
  result.Jz[67] = 0.0;
  result.Jz[68] = 0.0;
  result.Jz[69] = 0.0;
  result.Jz[70] = 0.0;
  result.Jz[71] = 0.0;
  result.Jz[72] = 0.0;
  result.Jz[73] = 0.0;
  result.Jz[74] = 0.0;
  result.Jz[75] = 0.0;
  result.Jz[81] = 0.0;
  result.Jz[82] = 0.0;
  result.Jz[83] = 0.0;
  result.Jz[88] = 0.0;
  result.Jz[90] = 0.0;
  result.Jz[91] = 0.0;
  result.Jz[92] = 0.0;
  result.Jz[93] = 0.0;
  result.Jz[94] = 0.0;
  result.Jz[95] = 0.0;
  result.Jz[96] = 0.0;
  result.Jz[97] = 0.0;
  result.Jz[98] = 0.0;
  result.Jz[99] = 0.0;
  result.Jz[100] = 0.0;
  result.Jz[101] = 0.0;
  result.Jz[102] = 0.0;
  result.Jz[103] = 0.0;
  result.Jz[108] = 0.0;
  result.Jz[110] = 0.0;
  result.Jz[111] = 0.0;
  result.Jz[112] = 0.0;
  result.Jz[113] = 0.0;
  result.Jz[114] = 0.0;
  result.Jz[115] = 0.0;
  result.Jz[116] = 0.0;
  result.Jz[117] = 0.0;
  result.Jz[118] = 0.0;
  result.Jz[119] = 0.0;
  result.Jz[120] = 0.0;
  result.Jz[121] = 0.0;
  result.Jz[122] = 0.0;
  result.Jz[123] = 0.0;
  result.Jz[130] = 0.0;
  result.Jz[131] = 0.0;
  result.Jz[132] = 0.0;
  result.Jz[133] = 0.0;
  result.Jz[134] = 0.0;
  result.Jz[135] = 0.0;
  result.Jz[136] = 0.0;
  result.Jz[137] = 0.0;
  result.Jz[138] = 0.0;
  result.Jz[140] = 0.0;
  result.Jz[141] = 0.0;
  result.Jz[142] = 0.0;
  result.Jz[143] = 0.0;
  result.Jz[144] = 0.0;
  result.Jz[145] = 0.0;
  result.Jz[150] = 0.0;
  result.Jz[151] = 0.0;
  result.Jz[152] = 0.0;
  result.ct[11] = 0.0;
  result.ct[12] = 0.0;
  result.ct[13] = 0.0;
  result.ct[14] = 0.0;
  result.ct[15] = 0.0;
  result.ct[16] = 0.0;
  result.Jz[160] = 0.0;
  result.Jz[161] = 0.0;
  result.Jz[168] = 0.0;
  result.Jz[169] = 0.0;
  result.Jz[177] = 0.0;
  result.Jz[184] = 0.0;
  result.Jz[185] = 0.0;
  result.Jz[192] = 0.0;
  result.Jz[193] = 0.0;
  result.Jz[200] = 0.0;
  result.driven_acceleration[Coordinate::chassis_tx] = 0.0;
  result.driven_acceleration[Coordinate::chassis_ty] = 0.0;
  result.driven_acceleration[Coordinate::chassis_tz] = 0.0;
  result.driven_acceleration[Coordinate::chassis_rz] = 0.0;
  result.driven_acceleration[Coordinate::chassis_ry] = 0.0;
  result.driven_acceleration[Coordinate::chassis_rx] = 0.0;
  result.driven_acceleration[Coordinate::lower_arm_left] = 0.0;
  result.driven_acceleration[Coordinate::carrier_left_rz] = 0.0;
  result.driven_acceleration[Coordinate::carrier_left_rx] = 0.0;
  result.driven_acceleration[Coordinate::carrier_left_ry] = 0.0;
  result.driven_acceleration[Coordinate::wheel_front_left] = 0.0;
  result.driven_acceleration[Coordinate::upper_arm_left] = 0.0;
  result.driven_acceleration[Coordinate::arb_front_left] = 0.0;
  result.driven_acceleration[Coordinate::lower_arm_right] = 0.0;
  result.driven_acceleration[Coordinate::carrier_right_rz] = 0.0;
  result.driven_acceleration[Coordinate::carrier_right_rx] = 0.0;
  result.driven_acceleration[Coordinate::carrier_right_ry] = 0.0;
  result.driven_acceleration[Coordinate::wheel_front_right] = 0.0;
  result.driven_acceleration[Coordinate::upper_arm_right] = 0.0;
  result.driven_acceleration[Coordinate::arb_front_right] = 0.0;
  result.driven_acceleration[Coordinate::pitman_arm] = 0.0;
  result.driven_acceleration[Coordinate::bell_crank] = 0.0;
  result.driven_acceleration[Coordinate::rear_axle_tx] = 0.0;
  result.driven_acceleration[Coordinate::rear_axle_ty] = 0.0;
  result.driven_acceleration[Coordinate::rear_axle_tz] = 0.0;
  result.driven_acceleration[Coordinate::rear_axle_rz] = 0.0;
  result.driven_acceleration[Coordinate::rear_axle_ry] = 0.0;
  result.driven_acceleration[Coordinate::rear_axle_rx] = 0.0;
  result.driven_acceleration[Coordinate::wheel_rear_left] = 0.0;
  result.driven_acceleration[Coordinate::arb_rear_left] = 0.0;
  result.driven_acceleration[Coordinate::wheel_rear_right] = 0.0;
  result.driven_acceleration[Coordinate::arb_rear_right] = 0.0;
  result.driven_position[Coordinate::chassis_tx] = 0.0;
  result.driven_position[Coordinate::chassis_ty] = 0.0;
  result.driven_position[Coordinate::chassis_tz] = 0.0;
  result.driven_position[Coordinate::chassis_rz] = 0.0;
  result.driven_position[Coordinate::chassis_ry] = 0.0;
  result.driven_position[Coordinate::chassis_rx] = 0.0;
  result.driven_position[Coordinate::lower_arm_left] = 0.0;
  result.driven_position[Coordinate::carrier_left_rz] = 0.0;
  result.driven_position[Coordinate::carrier_left_rx] = 0.0;
  result.driven_position[Coordinate::carrier_left_ry] = 0.0;
  result.driven_position[Coordinate::wheel_front_left] = 0.0;
  result.driven_position[Coordinate::upper_arm_left] = 0.0;
  result.driven_position[Coordinate::arb_front_left] = 0.0;
  result.driven_position[Coordinate::lower_arm_right] = 0.0;
  result.driven_position[Coordinate::carrier_right_rz] = 0.0;
  result.driven_position[Coordinate::carrier_right_rx] = 0.0;
  result.driven_position[Coordinate::carrier_right_ry] = 0.0;
  result.driven_position[Coordinate::wheel_front_right] = 0.0;
  result.driven_position[Coordinate::upper_arm_right] = 0.0;
  result.driven_position[Coordinate::arb_front_right] = 0.0;
  result.driven_position[Coordinate::pitman_arm] = 0.0;
  result.driven_position[Coordinate::bell_crank] = 0.0;
  result.driven_position[Coordinate::rear_axle_tx] = 0.0;
  result.driven_position[Coordinate::rear_axle_ty] = 0.0;
  result.driven_position[Coordinate::rear_axle_tz] = 0.0;
  result.driven_position[Coordinate::rear_axle_rz] = 0.0;
  result.driven_position[Coordinate::rear_axle_ry] = 0.0;
  result.driven_position[Coordinate::rear_axle_rx] = 0.0;
  result.driven_position[Coordinate::wheel_rear_left] = 0.0;
  result.driven_position[Coordinate::arb_rear_left] = 0.0;
  result.driven_position[Coordinate::wheel_rear_right] = 0.0;
  result.driven_position[Coordinate::arb_rear_right] = 0.0;
  result.driven_velocity[Coordinate::chassis_tx] = 0.0;
  result.driven_velocity[Coordinate::chassis_ty] = 0.0;
  result.driven_velocity[Coordinate::chassis_tz] = 0.0;
  result.driven_velocity[Coordinate::chassis_rz] = 0.0;
  result.driven_velocity[Coordinate::chassis_ry] = 0.0;
  result.driven_velocity[Coordinate::chassis_rx] = 0.0;
  result.driven_velocity[Coordinate::lower_arm_left] = 0.0;
  result.driven_velocity[Coordinate::carrier_left_rz] = 0.0;
  result.driven_velocity[Coordinate::carrier_left_rx] = 0.0;
  result.driven_velocity[Coordinate::carrier_left_ry] = 0.0;
  result.driven_velocity[Coordinate::wheel_front_left] = 0.0;
  result.driven_velocity[Coordinate::upper_arm_left] = 0.0;
  result.driven_velocity[Coordinate::arb_front_left] = 0.0;
  result.driven_velocity[Coordinate::lower_arm_right] = 0.0;
  result.driven_velocity[Coordinate::carrier_right_rz] = 0.0;
  result.driven_velocity[Coordinate::carrier_right_rx] = 0.0;
  result.driven_velocity[Coordinate::carrier_right_ry] = 0.0;
  result.driven_velocity[Coordinate::wheel_front_right] = 0.0;
  result.driven_velocity[Coordinate::upper_arm_right] = 0.0;
  result.driven_velocity[Coordinate::arb_front_right] = 0.0;
  result.driven_velocity[Coordinate::pitman_arm] = 0.0;
  result.driven_velocity[Coordinate::bell_crank] = 0.0;
  result.driven_velocity[Coordinate::rear_axle_tx] = 0.0;
  result.driven_velocity[Coordinate::rear_axle_ty] = 0.0;
  result.driven_velocity[Coordinate::rear_axle_tz] = 0.0;
  result.driven_velocity[Coordinate::rear_axle_rz] = 0.0;
  result.driven_velocity[Coordinate::rear_axle_ry] = 0.0;
  result.driven_velocity[Coordinate::rear_axle_rx] = 0.0;
  result.driven_velocity[Coordinate::wheel_rear_left] = 0.0;
  result.driven_velocity[Coordinate::arb_rear_left] = 0.0;
  result.driven_velocity[Coordinate::wheel_rear_right] = 0.0;
  result.driven_velocity[Coordinate::arb_rear_right] = 0.0;
}

/// Closure equations and their derivatives, for the pivoting factorisation.
void compute_closure_terms(const Parameters& /*parameters*/, const Inputs& /*inputs*/,
    const State& state, ClosureTerms& __restrict result) noexcept {
  ClosureTermsWork work;
  compute_closure_terms_1(state, work, result);
  compute_closure_terms_2(state, work, result);
}

/// Result of compute_chosen_accelerations.
struct ChosenAccelerations {
  double zdd[32];  ///< accelerations
  double xd[1];  ///< rates of the auxiliary states
  double inertia[15];  ///< pivots of the final equations
};

/// Values of compute_chosen_accelerations that cross its parts.
struct ChosenAccelerationsWork {
  double
      sines[22], cosines[22], R_chassis_aux5_x_x, R_chassis_aux5_y_x, R_chassis_z_y, R_chassis_z_z,
      R_chassis_x_y, R_chassis_x_z, R_chassis_y_y, R_chassis_y_z, r_carrier_left_aux1_y,
      r_carrier_left_aux1_z, R_carrier_left_aux1_y_x, R_carrier_left_aux1_z_x, b_carrier_left_rz_x,
      s1_10, s1_11, s1_13, R_carrier_left_aux2_y_y, R_carrier_left_aux2_z_y, b_carrier_left_rx_x,
      b_carrier_left_rx_y, b_carrier_left_rx_z, R_carrier_left_x_x, R_carrier_left_y_x,
      R_carrier_left_z_x, R_carrier_left_x_z, R_carrier_left_y_z, R_carrier_left_z_z,
      b_carrier_left_ry_x, s1_22, b_carrier_left_ry_z, r_wheel_front_left_x, r_wheel_front_left_y,
      r_wheel_front_left_z, b_wheel_front_left_x, s1_30, b_wheel_front_left_z,
      r_carrier_right_aux1_y, s1_34, R_carrier_right_aux1_y_x, R_carrier_right_aux1_z_x,
      b_carrier_right_rz_x, s1_37, s1_38, s1_40, R_carrier_right_aux2_y_y, R_carrier_right_aux2_z_y,
      b_carrier_right_rx_x, s1_44, b_carrier_right_rx_z, R_carrier_right_x_x, R_carrier_right_y_x,
      R_carrier_right_z_x, R_carrier_right_x_z, R_carrier_right_y_z, R_carrier_right_z_z,
      b_carrier_right_ry_x, b_carrier_right_ry_y, b_carrier_right_ry_z, r_wheel_front_right_x,
      r_wheel_front_right_y, r_wheel_front_right_z, b_wheel_front_right_x, s1_56,
      b_wheel_front_right_z, r_rear_axle_aux1_x, r_rear_axle_aux3_z, R_rear_axle_aux5_x_x,
      R_rear_axle_aux5_y_x, s1_59, s1_60, b_rear_axle_ry_z, R_rear_axle_x_y, R_rear_axle_y_y,
      R_rear_axle_z_y, R_rear_axle_x_z, R_rear_axle_y_z, R_rear_axle_z_z, s1_64, b_rear_axle_rx_y,
      b_rear_axle_rx_z, r_wheel_rear_left_x, r_wheel_rear_left_y, r_wheel_rear_left_z,
      b_wheel_rear_left_x, b_wheel_rear_left_y, b_wheel_rear_left_z, r_wheel_rear_right_x,
      r_wheel_rear_right_y, r_wheel_rear_right_z, b_wheel_rear_right_x, b_wheel_rear_right_y,
      b_wheel_rear_right_z, s1_77, s1_79, s1_83, s1_84, s1_85, s1_86, s1_87, s1_88, s1_91, s1_95,
      s1_99, s1_127, s1_129, s1_131, s1_133, s1_135, s1_137, s1_138, s1_139, s1_140, s1_141, s1_142,
      s1_151, s1_153, s1_155, s1_157, s1_159, s1_161, s1_162, s1_163, s1_164, s1_168, s1_169,
      s1_170, s1_171, s1_172, s1_173, s1_175, s1_177, s1_181, s1_182, s1_183, s1_184, s1_185,
      s1_186, s1_187, s1_188, s1_189, s1_190, s1_192, s1_194, s1_197, s1_201, s1_205, s1_206,
      s1_207, s1_208, s1_209, s1_210, s1_211, s1_212, s1_213, s1_214, s1_216, s1_218, s1_222,
      s1_223, s1_224, s1_225, s1_226, s1_227, s1_230, s1_234, s1_237, s1_264, s1_266, s1_268,
      s1_270, s1_272, s1_274, s1_275, s1_276, s1_277, s1_278, s1_279, s1_288, s1_290, s1_292,
      s1_294, s1_296, s1_298, s1_299, s1_300, s1_301, s1_305, s1_306, s1_307, s1_308, s1_309,
      s1_310, s1_312, s1_314, s1_318, s1_319, s1_320, s1_321, s1_322, s1_323, s1_324, s1_325,
      s1_326, s1_327, s1_329, s1_331, s1_334, s1_338, s1_342, s1_343, s1_344, s1_345, s1_346,
      s1_347, s1_348, s1_349, s1_350, s1_351, s1_352, s1_353, s1_357, s1_358, s1_359, s1_360,
      s1_361, s1_362, s1_363, s1_364, s1_365, s1_366, s1_368, s1_370, s1_376, s1_377, s1_378,
      s1_379, s1_380, s1_381, s1_382, s1_383, N_bell_crank_y, s1_384, s1_386, s1_388, s1_390,
      s1_404, s1_406, s1_407, s1_409, s1_411, s1_413, s1_414, s1_415, s1_416, s1_417, s1_418,
      s1_427, s1_429, s1_430, s1_432, s1_434, s1_436, s1_437, s1_438, s1_439, s1_443, s1_444,
      s1_445, s1_446, s1_447, s1_448, s1_449, s1_450, s1_451, s1_453, s1_456, s1_457, s1_458,
      s1_459, s1_460, s1_463, s1_464, s1_465, s1_466, s1_467, s1_468, s1_472, s1_473, s1_474,
      s1_475, s1_476, s1_477, s1_478, s1_479, s1_480, s1_482, s1_485, s1_486, s1_487, s1_488,
      s1_489, s1_492, s1_493, s1_494, s1_497, s1_500, s1_503, s1_505, s1_507, s1_510, s1_515,
      s1_523, s1_525, s1_529, s1_532, s1_534, s1_536, s1_539, s1_544, s1_552, s1_553, s1_554,
      s1_555, s1_556, s1_559, s1_563, s1_564, s1_567, s1_571, s1_573, s1_576, s1_579, s1_584,
      s1_585, s1_588, s1_592, s1_593, s1_597, s1_601, s1_602, s1_604, s1_607, s1_609, s1_610,
      s1_611, s1_614, s1_618, s1_619, s1_623, s1_627, s1_628, s1_637, s1_639, s1_640, s1_643,
      s1_647, s1_648, s1_652, s1_653, s1_658, s1_660, s1_662, s1_665, s1_669, s1_670, s1_674,
      s1_675, s1_683, s1_684, s1_687, s1_688, s1_689, s1_692, s1_696, s1_697, s1_700, s1_701,
      s1_705, s1_706, s1_707, s1_708, s1_709, s1_712, s1_716, s1_717, s1_721, s1_722, s1_723,
      s1_724, s1_725, s1_728, s1_732, s1_733, s1_737, s1_738, s1_739, s1_740, s1_741, s1_742,
      s1_743, s1_746, s1_750, s1_751, s1_754, s1_755, s1_759, s1_760, N_rear_axle_ty_z,
      N_rear_axle_tz_x, N_rear_axle_tx_y, s1_762, s1_764, s1_766, s1_767, s1_768, s1_769, s1_770,
      s1_771, s1_772, s1_773, s1_774, s1_775, s1_776, s1_777, s1_778, s1_779, s1_780, s1_781,
      s1_782, s1_783, s1_784, s1_785, s1_786, s1_787, s1_788, s1_789, s1_790, s1_791, s1_792,
      s1_793, s1_794, s1_795, s1_796, s1_797, s1_798, s1_799, s1_805, F_chassis_rx_z, s1_817,
      N_chassis_rx_x, s1_843, s1_857, N_chassis_rx_y, s1_873, s1_881, N_chassis_rx_z, s1_910,
      N_chassis_rz_x, s1_916, w_chassis_y, w_chassis_z, w_chassis_x, w_lower_arm_left_x,
      w_carrier_left_x, w_carrier_left_y, w_carrier_left_z, w_wheel_front_left_x,
      w_wheel_front_left_y, w_wheel_front_left_z, w_upper_arm_left_x, w_arb_front_left_y,
      w_lower_arm_right_x, w_carrier_right_x, w_carrier_right_y, w_carrier_right_z,
      w_wheel_front_right_x, w_wheel_front_right_y, w_wheel_front_right_z, w_upper_arm_right_x,
      w_arb_front_right_y, w_pitman_arm_y, w_bell_crank_z, w_rear_axle_aux4_z, s4_28, s4_29,
      w_rear_axle_aux5_x, w_rear_axle_aux5_y, s4_30, s4_31, s4_32, w_rear_axle_x, w_rear_axle_y,
      w_rear_axle_z, s4_33, s4_34, s4_35, w_wheel_rear_left_x, w_wheel_rear_left_y,
      w_wheel_rear_left_z, w_arb_rear_left_y, s4_36, s4_37, s4_38, w_wheel_rear_right_x,
      w_wheel_rear_right_y, w_wheel_rear_right_z, w_arb_rear_right_y, s7_1, a_chassis_y,
      a_chassis_z, s7_2, s7_3, s7_4, s7_6, s7_7, s7_8, alpha_chassis_y, s7_9, s7_10, s7_11, s7_12,
      s7_13, s7_14, s7_15, s7_16, s7_17, s7_18, alpha_lower_arm_left_x, alpha_lower_arm_left_y,
      s7_19, s7_23, s7_24, s7_25, s7_26, s7_27, s7_28, s7_29, s7_30, a_lower_arm_left_x,
      a_lower_arm_left_y, a_lower_arm_left_z, alpha_carrier_left_x, alpha_carrier_left_y,
      alpha_carrier_left_z, s7_92, s7_93, s7_94, s7_95, s7_96, s7_97, s7_98, s7_99, s7_100,
      a_carrier_left_x, a_carrier_left_y, a_carrier_left_z, alpha_wheel_front_left_x,
      alpha_wheel_front_left_y, alpha_wheel_front_left_z, s7_116, s7_117, s7_118, s7_119, s7_120,
      s7_121, s7_122, s7_123, s7_124, a_wheel_front_left_x, a_wheel_front_left_y,
      a_wheel_front_left_z, alpha_upper_arm_left_x, alpha_upper_arm_left_y, s7_134, s7_138, s7_139,
      s7_140, s7_141, s7_142, s7_143, s7_144, s7_145, a_upper_arm_left_x, a_upper_arm_left_y,
      a_upper_arm_left_z, alpha_arb_front_left_y, s7_150, alpha_arb_front_left_z, s7_154, s7_155,
      s7_156, s7_157, s7_158, s7_159, s7_160, s7_161, a_arb_front_left_x, a_arb_front_left_y,
      a_arb_front_left_z, alpha_lower_arm_right_x, alpha_lower_arm_right_y, s7_166, s7_170, s7_171,
      s7_172, s7_173, s7_174, s7_175, s7_176, s7_177, s7_179, a_lower_arm_right_y,
      a_lower_arm_right_z, alpha_carrier_right_x, alpha_carrier_right_y, alpha_carrier_right_z,
      s7_240, s7_241, s7_242, s7_243, s7_244, s7_245, s7_246, s7_247, s7_248, a_carrier_right_x,
      a_carrier_right_y, a_carrier_right_z, alpha_wheel_front_right_x, alpha_wheel_front_right_y,
      alpha_wheel_front_right_z, s7_264, s7_265, s7_266, s7_267, s7_268, s7_269, s7_270, s7_271,
      s7_272, a_wheel_front_right_x, a_wheel_front_right_y, a_wheel_front_right_z,
      alpha_upper_arm_right_x, alpha_upper_arm_right_y, s7_282, s7_286, s7_287, s7_288, s7_289,
      s7_290, s7_291, s7_292, s7_293, s7_294, s7_295, a_upper_arm_right_y, a_upper_arm_right_z,
      alpha_arb_front_right_y, s7_298, alpha_arb_front_right_z, s7_302, s7_303, s7_304, s7_305,
      s7_306, s7_307, s7_308, s7_309, a_arb_front_right_x, a_arb_front_right_y, a_arb_front_right_z,
      alpha_pitman_arm_y, s7_314, alpha_pitman_arm_z, s7_318, s7_319, s7_320, s7_321, s7_322,
      s7_323, s7_324, s7_325, a_pitman_arm_x, a_pitman_arm_y, a_pitman_arm_z, alpha_bell_crank_z,
      alpha_bell_crank_x, alpha_bell_crank_y, s7_332, s7_333, s7_334, s7_335, s7_336, s7_337,
      s7_338, s7_339, s7_340, s7_341, s7_342, s7_343, s7_344, alpha_rear_axle_x, alpha_rear_axle_y,
      alpha_rear_axle_z, s7_402, s7_403, s7_404, s7_405, s7_406, s7_407, s7_408, s7_409, s7_410,
      a_rear_axle_x, a_rear_axle_y, a_rear_axle_z, alpha_wheel_rear_left_x, alpha_wheel_rear_left_y,
      alpha_wheel_rear_left_z, s7_426, s7_427, s7_428, s7_429, s7_430, s7_431, s7_432, s7_433,
      s7_434, a_wheel_rear_left_x, a_wheel_rear_left_y, a_wheel_rear_left_z, alpha_arb_rear_left_y,
      s7_444, alpha_arb_rear_left_z, s7_448, s7_449, s7_450, s7_451, s7_452, s7_453, s7_454, s7_455,
      a_arb_rear_left_x, a_arb_rear_left_y, a_arb_rear_left_z, alpha_wheel_rear_right_x,
      alpha_wheel_rear_right_y, alpha_wheel_rear_right_z, s7_470, s7_471, s7_472, s7_473, s7_474,
      s7_475, s7_476, s7_477, s7_478, a_wheel_rear_right_x, a_wheel_rear_right_y,
      a_wheel_rear_right_z, alpha_arb_rear_right_y, s7_488, alpha_arb_rear_right_z, s7_492, s7_493,
      s7_494, s7_495, s7_496, s7_497, s7_498, s7_499, s7_502, a_arb_rear_right_y,
      a_arb_rear_right_z, s7_509, s7_510, s7_511, s7_516, s7_517, s7_518, s7_523, s7_525, s7_527,
      s7_531, s7_532, s7_533, s7_534, s7_535, s7_536, s7_537, s7_538, s7_539, s7_540, s7_541,
      s7_542, s7_543, s7_544, s7_545, s7_549, s7_550, s7_551, s7_553, s7_555, s7_557, s7_562,
      s7_564, s7_566, s7_568, s7_570, s7_572, s7_576, s7_577, s7_578, s7_579, s7_586, s7_587,
      s7_588, s7_592, s7_593, s7_594, s7_602, s7_603, s7_604, s7_608, s7_609, s7_610, s7_615,
      s7_616, s7_617, s7_621, s7_622, s7_623, s7_624, s7_625, s7_626, s7_627, s7_631, s7_632,
      s7_633, s7_634, s7_635, s7_636, s7_640, s7_641, s7_642, s7_646, s7_647, s7_648, s7_652,
      s7_653, s7_654, s7_655, s7_656, s7_660, s7_661, s7_662, s7_663, s7_664, s7_668, s7_669,
      s7_670, s7_672, s7_674, s7_676, s7_683, s7_684, s7_685, s7_700, s7_706, s7_712, s7_716,
      s7_717, s7_718, s7_719, s7_720, s7_723, s7_724, s7_726, s7_728, s7_730, s7_731, s7_732,
      s7_733, s7_735, s7_737, s7_739, s7_740, s7_741, s7_747, s7_751, s7_752, s7_753, s7_754,
      s7_755, s7_808, s7_809, s7_810, s7_811, s7_812, s7_815, s7_820, s7_821, s7_823, s7_825,
      s7_827, s7_829, s7_830, s7_831, s7_837, s7_839, s7_841, s7_842, s7_843, s7_844, s7_845,
      s7_849, s7_851, s7_853, s7_855, s7_856, s7_857, s7_858, s7_864, s7_918, s7_919, s7_921,
      s7_923, s7_925, s7_927, s7_928, s7_929, s7_935, s7_975, s7_976, s7_978, s7_980, s7_982,
      s7_984, s7_985, s7_986, s7_992, Q_arb_rear_right, Q_wheel_rear_right, Q_arb_rear_left,
      Q_wheel_rear_left, s7_1006, s7_1008, s7_1010, s7_1021, s7_1032, s7_1043, Q_rear_axle_rx,
      Q_rear_axle_ry, Q_rear_axle_rz, Q_rear_axle_tz, Q_rear_axle_ty, Q_rear_axle_tx, Q_bell_crank,
      Q_pitman_arm, Q_arb_front_right, Q_upper_arm_right, Q_wheel_front_right, s7_1059, s7_1075,
      s7_1082, Q_carrier_right_ry, Q_carrier_right_rx, Q_carrier_right_rz, s7_1095, s7_1096,
      s7_1098, Q_lower_arm_right, Q_arb_front_left, Q_upper_arm_left, Q_wheel_front_left,
      Q_carrier_left_ry, Q_carrier_left_rx, Q_carrier_left_rz, Q_lower_arm_left, Q_chassis_rx,
      Q_chassis_ry, Q_chassis_rz, Q_chassis_tz, Q_chassis_ty, Q_chassis_tx, N_chassis_tx_x, s8_2,
      N_chassis_ty_x, s8_4, s8_6, N_chassis_tz_x, s8_11, s8_13, s8_15, s8_17, s8_20, s8_23,
      N_chassis_ry_x, s8_26, s8_28, s8_30, s8_32, s8_34, s8_35, F_lower_arm_left_z,
      N_lower_arm_left_x, N_lower_arm_left_y, N_lower_arm_left_z, F_carrier_left_rz_x,
      F_carrier_left_rz_y, F_carrier_left_rz_z, N_carrier_left_rz_x, N_carrier_left_rz_y,
      N_carrier_left_rz_z, F_carrier_left_rx_x, F_carrier_left_rx_y, F_carrier_left_rx_z,
      N_carrier_left_rx_x, N_carrier_left_rx_y, N_carrier_left_rx_z, F_carrier_left_ry_x,
      F_carrier_left_ry_y, F_carrier_left_ry_z, N_carrier_left_ry_x, N_carrier_left_ry_y,
      N_carrier_left_ry_z, s8_71, F_upper_arm_left_z, N_upper_arm_left_x, N_upper_arm_left_y, s8_72,
      F_arb_front_left_x, F_arb_front_left_z, N_arb_front_left_x, N_arb_front_left_y, s8_73,
      F_lower_arm_right_z, N_lower_arm_right_x, N_lower_arm_right_y, N_lower_arm_right_z,
      F_carrier_right_rz_x, F_carrier_right_rz_y, F_carrier_right_rz_z, N_carrier_right_rz_x,
      N_carrier_right_rz_y, N_carrier_right_rz_z, F_carrier_right_rx_x, F_carrier_right_rx_y,
      F_carrier_right_rx_z, N_carrier_right_rx_x, N_carrier_right_rx_y, N_carrier_right_rx_z,
      F_carrier_right_ry_x, F_carrier_right_ry_y, F_carrier_right_ry_z, N_carrier_right_ry_x,
      N_carrier_right_ry_y, N_carrier_right_ry_z, F_upper_arm_right_y, F_upper_arm_right_z,
      N_upper_arm_right_x, s8_106, N_upper_arm_right_z, F_arb_front_right_x, F_arb_front_right_z,
      N_arb_front_right_x, N_arb_front_right_y, N_arb_front_right_z, F_pitman_arm_x, F_pitman_arm_z,
      N_pitman_arm_x, N_pitman_arm_y, N_pitman_arm_z, F_bell_crank_y, N_bell_crank_x,
      N_bell_crank_z, s8_107, s8_109, s8_114, s8_116, s8_121, s8_127, s8_129, s8_134, s8_140,
      s8_146, s8_147, s8_149, s8_151, s8_153, s8_158, s8_160, s8_165, s8_171, s8_173, s8_178,
      s8_184, s8_190, s8_192, s8_194, s8_195, s8_196, s8_215, s8_219, s8_223, s8_227, s8_228,
      s8_229, s8_230, s8_231, s8_232, s8_251, s8_255, s8_259, s8_263, s8_264, s8_265, s8_266,
      s8_267, s8_268, s8_271, s8_272, s8_273, s8_274, s8_275, s8_276, s8_295, s8_296, s8_298,
      s8_299, s8_300, s8_301, s8_305, s8_306, s8_307, s8_309, s8_311, s8_313, s8_314, s8_318,
      s8_319, s8_320, s8_322, s8_324, s8_326, s8_327, s8_331, s8_332, s8_333, s8_335, s8_337,
      s8_339, s8_340, s8_358, s8_359, s8_361, s8_362, s8_363, s8_364, s8_368, s8_369, s8_370,
      s8_372, s8_374, s8_376, s8_377, s8_381, s8_382, s8_383, s8_385, s8_387, s8_389, s8_390,
      s8_394, s8_395, s8_396, s8_398, s8_400, s8_402, s8_403, s8_404, s8_405, s8_407, s8_409,
      s8_412, s8_423, s8_426, s8_429, s8_432, s8_435, s8_436, s8_439, s8_448, s8_469, s8_490,
      s8_491, s8_492, s8_493, s8_495, s8_497, s8_503, s8_504, s8_509, s8_523, s8_585, s8_607,
      s8_608, s8_609, s8_611, s8_613, s8_620, s8_627, s8_641, s8_703, s8_725, s8_726, s8_727,
      s8_729, s8_731, s8_738, s8_745, s8_752, s8_766, N_wheel_front_left_x, s8_785, s8_802, s8_805,
      s8_808, s8_811, s8_814, s8_816, s8_818, s8_820, F_wheel_front_right_x, F_wheel_front_right_y,
      F_wheel_front_right_z, N_wheel_front_right_x, N_wheel_front_right_y, s8_833, s8_839, s8_856,
      s8_859, s8_862, s8_865, s8_868, s8_870, s8_872, s8_874, s8_923, s8_976, s8_977, s8_1013,
      s8_1014, s8_1015, s8_1016, s8_1018, s8_1020, s8_1032, s8_1036, s8_1037, s8_1055, s8_1059,
      s8_1060, s8_1078, s8_1082, s8_1083, s8_1086, s8_1087, s8_1088, s8_1118, s8_1132, s8_1134,
      s8_1135, s8_1137, s8_1139, s8_1149, s8_1157, s8_1161, s8_1164, s8_1167, s8_1171, s8_1175,
      s8_1177, s8_1181, s8_1184, s8_1187, s8_1190, s8_1193, N_wheel_rear_left_x, s8_1268, s8_1271,
      s8_1274, s8_1277, s8_1280, s8_1285, s8_1290, N_wheel_rear_right_x, s8_1322, s8_1325, s8_1328,
      s8_1331, s8_1334, s8_1339, s8_1344, s9_1, s9_2, s9_3, s9_4, s9_5, s9_10, s9_11, s9_12, s9_13,
      s9_14, s9_19, s9_20, s9_21, s9_22, s9_23, s9_25, s9_26, s9_28, s9_29, s9_30, s9_31, s9_32,
      s9_33, s9_37, s9_38, s9_39, s9_40, s9_41, s9_43, s9_46, s9_47, s9_48, s9_49, s9_50, s9_51,
      s9_54, s9_55, s9_56, s9_57, s9_58, s9_64, s9_65, s9_66, s9_67, s9_68, s9_74, s9_75, s9_76,
      s9_77, s9_78, s9_80, s9_81, s9_82, s9_85, s9_86, s9_87, s9_88, s9_89, s9_90, s9_95, s9_96,
      s9_97, s9_98, s9_99, s9_101, s9_102, s9_105, s9_106, s9_107, s9_108, s9_109, s9_110, s9_115,
      s9_117, s9_119, s9_121, s9_123, s9_126, s9_131, s9_132, s9_133, s9_134, s9_135, s9_136,
      s9_142, s9_146, s9_150, s9_154, s9_158, s9_168, s9_169, s9_170, s9_171, s9_172, s9_173,
      s9_178, s9_182, s9_186, s9_190, s9_194, s9_199;
};

/// Part 1 of compute_chosen_accelerations: step 1: poses, axes b, accumulated inertias MR (50).
[[gnu::noinline]] void compute_chosen_accelerations_1(const State& state,
    ChosenAccelerationsWork& __restrict work) noexcept {
  // --- step 1: poses, axes b, accumulated inertias MR (50) ---
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
  const double s1_1 = work.sines[2];
  work.R_chassis_z_y = R_chassis_aux5_z_z*s1_1;
  const double s1_2 = work.cosines[2];
  work.R_chassis_z_z = R_chassis_aux5_z_z*s1_2;
  const double s1_3 = work.sines[1];
  const double s1_4 = s1_3*s1_1;
  const double s1_5 = s1_3*s1_2;
  work.R_chassis_x_y = R_chassis_aux4_x_x*s1_4 - R_chassis_aux4_y_x*s1_2;
  work.R_chassis_x_z = R_chassis_aux4_y_x*s1_1 + R_chassis_aux4_x_x*s1_5;
  work.R_chassis_y_y = R_chassis_aux4_x_x*s1_2 + R_chassis_aux4_y_x*s1_4;
  work.R_chassis_y_z = R_chassis_aux4_y_x*s1_5 - R_chassis_aux4_x_x*s1_1;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s1_6 = 0.4 + 0.44999999999999996*R_lower_arm_left_y_y;
  work.r_carrier_left_aux1_y = s1_6 + 0.04999999999999999*R_lower_arm_left_z_y;
  const double s1_7 = 0.44999999999999996*R_lower_arm_left_z_y - 0.62;
  work.r_carrier_left_aux1_z = s1_7 - 0.04999999999999999*R_lower_arm_left_y_y;
  const double s1_8 = work.sines[4];
  work.R_carrier_left_aux1_y_x = R_lower_arm_left_y_y*s1_8;
  work.R_carrier_left_aux1_z_x = R_lower_arm_left_z_y*s1_8;
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double R_carrier_left_aux1_y_y = R_lower_arm_left_y_y*R_carrier_left_aux1_x_x;
  const double R_carrier_left_aux1_z_y = R_lower_arm_left_z_y*R_carrier_left_aux1_x_x;
  const double s1_9 = R_lower_arm_left_z_y*work.r_carrier_left_aux1_z;
  work.b_carrier_left_rz_x = s1_9 + R_lower_arm_left_y_y*work.r_carrier_left_aux1_y;
  work.s1_10 = 3.6*R_lower_arm_left_y_y;
  work.s1_11 = 3.6*R_lower_arm_left_z_y;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_12 = work.cosines[5];
  work.s1_13 = s1_8*s1_12;
  const double s1_14 = work.sines[5];
  work.R_carrier_left_aux2_y_y = R_carrier_left_aux1_y_y*s1_12 - R_lower_arm_left_z_y*s1_14;
  work.R_carrier_left_aux2_z_y = R_carrier_left_aux1_z_y*s1_12 + R_lower_arm_left_y_y*s1_14;
  const double R_carrier_left_aux2_x_z = s1_8*s1_14;
  const double s1_15 = R_carrier_left_aux1_y_y*s1_14 + R_lower_arm_left_z_y*s1_12;
  const double R_carrier_left_aux2_z_z = R_lower_arm_left_y_y*s1_12 - R_carrier_left_aux1_z_y*s1_14;
  const double s1_16 = work.r_carrier_left_aux1_y*work.R_carrier_left_aux1_z_x;
  work.b_carrier_left_rx_x = s1_16 - work.r_carrier_left_aux1_z*work.R_carrier_left_aux1_y_x;
  const double s1_17 = work.r_carrier_left_aux1_z*R_carrier_left_aux1_x_x;
  work.b_carrier_left_rx_y = s1_17 - 3.6*work.R_carrier_left_aux1_z_x;
  const double s1_18 = work.r_carrier_left_aux1_y*R_carrier_left_aux1_x_x;
  work.b_carrier_left_rx_z = 3.6*work.R_carrier_left_aux1_y_x - s1_18;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_19 = work.cosines[6];
  const double s1_20 = work.sines[6];
  work.R_carrier_left_x_x = R_carrier_left_aux1_x_x*s1_19 - R_carrier_left_aux2_x_z*s1_20;
  work.R_carrier_left_y_x = s1_15*s1_20 + work.R_carrier_left_aux1_y_x*s1_19;
  work.R_carrier_left_z_x = work.R_carrier_left_aux1_z_x*s1_19 - R_carrier_left_aux2_z_z*s1_20;
  work.R_carrier_left_x_z = R_carrier_left_aux2_x_z*s1_19 + R_carrier_left_aux1_x_x*s1_20;
  work.R_carrier_left_y_z = work.R_carrier_left_aux1_y_x*s1_20 - s1_15*s1_19;
  work.R_carrier_left_z_z = R_carrier_left_aux2_z_z*s1_19 + work.R_carrier_left_aux1_z_x*s1_20;
  const double s1_21 = work.r_carrier_left_aux1_y*work.R_carrier_left_aux2_z_y;
  work.b_carrier_left_ry_x = s1_21 - work.r_carrier_left_aux1_z*work.R_carrier_left_aux2_y_y;
  work.s1_22 = 3.6*work.R_carrier_left_aux2_z_y + work.r_carrier_left_aux1_z*work.s1_13;
  work.b_carrier_left_ry_z = work.r_carrier_left_aux1_y*work.s1_13 +
      3.6*work.R_carrier_left_aux2_y_y;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s1_23 = 3.6 + 0.16999999999999998*work.R_carrier_left_x_z;
  work.r_wheel_front_left_x = s1_23 - 0.17499999999999993*work.s1_13;
  const double s1_24 = 0.17499999999999993*work.R_carrier_left_aux2_y_y;
  const double s1_25 = 0.16999999999999998*work.R_carrier_left_y_z;
  work.r_wheel_front_left_y = work.r_carrier_left_aux1_y + s1_24 + s1_25;
  const double s1_26 = 0.17499999999999993*work.R_carrier_left_aux2_z_y;
  const double s1_27 = 0.16999999999999998*work.R_carrier_left_z_z;
  work.r_wheel_front_left_z = work.r_carrier_left_aux1_z + s1_26 + s1_27;
  const double s1_28 = work.R_carrier_left_aux2_z_y*work.r_wheel_front_left_y;
  work.b_wheel_front_left_x = s1_28 - work.R_carrier_left_aux2_y_y*work.r_wheel_front_left_z;
  const double s1_29 = work.R_carrier_left_aux2_z_y*work.r_wheel_front_left_x;
  work.s1_30 = s1_29 + work.s1_13*work.r_wheel_front_left_z;
  const double s1_31 = work.R_carrier_left_aux2_y_y*work.r_wheel_front_left_x;
  work.b_wheel_front_left_z = work.s1_13*work.r_wheel_front_left_y + s1_31;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_z_y = work.sines[9];
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s1_32 = 0.04999999999999999*R_lower_arm_right_z_y - 0.4;
  work.r_carrier_right_aux1_y = s1_32 - 0.44999999999999996*R_lower_arm_right_y_y;
  const double s1_33 = 0.62 + 0.44999999999999996*R_lower_arm_right_z_y;
  work.s1_34 = s1_33 + 0.04999999999999999*R_lower_arm_right_y_y;
  const double s1_35 = work.sines[10];
  work.R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_35;
  work.R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_35;
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  const double s1_36 = R_lower_arm_right_y_y*work.r_carrier_right_aux1_y;
  work.b_carrier_right_rz_x = s1_36 - R_lower_arm_right_z_y*work.s1_34;
  work.s1_37 = 3.6*R_lower_arm_right_y_y;
  work.s1_38 = 3.6*R_lower_arm_right_z_y;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_39 = work.cosines[11];
  work.s1_40 = s1_35*s1_39;
  const double s1_41 = work.sines[11];
  work.R_carrier_right_aux2_y_y = R_carrier_right_aux1_y_y*s1_39 - R_lower_arm_right_z_y*s1_41;
  work.R_carrier_right_aux2_z_y = R_carrier_right_aux1_z_y*s1_39 + R_lower_arm_right_y_y*s1_41;
  const double R_carrier_right_aux2_x_z = s1_35*s1_41;
  const double s1_42 = R_carrier_right_aux1_y_y*s1_41 + R_lower_arm_right_z_y*s1_39;
  const double R_carrier_right_aux2_z_z = R_lower_arm_right_y_y*s1_39 -
      R_carrier_right_aux1_z_y*s1_41;
  const double s1_43 = work.r_carrier_right_aux1_y*work.R_carrier_right_aux1_z_x;
  work.b_carrier_right_rx_x = work.s1_34*work.R_carrier_right_aux1_y_x + s1_43;
  work.s1_44 = 3.6*work.R_carrier_right_aux1_z_x + work.s1_34*R_carrier_right_aux1_x_x;
  const double s1_45 = work.r_carrier_right_aux1_y*R_carrier_right_aux1_x_x;
  work.b_carrier_right_rx_z = 3.6*work.R_carrier_right_aux1_y_x - s1_45;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_46 = work.cosines[12];
  const double s1_47 = work.sines[12];
  work.R_carrier_right_x_x = R_carrier_right_aux1_x_x*s1_46 - R_carrier_right_aux2_x_z*s1_47;
  work.R_carrier_right_y_x = s1_42*s1_47 + work.R_carrier_right_aux1_y_x*s1_46;
  work.R_carrier_right_z_x = work.R_carrier_right_aux1_z_x*s1_46 - R_carrier_right_aux2_z_z*s1_47;
  work.R_carrier_right_x_z = R_carrier_right_aux2_x_z*s1_46 + R_carrier_right_aux1_x_x*s1_47;
  work.R_carrier_right_y_z = work.R_carrier_right_aux1_y_x*s1_47 - s1_42*s1_46;
  work.R_carrier_right_z_z = R_carrier_right_aux2_z_z*s1_46 + work.R_carrier_right_aux1_z_x*s1_47;
  const double s1_48 = work.r_carrier_right_aux1_y*work.R_carrier_right_aux2_z_y;
  work.b_carrier_right_ry_x = work.s1_34*work.R_carrier_right_aux2_y_y + s1_48;
  work.b_carrier_right_ry_y = work.s1_34*work.s1_40 - 3.6*work.R_carrier_right_aux2_z_y;
  const double s1_49 = work.r_carrier_right_aux1_y*work.s1_40;
  work.b_carrier_right_ry_z = s1_49 + 3.6*work.R_carrier_right_aux2_y_y;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s1_50 = 0.16999999999999998*work.R_carrier_right_x_z;
  work.r_wheel_front_right_x = 3.6 + 0.17499999999999993*work.s1_40 + s1_50;
  const double s1_51 = 0.16999999999999998*work.R_carrier_right_y_z;
  const double s1_52 = 0.17499999999999993*work.R_carrier_right_aux2_y_y;
  work.r_wheel_front_right_y = work.r_carrier_right_aux1_y + s1_51 - s1_52;
  const double s1_53 = 0.16999999999999998*work.R_carrier_right_z_z - work.s1_34;
  work.r_wheel_front_right_z = s1_53 - 0.17499999999999993*work.R_carrier_right_aux2_z_y;
  const double s1_54 = work.R_carrier_right_aux2_z_y*work.r_wheel_front_right_y;
  work.b_wheel_front_right_x = s1_54 - work.R_carrier_right_aux2_y_y*work.r_wheel_front_right_z;
  const double s1_55 = work.R_carrier_right_aux2_z_y*work.r_wheel_front_right_x;
  work.s1_56 = s1_55 + work.s1_40*work.r_wheel_front_right_z;
  const double s1_57 = work.R_carrier_right_aux2_y_y*work.r_wheel_front_right_x;
  work.b_wheel_front_right_z = work.s1_40*work.r_wheel_front_right_y + s1_57;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - 2.4999999999999996;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  work.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] - 0.5;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double R_rear_axle_aux5_z_z = work.cosines[18];
  work.R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double s1_58 = work.sines[18];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_58;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_58;
  work.s1_59 = work.r_rear_axle_aux3_z*R_rear_axle_aux4_x_x;
  work.s1_60 = work.r_rear_axle_aux3_z*R_rear_axle_aux4_y_x;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s1_61 = work.r_rear_axle_aux1_x*R_rear_axle_aux4_x_x;
  work.b_rear_axle_ry_z = z_rear_axle_ty*R_rear_axle_aux4_y_x + s1_61;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_62 = work.sines[19];
  const double s1_63 = work.cosines[19];
  work.R_rear_axle_x_y = R_rear_axle_aux5_x_z*s1_62 - R_rear_axle_aux4_y_x*s1_63;
  work.R_rear_axle_y_y = R_rear_axle_aux4_x_x*s1_63 + R_rear_axle_aux5_y_z*s1_62;
  work.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_62;
  work.R_rear_axle_x_z = R_rear_axle_aux4_y_x*s1_62 + R_rear_axle_aux5_x_z*s1_63;
  work.R_rear_axle_y_z = R_rear_axle_aux5_y_z*s1_63 - R_rear_axle_aux4_x_x*s1_62;
  work.R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_63;
  work.s1_64 = work.r_rear_axle_aux3_z*work.R_rear_axle_aux5_y_x + z_rear_axle_ty*s1_58;
  const double s1_65 = work.r_rear_axle_aux3_z*work.R_rear_axle_aux5_x_x;
  work.b_rear_axle_rx_y = work.r_rear_axle_aux1_x*s1_58 + s1_65;
  const double s1_66 = work.r_rear_axle_aux1_x*work.R_rear_axle_aux5_y_x;
  work.b_rear_axle_rx_z = s1_66 - z_rear_axle_ty*work.R_rear_axle_aux5_x_x;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s1_67 = 0.93*work.R_rear_axle_x_y;
  const double s1_68 = 0.93*work.R_rear_axle_y_y;
  const double s1_69 = 0.93*work.R_rear_axle_z_y;
  work.r_wheel_rear_left_x = work.r_rear_axle_aux1_x + s1_67;
  work.r_wheel_rear_left_y = z_rear_axle_ty + s1_68;
  work.r_wheel_rear_left_z = work.r_rear_axle_aux3_z + s1_69;
  const double s1_70 = work.R_rear_axle_z_y*work.r_wheel_rear_left_y;
  work.b_wheel_rear_left_x = s1_70 - work.R_rear_axle_y_y*work.r_wheel_rear_left_z;
  const double s1_71 = work.R_rear_axle_x_y*work.r_wheel_rear_left_z;
  work.b_wheel_rear_left_y = s1_71 - work.R_rear_axle_z_y*work.r_wheel_rear_left_x;
  const double s1_72 = work.R_rear_axle_y_y*work.r_wheel_rear_left_x;
  work.b_wheel_rear_left_z = s1_72 - work.R_rear_axle_x_y*work.r_wheel_rear_left_y;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  work.r_wheel_rear_right_x = work.r_rear_axle_aux1_x - s1_67;
  work.r_wheel_rear_right_y = z_rear_axle_ty - s1_68;
  work.r_wheel_rear_right_z = work.r_rear_axle_aux3_z - s1_69;
  const double s1_73 = work.R_rear_axle_z_y*work.r_wheel_rear_right_y;
  work.b_wheel_rear_right_x = s1_73 - work.R_rear_axle_y_y*work.r_wheel_rear_right_z;
  const double s1_74 = work.R_rear_axle_x_y*work.r_wheel_rear_right_z;
  work.b_wheel_rear_right_y = s1_74 - work.R_rear_axle_z_y*work.r_wheel_rear_right_x;
  const double s1_75 = work.R_rear_axle_y_y*work.r_wheel_rear_right_x;
  work.b_wheel_rear_right_z = s1_75 - work.R_rear_axle_x_y*work.r_wheel_rear_right_y;
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s1_76 = 0.4 + 0.21999999999999997*R_lower_arm_left_y_y;
  work.s1_77 = s1_76 + 0.025000000000000022*R_lower_arm_left_z_y;
  const double s1_78 = 0.21999999999999997*R_lower_arm_left_z_y - 0.62;
  work.s1_79 = s1_78 - 0.025000000000000022*R_lower_arm_left_y_y;
  const double s1_80 = 0.25*R_lower_arm_left_z_y;
  const double s1_81 = 0.8*R_lower_arm_left_y_y;
  const double s1_82 = R_lower_arm_left_y_y*(0.25*R_lower_arm_left_y_y);
  work.s1_83 = s1_82 + R_lower_arm_left_z_y*(0.8*R_lower_arm_left_z_y);
  work.s1_84 = R_lower_arm_left_z_y*s1_80 + R_lower_arm_left_y_y*s1_81;
  work.s1_85 = R_lower_arm_left_y_y*s1_80 - R_lower_arm_left_z_y*s1_81;
  work.s1_86 = 25.0*work.s1_77;
  work.s1_87 = 25.0*(work.s1_77*work.s1_77);
  work.s1_88 = 25.0*(work.s1_79*work.s1_79);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_89 = 3.6 + 0.16710914454277284*work.R_carrier_left_x_z;
  const double s1_90 = s1_89 - 0.003952802359882006*work.R_carrier_left_x_x;
  work.s1_91 = s1_90 - 0.07666666666666674*work.s1_13;
  const double s1_92 = 0.07666666666666674*work.R_carrier_left_aux2_y_y;
  const double s1_93 = 0.16710914454277284*work.R_carrier_left_y_z;
  const double s1_94 = 0.003952802359882006*work.R_carrier_left_y_x;
  work.s1_95 = work.r_carrier_left_aux1_y + s1_92 + s1_93 - s1_94;
  const double s1_96 = 0.07666666666666674*work.R_carrier_left_aux2_z_y;
  const double s1_97 = 0.16710914454277284*work.R_carrier_left_z_z;
  const double s1_98 = 0.003952802359882006*work.R_carrier_left_z_x;
  work.s1_99 = work.r_carrier_left_aux1_z + s1_96 + s1_97 - s1_98;
  const double s1_100 = 3.081700098328417*work.R_carrier_left_x_x;
  const double s1_101 = 0.04070875122910521*work.R_carrier_left_x_z;
  const double s1_102 = 0.039511111111111115*work.R_carrier_left_x_z;
  const double s1_103 = 0.05791111111111111*work.R_carrier_left_x_x;
  const double s1_104 = 3.1640788593903637*work.R_carrier_left_x_z;
  const double s1_105 = 0.04070875122910521*work.R_carrier_left_x_x;
  const double s1_106 = 0.04070875122910521*work.R_carrier_left_y_z;
  const double s1_107 = 3.081700098328417*work.R_carrier_left_y_x - s1_106;
  const double s1_108 = s1_107 - 0.05791111111111111*work.R_carrier_left_aux2_y_y;
  const double s1_109 = 2.6532900688298917*work.R_carrier_left_aux2_y_y;
  const double s1_110 = s1_109 - 0.039511111111111115*work.R_carrier_left_y_z;
  const double s1_111 = s1_110 - 0.05791111111111111*work.R_carrier_left_y_x;
  const double s1_112 = 0.04070875122910521*work.R_carrier_left_y_x;
  const double s1_113 = 3.1640788593903637*work.R_carrier_left_y_z - s1_112;
  const double s1_114 = s1_113 - 0.039511111111111115*work.R_carrier_left_aux2_y_y;
  const double s1_115 = 0.04070875122910521*work.R_carrier_left_z_z;
  const double s1_116 = 3.081700098328417*work.R_carrier_left_z_x - s1_115;
  const double s1_117 = s1_116 - 0.05791111111111111*work.R_carrier_left_aux2_z_y;
  const double s1_118 = 2.6532900688298917*work.R_carrier_left_aux2_z_y;
  const double s1_119 = s1_118 - 0.039511111111111115*work.R_carrier_left_z_z;
  const double s1_120 = s1_119 - 0.05791111111111111*work.R_carrier_left_z_x;
  const double s1_121 = 0.04070875122910521*work.R_carrier_left_z_x;
  const double s1_122 = 3.1640788593903637*work.R_carrier_left_z_z - s1_121;
  const double s1_123 = s1_122 - 0.039511111111111115*work.R_carrier_left_aux2_z_y;
  const double s1_124 = 0.039511111111111115*work.s1_13 + s1_104 - s1_105;
  const double s1_125 = work.s1_13*(2.6532900688298917*work.s1_13 + s1_102 + s1_103);
  const double s1_126 = 0.05791111111111111*work.s1_13 + s1_100 - s1_101;
  work.s1_127 = s1_125 + work.R_carrier_left_x_z*s1_124 + work.R_carrier_left_x_x*s1_126;
  const double s1_128 = work.R_carrier_left_aux2_y_y*s1_111 + work.R_carrier_left_y_z*s1_114;
  work.s1_129 = s1_128 + work.R_carrier_left_y_x*s1_108;
  const double s1_130 = work.R_carrier_left_aux2_z_y*s1_120 + work.R_carrier_left_z_z*s1_123;
  work.s1_131 = s1_130 + work.R_carrier_left_z_x*s1_117;
  const double s1_132 = work.R_carrier_left_x_z*s1_114 + work.R_carrier_left_x_x*s1_108;
  work.s1_133 = s1_132 - work.s1_13*s1_111;
  const double s1_134 = work.R_carrier_left_x_z*s1_123 + work.R_carrier_left_x_x*s1_117;
  work.s1_135 = s1_134 - work.s1_13*s1_120;
  const double s1_136 = work.R_carrier_left_aux2_y_y*s1_120 + work.R_carrier_left_y_z*s1_123;
  work.s1_137 = s1_136 + work.R_carrier_left_y_x*s1_117;
  work.s1_138 = 113.0*work.s1_91;
  work.s1_139 = 113.0*work.s1_95;
  work.s1_140 = 113.0*(work.s1_91*work.s1_91);
  work.s1_141 = 113.0*(work.s1_95*work.s1_95);
  work.s1_142 = 113.0*(work.s1_99*work.s1_99);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s1_143 = 6.0*work.R_carrier_left_y_x;
  const double s1_144 = 11.0*work.R_carrier_left_aux2_y_y;
  const double s1_145 = 6.0*work.R_carrier_left_y_z;
  const double s1_146 = 6.0*work.R_carrier_left_z_x;
  const double s1_147 = 11.0*work.R_carrier_left_aux2_z_y;
  const double s1_148 = 6.0*work.R_carrier_left_z_z;
  const double s1_149 = work.R_carrier_left_x_z*(6.0*work.R_carrier_left_x_z);
  const double s1_150 = work.R_carrier_left_x_x*(6.0*work.R_carrier_left_x_x);
  work.s1_151 = work.s1_13*(11.0*work.s1_13) + s1_149 + s1_150;
  const double s1_152 = work.R_carrier_left_aux2_y_y*s1_144 + work.R_carrier_left_y_z*s1_145;
  work.s1_153 = s1_152 + work.R_carrier_left_y_x*s1_143;
  const double s1_154 = work.R_carrier_left_aux2_z_y*s1_147 + work.R_carrier_left_z_z*s1_148;
  work.s1_155 = s1_154 + work.R_carrier_left_z_x*s1_146;
  const double s1_156 = work.R_carrier_left_x_z*s1_145 + work.R_carrier_left_x_x*s1_143;
  work.s1_157 = s1_156 - work.s1_13*s1_144;
  const double s1_158 = work.R_carrier_left_x_z*s1_148 + work.R_carrier_left_x_x*s1_146;
  work.s1_159 = s1_158 - work.s1_13*s1_147;
  const double s1_160 = work.R_carrier_left_aux2_y_y*s1_147 + work.R_carrier_left_y_z*s1_148;
  work.s1_161 = s1_160 + work.R_carrier_left_y_x*s1_146;
  work.s1_162 = 105.0*work.r_wheel_front_left_x;
  work.s1_163 = 105.0*work.r_wheel_front_left_y;
  work.s1_164 = 105.0*work.r_wheel_front_left_z;
  const double s1_165 = 105.0*(work.r_wheel_front_left_x*work.r_wheel_front_left_x);
  const double s1_166 = 105.0*(work.r_wheel_front_left_y*work.r_wheel_front_left_y);
  const double s1_167 = 105.0*(work.r_wheel_front_left_z*work.r_wheel_front_left_z);
  work.s1_168 = s1_166 + (work.s1_151 + s1_167);
  work.s1_169 = s1_165 + (work.s1_153 + s1_167);
  work.s1_170 = s1_165 + (work.s1_155 + s1_166);
  work.s1_171 = work.s1_157 - work.r_wheel_front_left_y*work.s1_162;
  work.s1_172 = work.s1_159 - work.r_wheel_front_left_z*work.s1_162;
  work.s1_173 = work.s1_161 - work.r_wheel_front_left_z*work.s1_163;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double R_upper_arm_left_z_y = work.sines[7];
  const double s1_174 = 0.5 + 0.15000000000000002*R_upper_arm_left_y_y;
  work.s1_175 = s1_174 + 0.010000000000000009*R_upper_arm_left_z_y;
  const double s1_176 = 0.15000000000000002*R_upper_arm_left_z_y - 0.28;
  work.s1_177 = s1_176 - 0.010000000000000009*R_upper_arm_left_y_y;
  const double s1_178 = 0.1*R_upper_arm_left_z_y;
  const double s1_179 = 0.25*R_upper_arm_left_y_y;
  const double s1_180 = R_upper_arm_left_z_y*(0.25*R_upper_arm_left_z_y);
  work.s1_181 = R_upper_arm_left_y_y*(0.1*R_upper_arm_left_y_y) + s1_180;
  work.s1_182 = R_upper_arm_left_z_y*s1_178 + R_upper_arm_left_y_y*s1_179;
  work.s1_183 = R_upper_arm_left_y_y*s1_178 - R_upper_arm_left_z_y*s1_179;
  work.s1_184 = 15.0*work.s1_175;
  work.s1_185 = 15.0*work.s1_177;
  work.s1_186 = 15.0*(work.s1_175*work.s1_175);
  work.s1_187 = 15.0*(work.s1_177*work.s1_177);
  work.s1_188 = 54.0*work.s1_175;
  work.s1_189 = 54.0*work.s1_177;
  work.s1_190 = 0.2 + (work.s1_186 + work.s1_187);
  // arb_front_left: arb_front_left, revolute, chassis
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s1_191 = 3.95 + 0.053846153846153884*R_arb_front_left_x_z;
  work.s1_192 = s1_191 - 0.1392307692307692*R_arb_front_left_x_x;
  const double s1_193 = 0.053846153846153884*R_arb_front_left_x_x - 0.5;
  work.s1_194 = s1_193 + 0.1392307692307692*R_arb_front_left_x_z;
  const double s1_195 = 0.003692307692307688*R_arb_front_left_x_z;
  const double s1_196 = 0.016246153846153844*R_arb_front_left_x_x;
  work.s1_197 = s1_196 - 0.00676923076923076*R_arb_front_left_x_z;
  const double s1_198 = 0.003692307692307688*R_arb_front_left_x_x;
  const double s1_199 = s1_198 - 0.18132307692307692*R_arb_front_left_x_z;
  const double s1_200 = 0.016246153846153844*R_arb_front_left_x_z;
  work.s1_201 = 0.00676923076923076*R_arb_front_left_x_x + s1_200;
  const double s1_202 = 0.23864615384615384*R_arb_front_left_x_x - s1_195;
  const double s1_203 = R_arb_front_left_x_z*(s1_198 + 0.23864615384615384*R_arb_front_left_x_z);
  const double s1_204 = R_arb_front_left_x_x*(s1_195 + 0.18132307692307692*R_arb_front_left_x_x);
  work.s1_205 = s1_203 + s1_204;
  work.s1_206 = R_arb_front_left_x_x*s1_202 - R_arb_front_left_x_z*s1_199;
  work.s1_207 = R_arb_front_left_x_z*s1_202 + R_arb_front_left_x_x*s1_199;
  work.s1_208 = 8.666666666666666*work.s1_192;
  work.s1_209 = 8.666666666666666*work.s1_194;
  work.s1_210 = 8.666666666666666*(work.s1_192*work.s1_192);
  work.s1_211 = 8.666666666666666*(work.s1_194*work.s1_194);
  work.s1_212 = 0.1304 + (work.s1_210 + work.s1_211);
  work.s1_213 = work.s1_197 - 0.5169230769230769*work.s1_208;
  work.s1_214 = work.s1_201 + 4.4799999999999995*work.s1_194;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double s1_215 = 0.025000000000000022*R_lower_arm_right_z_y - 0.4;
  work.s1_216 = s1_215 - 0.21999999999999997*R_lower_arm_right_y_y;
  const double s1_217 = 0.62 + 0.21999999999999997*R_lower_arm_right_z_y;
  work.s1_218 = s1_217 + 0.025000000000000022*R_lower_arm_right_y_y;
  const double s1_219 = 0.25*R_lower_arm_right_z_y;
  const double s1_220 = 0.8*R_lower_arm_right_y_y;
  const double s1_221 = R_lower_arm_right_y_y*(0.25*R_lower_arm_right_y_y);
  work.s1_222 = s1_221 + R_lower_arm_right_z_y*(0.8*R_lower_arm_right_z_y);
  work.s1_223 = R_lower_arm_right_z_y*s1_219 + R_lower_arm_right_y_y*s1_220;
  work.s1_224 = R_lower_arm_right_y_y*s1_219 - R_lower_arm_right_z_y*s1_220;
  work.s1_225 = 25.0*work.s1_216;
  work.s1_226 = 25.0*(work.s1_216*work.s1_216);
  work.s1_227 = 25.0*(work.s1_218*work.s1_218);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_228 = 0.16710914454277284*work.R_carrier_right_x_z;
  const double s1_229 = 3.6 + 0.07666666666666674*work.s1_40 + s1_228;
  work.s1_230 = s1_229 - 0.003952802359882006*work.R_carrier_right_x_x;
  const double s1_231 = 0.16710914454277284*work.R_carrier_right_y_z;
  const double s1_232 = 0.003952802359882006*work.R_carrier_right_y_x;
  const double s1_233 = 0.07666666666666674*work.R_carrier_right_aux2_y_y;
  work.s1_234 = work.r_carrier_right_aux1_y + s1_231 - s1_232 - s1_233;
  const double s1_235 = 0.16710914454277284*work.R_carrier_right_z_z - work.s1_34;
  const double s1_236 = s1_235 - 0.003952802359882006*work.R_carrier_right_z_x;
  work.s1_237 = s1_236 - 0.07666666666666674*work.R_carrier_right_aux2_z_y;
  const double s1_238 = 0.04070875122910521*work.R_carrier_right_x_z;
  const double s1_239 = 3.081700098328417*work.R_carrier_right_x_x - s1_238;
  const double s1_240 = 0.039511111111111115*work.R_carrier_right_x_z;
  const double s1_241 = s1_240 + 0.05791111111111111*work.R_carrier_right_x_x;
  const double s1_242 = 0.04070875122910521*work.R_carrier_right_x_x;
  const double s1_243 = 3.1640788593903637*work.R_carrier_right_x_z - s1_242;
  const double s1_244 = 0.05791111111111111*work.R_carrier_right_aux2_y_y;
  const double s1_245 = s1_244 + 3.081700098328417*work.R_carrier_right_y_x;
  const double s1_246 = s1_245 - 0.04070875122910521*work.R_carrier_right_y_z;
  const double s1_247 = 2.6532900688298917*work.R_carrier_right_aux2_y_y;
  const double s1_248 = s1_247 + 0.039511111111111115*work.R_carrier_right_y_z;
  const double s1_249 = s1_248 + 0.05791111111111111*work.R_carrier_right_y_x;
  const double s1_250 = 0.039511111111111115*work.R_carrier_right_aux2_y_y;
  const double s1_251 = s1_250 + 3.1640788593903637*work.R_carrier_right_y_z;
  const double s1_252 = s1_251 - 0.04070875122910521*work.R_carrier_right_y_x;
  const double s1_253 = 0.05791111111111111*work.R_carrier_right_aux2_z_y;
  const double s1_254 = s1_253 + 3.081700098328417*work.R_carrier_right_z_x;
  const double s1_255 = s1_254 - 0.04070875122910521*work.R_carrier_right_z_z;
  const double s1_256 = 2.6532900688298917*work.R_carrier_right_aux2_z_y;
  const double s1_257 = s1_256 + 0.039511111111111115*work.R_carrier_right_z_z;
  const double s1_258 = s1_257 + 0.05791111111111111*work.R_carrier_right_z_x;
  const double s1_259 = 0.039511111111111115*work.R_carrier_right_aux2_z_y;
  const double s1_260 = s1_259 + 3.1640788593903637*work.R_carrier_right_z_z;
  const double s1_261 = s1_260 - 0.04070875122910521*work.R_carrier_right_z_x;
  const double s1_262 = work.R_carrier_right_x_z*(s1_243 - 0.039511111111111115*work.s1_40);
  const double s1_263 = work.R_carrier_right_x_x*(s1_239 - 0.05791111111111111*work.s1_40);
  work.s1_264 = s1_262 + s1_263 - work.s1_40*(s1_241 - 2.6532900688298917*work.s1_40);
  const double s1_265 = work.R_carrier_right_aux2_y_y*s1_249 + work.R_carrier_right_y_z*s1_252;
  work.s1_266 = s1_265 + work.R_carrier_right_y_x*s1_246;
  const double s1_267 = work.R_carrier_right_aux2_z_y*s1_258 + work.R_carrier_right_z_z*s1_261;
  work.s1_268 = s1_267 + work.R_carrier_right_z_x*s1_255;
  const double s1_269 = work.R_carrier_right_x_z*s1_252 + work.R_carrier_right_x_x*s1_246;
  work.s1_270 = s1_269 - work.s1_40*s1_249;
  const double s1_271 = work.R_carrier_right_x_z*s1_261 + work.R_carrier_right_x_x*s1_255;
  work.s1_272 = s1_271 - work.s1_40*s1_258;
  const double s1_273 = work.R_carrier_right_aux2_y_y*s1_258 + work.R_carrier_right_y_z*s1_261;
  work.s1_274 = s1_273 + work.R_carrier_right_y_x*s1_255;
  work.s1_275 = 113.0*work.s1_230;
  work.s1_276 = 113.0*work.s1_234;
  work.s1_277 = 113.0*(work.s1_230*work.s1_230);
  work.s1_278 = 113.0*(work.s1_234*work.s1_234);
  work.s1_279 = 113.0*(work.s1_237*work.s1_237);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s1_280 = 6.0*work.R_carrier_right_y_x;
  const double s1_281 = 11.0*work.R_carrier_right_aux2_y_y;
  const double s1_282 = 6.0*work.R_carrier_right_y_z;
  const double s1_283 = 6.0*work.R_carrier_right_z_x;
  const double s1_284 = 11.0*work.R_carrier_right_aux2_z_y;
  const double s1_285 = 6.0*work.R_carrier_right_z_z;
  const double s1_286 = work.R_carrier_right_x_z*(6.0*work.R_carrier_right_x_z);
  const double s1_287 = work.R_carrier_right_x_x*(6.0*work.R_carrier_right_x_x);
  work.s1_288 = work.s1_40*(11.0*work.s1_40) + s1_286 + s1_287;
  const double s1_289 = work.R_carrier_right_aux2_y_y*s1_281 + work.R_carrier_right_y_z*s1_282;
  work.s1_290 = s1_289 + work.R_carrier_right_y_x*s1_280;
  const double s1_291 = work.R_carrier_right_aux2_z_y*s1_284 + work.R_carrier_right_z_z*s1_285;
  work.s1_292 = s1_291 + work.R_carrier_right_z_x*s1_283;
  const double s1_293 = work.R_carrier_right_x_z*s1_282 + work.R_carrier_right_x_x*s1_280;
  work.s1_294 = s1_293 - work.s1_40*s1_281;
  const double s1_295 = work.R_carrier_right_x_z*s1_285 + work.R_carrier_right_x_x*s1_283;
  work.s1_296 = s1_295 - work.s1_40*s1_284;
  const double s1_297 = work.R_carrier_right_aux2_y_y*s1_284 + work.R_carrier_right_y_z*s1_285;
  work.s1_298 = s1_297 + work.R_carrier_right_y_x*s1_283;
  work.s1_299 = 105.0*work.r_wheel_front_right_x;
  work.s1_300 = 105.0*work.r_wheel_front_right_y;
  work.s1_301 = 105.0*work.r_wheel_front_right_z;
  const double s1_302 = 105.0*(work.r_wheel_front_right_x*work.r_wheel_front_right_x);
  const double s1_303 = 105.0*(work.r_wheel_front_right_y*work.r_wheel_front_right_y);
  const double s1_304 = 105.0*(work.r_wheel_front_right_z*work.r_wheel_front_right_z);
  work.s1_305 = s1_303 + (work.s1_288 + s1_304);
  work.s1_306 = s1_302 + (work.s1_290 + s1_304);
  work.s1_307 = s1_302 + (work.s1_292 + s1_303);
  work.s1_308 = work.s1_294 - work.r_wheel_front_right_y*work.s1_299;
  work.s1_309 = work.s1_296 - work.r_wheel_front_right_z*work.s1_299;
  work.s1_310 = work.s1_298 - work.r_wheel_front_right_z*work.s1_300;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s1_311 = 0.010000000000000009*R_upper_arm_right_z_y - 0.5;
  work.s1_312 = s1_311 - 0.15000000000000002*R_upper_arm_right_y_y;
  const double s1_313 = 0.28 + 0.15000000000000002*R_upper_arm_right_z_y;
  work.s1_314 = s1_313 + 0.010000000000000009*R_upper_arm_right_y_y;
  const double s1_315 = 0.1*R_upper_arm_right_z_y;
  const double s1_316 = 0.25*R_upper_arm_right_y_y;
  const double s1_317 = R_upper_arm_right_z_y*(0.25*R_upper_arm_right_z_y);
  work.s1_318 = R_upper_arm_right_y_y*(0.1*R_upper_arm_right_y_y) + s1_317;
  work.s1_319 = R_upper_arm_right_z_y*s1_315 + R_upper_arm_right_y_y*s1_316;
  work.s1_320 = R_upper_arm_right_y_y*s1_315 - R_upper_arm_right_z_y*s1_316;
  work.s1_321 = 15.0*work.s1_312;
  work.s1_322 = 15.0*work.s1_314;
  work.s1_323 = 15.0*(work.s1_312*work.s1_312);
  work.s1_324 = 15.0*(work.s1_314*work.s1_314);
  work.s1_325 = 54.0*work.s1_312;
  work.s1_326 = 54.0*work.s1_314;
  work.s1_327 = 0.2 + (work.s1_323 + work.s1_324);
  // arb_front_right: arb_front_right, revolute, chassis
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s1_328 = 3.95 + 0.053846153846153884*R_arb_front_right_x_z;
  work.s1_329 = s1_328 - 0.1392307692307692*R_arb_front_right_x_x;
  const double s1_330 = 0.053846153846153884*R_arb_front_right_x_x - 0.5;
  work.s1_331 = s1_330 + 0.1392307692307692*R_arb_front_right_x_z;
  const double s1_332 = 0.003692307692307688*R_arb_front_right_x_z;
  const double s1_333 = 0.016246153846153844*R_arb_front_right_x_x;
  work.s1_334 = 0.00676923076923076*R_arb_front_right_x_z - s1_333;
  const double s1_335 = 0.003692307692307688*R_arb_front_right_x_x;
  const double s1_336 = s1_335 - 0.18132307692307692*R_arb_front_right_x_z;
  const double s1_337 = 0.016246153846153844*R_arb_front_right_x_z;
  work.s1_338 = 0.00676923076923076*R_arb_front_right_x_x + s1_337;
  const double s1_339 = 0.23864615384615384*R_arb_front_right_x_x - s1_332;
  const double s1_340 = s1_335 + 0.23864615384615384*R_arb_front_right_x_z;
  const double s1_341 = s1_332 + 0.18132307692307692*R_arb_front_right_x_x;
  work.s1_342 = R_arb_front_right_x_z*s1_340 + R_arb_front_right_x_x*s1_341;
  work.s1_343 = R_arb_front_right_x_x*s1_339 - R_arb_front_right_x_z*s1_336;
  work.s1_344 = R_arb_front_right_x_z*s1_339 + R_arb_front_right_x_x*s1_336;
  work.s1_345 = 8.666666666666666*work.s1_329;
  work.s1_346 = 8.666666666666666*work.s1_331;
  work.s1_347 = 8.666666666666666*(work.s1_329*work.s1_329);
  work.s1_348 = 8.666666666666666*(work.s1_331*work.s1_331);
  work.s1_349 = 0.1304 + (work.s1_347 + work.s1_348);
  work.s1_350 = work.s1_334 + 0.5169230769230769*work.s1_345;
  work.s1_351 = work.s1_338 + 4.4799999999999995*work.s1_331;
  // pitman_arm: pitman_arm, revolute, chassis
  const double R_pitman_arm_x_z = work.sines[15];
  work.s1_352 = 4.4 - 0.14666666666666664*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = work.cosines[15];
  work.s1_353 = 0.4 + 0.14666666666666664*R_pitman_arm_x_x;
  const double s1_354 = 0.0742*R_pitman_arm_x_z;
  const double s1_355 = 0.03*R_pitman_arm_x_x;
  const double s1_356 = R_pitman_arm_x_x*(0.0742*R_pitman_arm_x_x);
  work.s1_357 = R_pitman_arm_x_z*(0.03*R_pitman_arm_x_z) + s1_356;
  work.s1_358 = R_pitman_arm_x_x*s1_355 + R_pitman_arm_x_z*s1_354;
  work.s1_359 = R_pitman_arm_x_z*s1_355 - R_pitman_arm_x_x*s1_354;
  work.s1_360 = 9.0*work.s1_352;
  work.s1_361 = 9.0*work.s1_353;
  work.s1_362 = 9.0*(work.s1_352*work.s1_352);
  work.s1_363 = 9.0*(work.s1_353*work.s1_353);
  work.s1_364 = 0.5*work.s1_360;
  work.s1_365 = 4.5*work.s1_353;
  work.s1_366 = 0.0842 + (work.s1_362 + work.s1_363);
  // bell_crank: bell_crank, revolute, chassis
  const double R_bell_crank_x_x = work.cosines[16];
  const double R_bell_crank_y_x = work.sines[16];
  const double s1_367 = 0.09720000000000001*R_bell_crank_x_x;
  work.s1_368 = s1_367 - 0.09380000000000002*R_bell_crank_y_x;
  const double s1_369 = 3.25 - 0.09720000000000001*R_bell_crank_y_x;
  work.s1_370 = s1_369 - 0.09380000000000002*R_bell_crank_x_x;
  const double s1_371 = 0.10155600000000002*R_bell_crank_y_x;
  const double s1_372 = 0.10155600000000002*R_bell_crank_x_x;
  const double s1_373 = 0.2800026666666667*R_bell_crank_y_x - s1_372;
  const double s1_374 = 0.14412600000000006*R_bell_crank_x_x - s1_371;
  const double s1_375 = R_bell_crank_y_x*(s1_372 + 0.14412600000000006*R_bell_crank_y_x);
  work.s1_376 = s1_375 + R_bell_crank_x_x*(s1_371 + 0.2800026666666667*R_bell_crank_x_x);
  work.s1_377 = R_bell_crank_x_x*s1_374 + R_bell_crank_y_x*s1_373;
  work.s1_378 = R_bell_crank_x_x*s1_373 - R_bell_crank_y_x*s1_374;
  work.s1_379 = 16.666666666666668*work.s1_370;
  work.s1_380 = 16.666666666666668*work.s1_368;
  work.s1_381 = 16.666666666666668*(work.s1_370*work.s1_370);
  work.s1_382 = 16.666666666666668*(work.s1_368*work.s1_368);
  work.s1_383 = 0.6*work.s1_379;
  work.N_bell_crank_y = 0.6*work.s1_380;
  work.s1_384 = 0.40412866666666675 + (work.s1_381 + work.s1_382);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_385 = work.r_rear_axle_aux1_x + 0.0019465977605512485*work.R_rear_axle_x_z;
  work.s1_386 = s1_385 + 0.00017226528854435476*work.R_rear_axle_aux5_x_x;
  const double s1_387 = z_rear_axle_ty + 0.0019465977605512485*work.R_rear_axle_y_z;
  work.s1_388 = s1_387 + 0.00017226528854435476*work.R_rear_axle_aux5_y_x;
  const double s1_389 = work.r_rear_axle_aux3_z + 0.0019465977605512485*work.R_rear_axle_z_z;
  work.s1_390 = s1_389 - 0.00017226528854435476*s1_58;
  const double s1_391 = 264.98720045937415*work.R_rear_axle_aux5_x_x;
  const double s1_392 = 0.02174045363192678*work.R_rear_axle_aux5_x_x;
  const double s1_393 = 264.98720045937415*work.R_rear_axle_aux5_y_x;
  const double s1_394 = s1_393 - 0.02174045363192678*work.R_rear_axle_y_z;
  const double s1_395 = 45.96384415733562*work.R_rear_axle_y_y;
  const double s1_396 = 0.02174045363192678*work.R_rear_axle_aux5_y_x;
  const double s1_397 = 264.4099770312949*work.R_rear_axle_y_z - s1_396;
  const double s1_398 = 0.02174045363192678*work.R_rear_axle_z_z + 264.98720045937415*s1_58;
  const double s1_399 = 45.96384415733562*work.R_rear_axle_z_y;
  const double s1_400 = 264.4099770312949*work.R_rear_axle_z_z + 0.02174045363192678*s1_58;
  const double s1_401 = work.R_rear_axle_x_z*(264.4099770312949*work.R_rear_axle_x_z - s1_392);
  const double s1_402 = s1_391 - 0.02174045363192678*work.R_rear_axle_x_z;
  const double s1_403 = work.R_rear_axle_x_y*(45.96384415733562*work.R_rear_axle_x_y) + s1_401;
  work.s1_404 = s1_403 + work.R_rear_axle_aux5_x_x*s1_402;
  const double s1_405 = work.R_rear_axle_y_y*s1_395 + work.R_rear_axle_y_z*s1_397;
  work.s1_406 = s1_405 + work.R_rear_axle_aux5_y_x*s1_394;
  work.s1_407 = work.R_rear_axle_z_y*s1_399 + work.R_rear_axle_z_z*s1_400 + s1_58*s1_398;
  const double s1_408 = work.R_rear_axle_x_y*s1_395 + work.R_rear_axle_x_z*s1_397;
  work.s1_409 = s1_408 + work.R_rear_axle_aux5_x_x*s1_394;
  const double s1_410 = work.R_rear_axle_x_y*s1_399 + work.R_rear_axle_x_z*s1_400;
  work.s1_411 = s1_410 - work.R_rear_axle_aux5_x_x*s1_398;
  const double s1_412 = work.R_rear_axle_y_y*s1_399 + work.R_rear_axle_y_z*s1_400;
  work.s1_413 = s1_412 - work.R_rear_axle_aux5_y_x*s1_398;
  work.s1_414 = 774.0*work.s1_386;
  work.s1_415 = 774.0*work.s1_388;
  work.s1_416 = 774.0*(work.s1_386*work.s1_386);
  work.s1_417 = 774.0*(work.s1_388*work.s1_388);
  work.s1_418 = 774.0*(work.s1_390*work.s1_390);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s1_419 = 14.0*work.R_rear_axle_aux5_y_x;
  const double s1_420 = 22.0*work.R_rear_axle_y_y;
  const double s1_421 = 14.0*work.R_rear_axle_y_z;
  const double s1_422 = 14.0*s1_58;
  const double s1_423 = 22.0*work.R_rear_axle_z_y;
  const double s1_424 = 14.0*work.R_rear_axle_z_z;
  const double s1_425 = work.R_rear_axle_x_y*(22.0*work.R_rear_axle_x_y);
  const double s1_426 = work.R_rear_axle_aux5_x_x*(14.0*work.R_rear_axle_aux5_x_x);
  work.s1_427 = s1_425 + work.R_rear_axle_x_z*(14.0*work.R_rear_axle_x_z) + s1_426;
  const double s1_428 = work.R_rear_axle_y_y*s1_420 + work.R_rear_axle_y_z*s1_421;
  work.s1_429 = s1_428 + work.R_rear_axle_aux5_y_x*s1_419;
  work.s1_430 = work.R_rear_axle_z_y*s1_423 + work.R_rear_axle_z_z*s1_424 + s1_58*s1_422;
  const double s1_431 = work.R_rear_axle_x_y*s1_420 + work.R_rear_axle_x_z*s1_421;
  work.s1_432 = s1_431 + work.R_rear_axle_aux5_x_x*s1_419;
  const double s1_433 = work.R_rear_axle_x_y*s1_423 + work.R_rear_axle_x_z*s1_424;
  work.s1_434 = s1_433 - work.R_rear_axle_aux5_x_x*s1_422;
  const double s1_435 = work.R_rear_axle_y_y*s1_423 + work.R_rear_axle_y_z*s1_424;
  work.s1_436 = s1_435 - work.R_rear_axle_aux5_y_x*s1_422;
  work.s1_437 = 200.0*work.r_wheel_rear_left_x;
}

/// Part 2 of compute_chosen_accelerations: step 1: poses, axes b, accumulated inertias MR (50).
[[gnu::noinline]] void compute_chosen_accelerations_2(const State& state,
    ChosenAccelerationsWork& __restrict work) noexcept {
  // --- step 1: poses, axes b, accumulated inertias MR (50), continued ---
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  work.s1_438 = 200.0*work.r_wheel_rear_left_y;
  work.s1_439 = 200.0*work.r_wheel_rear_left_z;
  const double s1_440 = 200.0*(work.r_wheel_rear_left_x*work.r_wheel_rear_left_x);
  const double s1_441 = 200.0*(work.r_wheel_rear_left_y*work.r_wheel_rear_left_y);
  const double s1_442 = 200.0*(work.r_wheel_rear_left_z*work.r_wheel_rear_left_z);
  work.s1_443 = s1_441 + (work.s1_427 + s1_442);
  work.s1_444 = s1_440 + (work.s1_429 + s1_442);
  work.s1_445 = s1_440 + (work.s1_430 + s1_441);
  work.s1_446 = work.s1_432 - work.r_wheel_rear_left_y*work.s1_437;
  work.s1_447 = work.s1_434 - work.r_wheel_rear_left_z*work.s1_437;
  work.s1_448 = work.s1_436 - work.r_wheel_rear_left_z*work.s1_438;
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double R_arb_rear_left_x_x = work.cosines[20];
  work.s1_449 = 0.16538461538461574*R_arb_rear_left_x_x - 3.3000000000000003;
  const double R_arb_rear_left_x_z = work.sines[20];
  work.s1_450 = 0.44999999999999996 + 0.16538461538461574*R_arb_rear_left_x_z;
  work.s1_451 = 0.012307692307692316*R_arb_rear_left_x_x;
  const double s1_452 = 0.15615384615384614*R_arb_rear_left_x_z;
  work.s1_453 = 0.012307692307692316*R_arb_rear_left_x_z;
  const double s1_454 = 0.23076923076923084*R_arb_rear_left_x_x;
  const double s1_455 = R_arb_rear_left_x_z*(0.23076923076923084*R_arb_rear_left_x_z);
  work.s1_456 = s1_455 + R_arb_rear_left_x_x*(0.15615384615384614*R_arb_rear_left_x_x);
  work.s1_457 = R_arb_rear_left_x_x*s1_454 + R_arb_rear_left_x_z*s1_452;
  work.s1_458 = R_arb_rear_left_x_z*s1_454 - R_arb_rear_left_x_x*s1_452;
  work.s1_459 = 8.666666666666666*work.s1_449;
  work.s1_460 = 8.666666666666666*work.s1_450;
  const double s1_461 = 8.666666666666666*(work.s1_449*work.s1_449);
  const double s1_462 = 8.666666666666666*(work.s1_450*work.s1_450);
  work.s1_463 = 0.14461538461538465 + (s1_461 + s1_462);
  work.s1_464 = work.s1_451 + 0.5076923076923077*work.s1_459;
  work.s1_465 = work.s1_453 + 4.3999999999999995*work.s1_450;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  work.s1_466 = 200.0*work.r_wheel_rear_right_x;
  work.s1_467 = 200.0*work.r_wheel_rear_right_y;
  work.s1_468 = 200.0*work.r_wheel_rear_right_z;
  const double s1_469 = 200.0*(work.r_wheel_rear_right_x*work.r_wheel_rear_right_x);
  const double s1_470 = 200.0*(work.r_wheel_rear_right_y*work.r_wheel_rear_right_y);
  const double s1_471 = 200.0*(work.r_wheel_rear_right_z*work.r_wheel_rear_right_z);
  work.s1_472 = s1_470 + (work.s1_427 + s1_471);
  work.s1_473 = s1_469 + (work.s1_429 + s1_471);
  work.s1_474 = s1_469 + (work.s1_430 + s1_470);
  work.s1_475 = work.s1_432 - work.r_wheel_rear_right_y*work.s1_466;
  work.s1_476 = work.s1_434 - work.r_wheel_rear_right_z*work.s1_466;
  work.s1_477 = work.s1_436 - work.r_wheel_rear_right_z*work.s1_467;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double R_arb_rear_right_x_x = work.cosines[21];
  work.s1_478 = 0.16538461538461574*R_arb_rear_right_x_x - 3.3000000000000003;
  const double R_arb_rear_right_x_z = work.sines[21];
  work.s1_479 = 0.44999999999999996 + 0.16538461538461574*R_arb_rear_right_x_z;
  work.s1_480 = 0.012307692307692316*R_arb_rear_right_x_x;
  const double s1_481 = 0.15615384615384614*R_arb_rear_right_x_z;
  work.s1_482 = 0.012307692307692316*R_arb_rear_right_x_z;
  const double s1_483 = 0.23076923076923084*R_arb_rear_right_x_x;
  const double s1_484 = R_arb_rear_right_x_z*(0.23076923076923084*R_arb_rear_right_x_z);
  work.s1_485 = s1_484 + R_arb_rear_right_x_x*(0.15615384615384614*R_arb_rear_right_x_x);
  work.s1_486 = R_arb_rear_right_x_x*s1_483 + R_arb_rear_right_x_z*s1_481;
  work.s1_487 = R_arb_rear_right_x_z*s1_483 - R_arb_rear_right_x_x*s1_481;
  work.s1_488 = 8.666666666666666*work.s1_478;
  work.s1_489 = 8.666666666666666*work.s1_479;
  const double s1_490 = 8.666666666666666*(work.s1_478*work.s1_478);
  const double s1_491 = 8.666666666666666*(work.s1_479*work.s1_479);
  work.s1_492 = 0.14461538461538465 + (s1_490 + s1_491);
  work.s1_493 = work.s1_480 + 0.5076923076923077*work.s1_488;
  work.s1_494 = work.s1_482 + 4.3999999999999995*work.s1_479;
  // arb_link_front_left
  const double s1_495 = 0.02999999999999997*work.R_carrier_left_x_z;
  const double s1_496 = 3.6 + 0.030000000000000027*work.s1_13 + s1_495;
  work.s1_497 = s1_496 + 0.1*work.R_carrier_left_x_x;
  const double s1_498 = work.r_carrier_left_aux1_y + 0.02999999999999997*work.R_carrier_left_y_z;
  const double s1_499 = 0.030000000000000027*work.R_carrier_left_aux2_y_y;
  work.s1_500 = s1_498 + 0.1*work.R_carrier_left_y_x - s1_499;
  const double s1_501 = work.r_carrier_left_aux1_z + 0.02999999999999997*work.R_carrier_left_z_z;
  const double s1_502 = 0.030000000000000027*work.R_carrier_left_aux2_z_y;
  work.s1_503 = s1_501 + 0.1*work.R_carrier_left_z_x - s1_502;
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s1_504 = 3.95 + 0.09999999999999998*R_arb_front_left_x_z;
  work.s1_505 = s1_504 - 0.24999999999999997*R_arb_front_left_x_x;
  const double s1_506 = 0.09999999999999998*R_arb_front_left_x_x - 0.5;
  work.s1_507 = s1_506 + 0.24999999999999997*R_arb_front_left_x_z;
  const double s1_508 = work.s1_497 + work.s1_505;
  const double s1_509 = 0.72 + work.s1_500;
  work.s1_510 = work.s1_503 + work.s1_507;
  const double s1_511 = 0.3333333333333333*(s1_508*s1_508);
  const double s1_512 = 0.3333333333333333*(s1_509*s1_509);
  const double s1_513 = 0.3333333333333333*(work.s1_510*work.s1_510);
  const double s1_514 = 0.3333333333333333*s1_508;
  work.s1_515 = 0.3333333333333333*s1_509;
  const double s1_516 = 0.3333333333333333*(work.s1_505*work.s1_505);
  const double s1_517 = 0.3333333333333333*(work.s1_507*work.s1_507);
  const double s1_518 = 0.3333333333333333*work.s1_505;
  const double s1_519 = 0.3333333333333333*(work.s1_497*work.s1_497);
  const double s1_520 = 0.3333333333333333*(work.s1_500*work.s1_500);
  const double s1_521 = 0.3333333333333333*(work.s1_503*work.s1_503);
  const double s1_522 = 0.3333333333333333*work.s1_497;
  work.s1_523 = 0.3333333333333333*work.s1_500;
  // arb_link_front_right
  const double s1_524 = 3.6 + 0.02999999999999997*work.R_carrier_right_x_z;
  work.s1_525 = s1_524 + 0.1*work.R_carrier_right_x_x - 0.030000000000000027*work.s1_40;
  const double s1_526 = 0.030000000000000027*work.R_carrier_right_aux2_y_y;
  const double s1_527 = 0.02999999999999997*work.R_carrier_right_y_z;
  const double s1_528 = work.r_carrier_right_aux1_y + s1_526 + s1_527;
  work.s1_529 = s1_528 + 0.1*work.R_carrier_right_y_x;
  const double s1_530 = 0.030000000000000027*work.R_carrier_right_aux2_z_y - work.s1_34;
  const double s1_531 = s1_530 + 0.02999999999999997*work.R_carrier_right_z_z;
  work.s1_532 = s1_531 + 0.1*work.R_carrier_right_z_x;
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s1_533 = 3.95 + 0.09999999999999998*R_arb_front_right_x_z;
  work.s1_534 = s1_533 - 0.24999999999999997*R_arb_front_right_x_x;
  const double s1_535 = 0.09999999999999998*R_arb_front_right_x_x - 0.5;
  work.s1_536 = s1_535 + 0.24999999999999997*R_arb_front_right_x_z;
  const double s1_537 = work.s1_525 + work.s1_534;
  const double s1_538 = work.s1_529 - 0.72;
  work.s1_539 = work.s1_532 + work.s1_536;
  const double s1_540 = 0.3333333333333333*(s1_537*s1_537);
  const double s1_541 = 0.3333333333333333*(s1_538*s1_538);
  const double s1_542 = 0.3333333333333333*(work.s1_539*work.s1_539);
  const double s1_543 = 0.3333333333333333*s1_537;
  work.s1_544 = 0.3333333333333333*s1_538;
  const double s1_545 = 0.3333333333333333*(work.s1_534*work.s1_534);
  const double s1_546 = 0.3333333333333333*(work.s1_536*work.s1_536);
  const double s1_547 = 0.3333333333333333*work.s1_534;
  const double s1_548 = 0.3333333333333333*(work.s1_525*work.s1_525);
  const double s1_549 = 0.3333333333333333*(work.s1_529*work.s1_529);
  const double s1_550 = 0.3333333333333333*(work.s1_532*work.s1_532);
  const double s1_551 = 0.3333333333333333*work.s1_525;
  work.s1_552 = 0.3333333333333333*work.s1_529;
  // drag_link
  const double R_bell_crank_x_x = work.cosines[16];
  work.s1_553 = 0.3*R_bell_crank_x_x;
  const double R_bell_crank_y_x = work.sines[16];
  work.s1_554 = 3.25 - 0.3*R_bell_crank_y_x;
  work.s1_555 = 4.4 - 0.21999999999999997*work.sines[15];
  work.s1_556 = 0.4 + 0.21999999999999997*work.cosines[15];
  const double s1_557 = work.s1_554 + work.s1_555;
  const double s1_558 = 0.5 + work.s1_553;
  work.s1_559 = 0.6 + work.s1_556;
  const double s1_560 = 1.5*(s1_557*s1_557);
  const double s1_561 = 1.5*(s1_558*s1_558);
  const double s1_562 = 1.5*(work.s1_559*work.s1_559);
  work.s1_563 = 1.5*s1_557;
  work.s1_564 = 1.5*s1_558;
  const double s1_565 = 1.5*(work.s1_555*work.s1_555);
  const double s1_566 = 1.5*(work.s1_556*work.s1_556);
  work.s1_567 = 1.5*work.s1_555;
  const double s1_568 = 1.5*(work.s1_554*work.s1_554);
  const double s1_569 = 1.5*(work.s1_553*work.s1_553);
  const double s1_570 = 1.5*work.s1_554;
  work.s1_571 = 1.5*work.s1_553;
  // tie_rod_left
  const double s1_572 = 3.6 + 0.04999999999999993*work.s1_13 + 0.07*work.R_carrier_left_x_z;
  work.s1_573 = s1_572 - 0.22*work.R_carrier_left_x_x;
  const double s1_574 = work.r_carrier_left_aux1_y + 0.07*work.R_carrier_left_y_z;
  const double s1_575 = 0.04999999999999993*work.R_carrier_left_aux2_y_y;
  work.s1_576 = s1_574 - 0.22*work.R_carrier_left_y_x - s1_575;
  const double s1_577 = work.r_carrier_left_aux1_z + 0.07*work.R_carrier_left_z_z;
  const double s1_578 = 0.04999999999999993*work.R_carrier_left_aux2_z_y;
  work.s1_579 = s1_577 - 0.22*work.R_carrier_left_z_x - s1_578;
  const double s1_580 = 0.08*R_bell_crank_y_x;
  const double s1_581 = 0.20000000000000007*R_bell_crank_x_x;
  const double s1_582 = 0.08*R_bell_crank_x_x;
  const double s1_583 = 0.20000000000000007*R_bell_crank_y_x;
  work.s1_584 = s1_582 - s1_583;
  work.s1_585 = 3.25 - s1_580 - s1_581;
  const double s1_586 = work.s1_573 + work.s1_585;
  const double s1_587 = work.s1_576 + work.s1_584;
  work.s1_588 = work.s1_579 - 0.6;
  const double s1_589 = 1.1666666666666667*(s1_586*s1_586);
  const double s1_590 = 1.1666666666666667*(s1_587*s1_587);
  const double s1_591 = 1.1666666666666667*(work.s1_588*work.s1_588);
  work.s1_592 = 1.1666666666666667*s1_586;
  work.s1_593 = 1.1666666666666667*s1_587;
  const double s1_594 = 1.1666666666666667*(work.s1_585*work.s1_585);
  const double s1_595 = 1.1666666666666667*(work.s1_584*work.s1_584);
  const double s1_596 = 1.1666666666666667*work.s1_585;
  work.s1_597 = 1.1666666666666667*work.s1_584;
  const double s1_598 = 1.1666666666666667*(work.s1_573*work.s1_573);
  const double s1_599 = 1.1666666666666667*(work.s1_576*work.s1_576);
  const double s1_600 = 1.1666666666666667*(work.s1_579*work.s1_579);
  work.s1_601 = 1.1666666666666667*work.s1_573;
  work.s1_602 = 1.1666666666666667*work.s1_576;
  // tie_rod_right
  const double s1_603 = 3.6 + 0.07*work.R_carrier_right_x_z - 0.22*work.R_carrier_right_x_x;
  work.s1_604 = s1_603 - 0.04999999999999993*work.s1_40;
  const double s1_605 = 0.04999999999999993*work.R_carrier_right_aux2_y_y;
  const double s1_606 = work.r_carrier_right_aux1_y + s1_605 + 0.07*work.R_carrier_right_y_z;
  work.s1_607 = s1_606 - 0.22*work.R_carrier_right_y_x;
  const double s1_608 = 0.04999999999999993*work.R_carrier_right_aux2_z_y - work.s1_34;
  work.s1_609 = s1_608 + 0.07*work.R_carrier_right_z_z - 0.22*work.R_carrier_right_z_x;
  work.s1_610 = s1_582 + s1_583;
  work.s1_611 = 3.25 + (s1_580 - s1_581);
  const double s1_612 = work.s1_604 + work.s1_611;
  const double s1_613 = work.s1_607 - work.s1_610;
  work.s1_614 = work.s1_609 - 0.6;
  const double s1_615 = 1.1666666666666667*(s1_612*s1_612);
  const double s1_616 = 1.1666666666666667*(s1_613*s1_613);
  const double s1_617 = 1.1666666666666667*(work.s1_614*work.s1_614);
  work.s1_618 = 1.1666666666666667*s1_612;
  work.s1_619 = 1.1666666666666667*s1_613;
  const double s1_620 = 1.1666666666666667*(work.s1_611*work.s1_611);
  const double s1_621 = 1.1666666666666667*(work.s1_610*work.s1_610);
  const double s1_622 = 1.1666666666666667*work.s1_611;
  work.s1_623 = 1.1666666666666667*work.s1_610;
  const double s1_624 = 1.1666666666666667*(work.s1_604*work.s1_604);
  const double s1_625 = 1.1666666666666667*(work.s1_607*work.s1_607);
  const double s1_626 = 1.1666666666666667*(work.s1_609*work.s1_609);
  work.s1_627 = 1.1666666666666667*work.s1_604;
  work.s1_628 = 1.1666666666666667*work.s1_607;
  // long_rod_left
  const double s1_629 = 0.55*work.R_rear_axle_x_y;
  const double s1_630 = 0.04999999999999982*work.R_rear_axle_aux5_x_x;
  const double s1_631 = 0.55*work.R_rear_axle_y_y;
  const double s1_632 = 0.04999999999999982*work.R_rear_axle_aux5_y_x;
  const double s1_633 = 0.55*work.R_rear_axle_z_y;
  const double s1_58 = work.sines[18];
  const double s1_634 = 0.08000000000000002*work.R_rear_axle_z_z + 0.04999999999999982*s1_58;
  const double s1_635 = s1_630 - 0.08000000000000002*work.R_rear_axle_x_z;
  const double s1_636 = work.r_rear_axle_aux1_x + s1_635;
  work.s1_637 = s1_629 + s1_636;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s1_638 = z_rear_axle_ty + (s1_632 - 0.08000000000000002*work.R_rear_axle_y_z);
  work.s1_639 = s1_631 + s1_638;
  work.s1_640 = work.r_rear_axle_aux3_z + s1_633 - s1_634;
  const double s1_641 = work.s1_637 - 1.6;
  const double s1_642 = 0.55 + work.s1_639;
  work.s1_643 = work.s1_640 - 0.55;
  const double s1_644 = 3.0*(s1_641*s1_641);
  const double s1_645 = 3.0*(s1_642*s1_642);
  const double s1_646 = 3.0*(work.s1_643*work.s1_643);
  work.s1_647 = 3.0*s1_641;
  work.s1_648 = 3.0*s1_642;
  const double s1_649 = 3.0*(work.s1_637*work.s1_637);
  const double s1_650 = 3.0*(work.s1_639*work.s1_639);
  const double s1_651 = 3.0*(work.s1_640*work.s1_640);
  work.s1_652 = 3.0*work.s1_637;
  work.s1_653 = 3.0*work.s1_639;
  // diag_rod_left
  const double s1_654 = 0.1*work.R_rear_axle_x_y;
  const double s1_655 = 0.1*work.R_rear_axle_y_y;
  const double s1_656 = 0.1*work.R_rear_axle_z_y;
  const double s1_657 = work.r_rear_axle_aux1_x + 0.25*work.R_rear_axle_x_z;
  work.s1_658 = s1_654 + s1_657;
  const double s1_659 = z_rear_axle_ty + 0.25*work.R_rear_axle_y_z;
  work.s1_660 = s1_655 + s1_659;
  const double s1_661 = work.r_rear_axle_aux3_z + 0.25*work.R_rear_axle_z_z;
  work.s1_662 = s1_656 + s1_661;
  const double s1_663 = work.s1_658 - 1.6999999999999997;
  const double s1_664 = 0.4 + work.s1_660;
  work.s1_665 = work.s1_662 - 0.15000000000000002;
  const double s1_666 = 2.6666666666666665*(s1_663*s1_663);
  const double s1_667 = 2.6666666666666665*(s1_664*s1_664);
  const double s1_668 = 2.6666666666666665*(work.s1_665*work.s1_665);
  work.s1_669 = 2.6666666666666665*s1_663;
  work.s1_670 = 2.6666666666666665*s1_664;
  const double s1_671 = 2.6666666666666665*(work.s1_658*work.s1_658);
  const double s1_672 = 2.6666666666666665*(work.s1_660*work.s1_660);
  const double s1_673 = 2.6666666666666665*(work.s1_662*work.s1_662);
  work.s1_674 = 2.6666666666666665*work.s1_658;
  work.s1_675 = 2.6666666666666665*work.s1_660;
  // arb_link_rear_left
  const double s1_676 = 0.6*work.R_rear_axle_x_y;
  const double s1_677 = 0.35000000000000053*work.R_rear_axle_aux5_x_x;
  const double s1_678 = 0.15000000000000002*work.R_rear_axle_x_z + s1_677;
  const double s1_679 = 0.6*work.R_rear_axle_y_y;
  const double s1_680 = 0.35000000000000053*work.R_rear_axle_aux5_y_x;
  const double s1_681 = 0.15000000000000002*work.R_rear_axle_y_z + s1_680;
  const double s1_682 = 0.6*work.R_rear_axle_z_y;
  work.s1_683 = work.r_rear_axle_aux1_x + s1_676 - s1_678;
  work.s1_684 = z_rear_axle_ty + s1_679 - s1_681;
  const double s1_685 = 0.35000000000000053*s1_58 - 0.15000000000000002*work.R_rear_axle_z_z;
  const double s1_686 = work.r_rear_axle_aux3_z + s1_685;
  work.s1_687 = s1_682 + s1_686;
  work.s1_688 = 0.35000000000000053*R_arb_rear_left_x_x - 3.3000000000000003;
  work.s1_689 = 0.44999999999999996 + 0.35000000000000053*R_arb_rear_left_x_z;
  const double s1_690 = work.s1_683 + work.s1_688;
  const double s1_691 = 0.6 + work.s1_684;
  work.s1_692 = work.s1_687 - work.s1_689;
  const double s1_693 = 0.3333333333333333*(s1_690*s1_690);
  const double s1_694 = 0.3333333333333333*(s1_691*s1_691);
  const double s1_695 = 0.3333333333333333*(work.s1_692*work.s1_692);
  work.s1_696 = 0.3333333333333333*s1_690;
  work.s1_697 = 0.3333333333333333*s1_691;
  const double s1_698 = 0.3333333333333333*(work.s1_688*work.s1_688);
  const double s1_699 = 0.3333333333333333*(work.s1_689*work.s1_689);
  work.s1_700 = 0.3333333333333333*work.s1_688;
  work.s1_701 = 0.3333333333333333*work.s1_689;
  const double s1_702 = 0.3333333333333333*(work.s1_683*work.s1_683);
  const double s1_703 = 0.3333333333333333*(work.s1_684*work.s1_684);
  const double s1_704 = 0.3333333333333333*(work.s1_687*work.s1_687);
  work.s1_705 = 0.3333333333333333*work.s1_683;
  work.s1_706 = 0.3333333333333333*work.s1_684;
  // long_rod_right
  work.s1_707 = s1_636 - s1_629;
  work.s1_708 = s1_638 - s1_631;
  work.s1_709 = work.r_rear_axle_aux3_z - s1_633 - s1_634;
  const double s1_710 = work.s1_707 - 1.6;
  const double s1_711 = work.s1_708 - 0.55;
  work.s1_712 = work.s1_709 - 0.55;
  const double s1_713 = 3.0*(s1_710*s1_710);
  const double s1_714 = 3.0*(s1_711*s1_711);
  const double s1_715 = 3.0*(work.s1_712*work.s1_712);
  work.s1_716 = 3.0*s1_710;
  work.s1_717 = 3.0*s1_711;
  const double s1_718 = 3.0*(work.s1_707*work.s1_707);
  const double s1_719 = 3.0*(work.s1_708*work.s1_708);
  const double s1_720 = 3.0*(work.s1_709*work.s1_709);
  work.s1_721 = 3.0*work.s1_707;
  work.s1_722 = 3.0*work.s1_708;
  // diag_rod_right
  work.s1_723 = s1_657 - s1_654;
  work.s1_724 = s1_659 - s1_655;
  work.s1_725 = s1_661 - s1_656;
  const double s1_726 = work.s1_723 - 1.6999999999999997;
  const double s1_727 = work.s1_724 - 0.4;
  work.s1_728 = work.s1_725 - 0.15000000000000002;
  const double s1_729 = 2.6666666666666665*(s1_726*s1_726);
  const double s1_730 = 2.6666666666666665*(s1_727*s1_727);
  const double s1_731 = 2.6666666666666665*(work.s1_728*work.s1_728);
  work.s1_732 = 2.6666666666666665*s1_726;
  work.s1_733 = 2.6666666666666665*s1_727;
  const double s1_734 = 2.6666666666666665*(work.s1_723*work.s1_723);
  const double s1_735 = 2.6666666666666665*(work.s1_724*work.s1_724);
  const double s1_736 = 2.6666666666666665*(work.s1_725*work.s1_725);
  work.s1_737 = 2.6666666666666665*work.s1_723;
  work.s1_738 = 2.6666666666666665*work.s1_724;
  // arb_link_rear_right
  work.s1_739 = work.r_rear_axle_aux1_x - s1_676 - s1_678;
  work.s1_740 = z_rear_axle_ty - s1_679 - s1_681;
  work.s1_741 = s1_686 - s1_682;
  work.s1_742 = 0.35000000000000053*R_arb_rear_right_x_x - 3.3000000000000003;
  work.s1_743 = 0.44999999999999996 + 0.35000000000000053*R_arb_rear_right_x_z;
  const double s1_744 = work.s1_739 + work.s1_742;
  const double s1_745 = work.s1_740 - 0.6;
  work.s1_746 = work.s1_741 - work.s1_743;
  const double s1_747 = 0.3333333333333333*(s1_744*s1_744);
  const double s1_748 = 0.3333333333333333*(s1_745*s1_745);
  const double s1_749 = 0.3333333333333333*(work.s1_746*work.s1_746);
  work.s1_750 = 0.3333333333333333*s1_744;
  work.s1_751 = 0.3333333333333333*s1_745;
  const double s1_752 = 0.3333333333333333*(work.s1_742*work.s1_742);
  const double s1_753 = 0.3333333333333333*(work.s1_743*work.s1_743);
  work.s1_754 = 0.3333333333333333*work.s1_742;
  work.s1_755 = 0.3333333333333333*work.s1_743;
  const double s1_756 = 0.3333333333333333*(work.s1_739*work.s1_739);
  const double s1_757 = 0.3333333333333333*(work.s1_740*work.s1_740);
  const double s1_758 = 0.3333333333333333*(work.s1_741*work.s1_741);
  work.s1_759 = 0.3333333333333333*work.s1_739;
  work.s1_760 = 0.3333333333333333*work.s1_740;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  work.N_rear_axle_ty_z = work.s1_437 + (work.s1_414 + work.s1_466);
  work.N_rear_axle_tz_x = work.s1_438 + (work.s1_415 + work.s1_467);
  work.N_rear_axle_tx_y = work.s1_439 + work.s1_468 + 774.0*work.s1_390;
  const double s1_761 = work.s1_404 + (work.s1_417 + (work.s1_418 + work.s1_472));
  work.s1_762 = work.s1_443 + s1_761;
  const double s1_763 = work.s1_406 + (work.s1_416 + (work.s1_418 + work.s1_473));
  work.s1_764 = work.s1_444 + s1_763;
  const double s1_765 = work.s1_407 + (work.s1_416 + (work.s1_417 + work.s1_474));
  work.s1_766 = work.s1_445 + s1_765;
  work.s1_767 = work.s1_446 + (work.s1_409 + work.s1_475) - work.s1_388*work.s1_414;
  work.s1_768 = work.s1_447 + (work.s1_411 + work.s1_476) - work.s1_390*work.s1_414;
  work.s1_769 = work.s1_448 + (work.s1_413 + work.s1_477) - work.s1_390*work.s1_415;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  work.s1_770 = work.s1_275 + work.s1_299;
  work.s1_771 = work.s1_276 + work.s1_300;
  work.s1_772 = work.s1_301 + 113.0*work.s1_237;
  work.s1_773 = work.s1_278 + (work.s1_264 + (work.s1_279 + work.s1_305));
  work.s1_774 = work.s1_277 + (work.s1_266 + (work.s1_279 + work.s1_306));
  work.s1_775 = work.s1_277 + (work.s1_268 + (work.s1_278 + work.s1_307));
  work.s1_776 = work.s1_270 + work.s1_308 - work.s1_234*work.s1_275;
  work.s1_777 = work.s1_272 + work.s1_309 - work.s1_237*work.s1_275;
  work.s1_778 = work.s1_274 + work.s1_310 - work.s1_237*work.s1_276;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  work.s1_779 = 90.0 + work.s1_770;
  work.s1_780 = work.s1_225 + work.s1_771;
  work.s1_781 = work.s1_772 - 25.0*work.s1_218;
  work.s1_782 = 0.6 + (work.s1_227 + (work.s1_226 + work.s1_773));
  work.s1_783 = work.s1_776 - 90.0*work.s1_216;
  work.s1_784 = work.s1_777 + 90.0*work.s1_218;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  work.s1_785 = work.s1_138 + work.s1_162;
  work.s1_786 = work.s1_139 + work.s1_163;
  work.s1_787 = work.s1_164 + 113.0*work.s1_99;
  work.s1_788 = work.s1_141 + (work.s1_127 + (work.s1_142 + work.s1_168));
  work.s1_789 = work.s1_140 + (work.s1_129 + (work.s1_142 + work.s1_169));
  work.s1_790 = work.s1_140 + (work.s1_131 + (work.s1_141 + work.s1_170));
  work.s1_791 = work.s1_133 + work.s1_171 - work.s1_95*work.s1_138;
  work.s1_792 = work.s1_135 + work.s1_172 - work.s1_99*work.s1_138;
  work.s1_793 = work.s1_137 + work.s1_173 - work.s1_99*work.s1_139;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  work.s1_794 = 90.0 + work.s1_785;
  work.s1_795 = work.s1_86 + work.s1_786;
  work.s1_796 = work.s1_787 + 25.0*work.s1_79;
  work.s1_797 = 0.6 + (work.s1_88 + (work.s1_87 + work.s1_788));
  work.s1_798 = work.s1_791 - 90.0*work.s1_77;
  work.s1_799 = work.s1_792 - 90.0*work.s1_79;
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s1_800 = work.s1_750 + (work.N_rear_axle_ty_z + (work.s1_779 + work.s1_794));
  const double s1_801 = work.s1_669 + (work.s1_696 + (work.s1_716 + (work.s1_732 + s1_800)));
  const double s1_802 = work.s1_563 + (work.s1_592 + (work.s1_618 + (work.s1_647 + s1_801)));
  const double s1_803 = work.s1_459 + (work.s1_488 + (s1_514 + (s1_543 + s1_802)));
  const double s1_804 = work.s1_345 + (work.s1_208 + (work.s1_360 + (work.s1_379 + s1_803)));
  work.s1_805 = 70.66666666666666 + s1_804;
  const double s1_806 = work.s1_751 + (work.N_rear_axle_tz_x + (work.s1_780 + work.s1_795));
  const double s1_807 = work.s1_670 + (work.s1_697 + (work.s1_717 + (work.s1_733 + s1_806)));
  const double s1_808 = work.s1_564 + (work.s1_593 + (work.s1_619 + (work.s1_648 + s1_807)));
  const double s1_809 = work.s1_184 + (work.s1_380 + (work.s1_515 + (work.s1_544 + s1_808)));
  work.F_chassis_rx_z = 4.5 + (work.s1_321 + s1_809);
  const double s1_810 = work.s1_346 + (work.N_rear_axle_tx_y + (work.s1_781 + work.s1_796));
  const double s1_811 = work.s1_209 + (work.s1_185 + s1_810) - work.s1_489 - work.s1_460;
  const double s1_812 = work.s1_539 + (work.s1_510 + (work.s1_692 + work.s1_746));
  const double s1_813 = 3356.8 + (s1_811 - work.s1_361 - work.s1_322) - 1.5*work.s1_559;
  const double s1_814 = 1.1666666666666667*(work.s1_588 + work.s1_614);
  const double s1_815 = s1_813 + 0.3333333333333333*s1_812 + s1_814;
  const double s1_816 = 2.6666666666666665*(work.s1_665 + work.s1_728);
  work.s1_817 = s1_815 + 3.0*(work.s1_643 + work.s1_712) + s1_816;
  const double s1_818 = s1_748 + (s1_749 + (work.s1_762 + (work.s1_782 + work.s1_797)));
  const double s1_819 = s1_694 + (s1_695 + (s1_714 + (s1_715 + (s1_730 + (s1_731 + s1_818)))));
  const double s1_820 = s1_616 + (s1_617 + (s1_645 + (s1_646 + (s1_667 + (s1_668 + s1_819)))));
  const double s1_821 = s1_541 + (s1_542 + (s1_561 + (s1_562 + (s1_590 + (s1_591 + s1_820)))));
  const double s1_822 = s1_462 + (work.s1_485 + (s1_491 + (s1_512 + (s1_513 + s1_821))));
  const double s1_823 = work.s1_363 + (work.s1_376 + (work.s1_382 + (work.s1_456 + s1_822)));
  const double s1_824 = work.s1_327 + (work.s1_342 + (work.s1_348 + (work.s1_357 + s1_823)));
  const double s1_825 = work.s1_205 + (work.s1_190 + (work.s1_211 + s1_824)) - s1_517 - s1_520;
  const double s1_826 = s1_825 - s1_521 - s1_546 - s1_549 - s1_550 - s1_566 - s1_569 - s1_595;
  const double s1_827 = s1_826 - s1_599 - s1_600 - s1_621 - s1_625 - s1_626 - s1_650 - s1_651;
  const double s1_828 = s1_827 - s1_672 - s1_673 - s1_699 - s1_703 - s1_704 - s1_719 - s1_720;
  const double s1_829 = s1_828 - s1_735 - s1_736 - s1_753 - s1_757 - s1_758;
  work.N_chassis_rx_x = 15863.362056410253 + s1_829;
  const double s1_830 = work.s1_227 + (work.s1_774 + (work.s1_83 + (work.s1_88 + work.s1_789)));
  const double s1_831 = s1_731 + (s1_747 + (s1_749 + (work.s1_764 + (work.s1_222 + s1_830))));
  const double s1_832 = s1_668 + (s1_693 + (s1_695 + (s1_713 + (s1_715 + (s1_729 + s1_831)))));
  const double s1_833 = s1_591 + (s1_615 + (s1_617 + (s1_644 + (s1_646 + (s1_666 + s1_832)))));
  const double s1_834 = s1_513 + (s1_540 + (s1_542 + (s1_560 + (s1_562 + (s1_589 + s1_833)))));
  const double s1_835 = work.s1_381 + (work.s1_463 + (work.s1_492 + (s1_511 + s1_834)));
  const double s1_836 = work.s1_324 + (work.s1_349 + (work.s1_366 + (work.s1_377 + s1_835)));
  const double s1_837 = work.s1_187 + (work.s1_181 + (work.s1_212 + (work.s1_318 + s1_836)));
  const double s1_838 = s1_837 - s1_516 - s1_517 - s1_519 - s1_521 - s1_545 - s1_546 - s1_548;
  const double s1_839 = s1_838 - s1_550 - s1_565 - s1_566 - s1_568 - s1_594 - s1_598 - s1_600;
  const double s1_840 = s1_839 - s1_620 - s1_624 - s1_626 - s1_649 - s1_651 - s1_671 - s1_673;
  const double s1_841 = s1_840 - s1_698 - s1_699 - s1_702 - s1_704 - s1_718 - s1_720 - s1_734;
  const double s1_842 = s1_841 - s1_736 - s1_752 - s1_753 - s1_756 - s1_758;
  work.s1_843 = 151917.87833333327 + s1_842;
  const double s1_844 = work.s1_226 + (work.s1_775 + (work.s1_84 + (work.s1_87 + work.s1_790)));
  const double s1_845 = s1_730 + (s1_747 + (s1_748 + (work.s1_766 + (work.s1_223 + s1_844))));
  const double s1_846 = s1_667 + (s1_693 + (s1_694 + (s1_713 + (s1_714 + (s1_729 + s1_845)))));
  const double s1_847 = s1_590 + (s1_615 + (s1_616 + (s1_644 + (s1_645 + (s1_666 + s1_846)))));
  const double s1_848 = s1_512 + (s1_540 + (s1_541 + (s1_560 + (s1_561 + (s1_589 + s1_847)))));
  const double s1_849 = work.s1_457 + (s1_461 + (work.s1_486 + (s1_490 + (s1_511 + s1_848))));
  const double s1_850 = work.s1_347 + (work.s1_358 + (work.s1_362 + (work.s1_384 + s1_849)));
  const double s1_851 = work.s1_210 + (work.s1_319 + (work.s1_323 + (work.s1_343 + s1_850)));
  const double s1_852 = work.s1_186 + (work.s1_182 + (work.s1_206 + s1_851)) - s1_516 - s1_519;
  const double s1_853 = s1_852 - s1_520 - s1_545 - s1_548 - s1_549 - s1_565 - s1_568 - s1_569;
  const double s1_854 = s1_853 - s1_594 - s1_595 - s1_598 - s1_599 - s1_620 - s1_621 - s1_624;
  const double s1_855 = s1_854 - s1_625 - s1_649 - s1_650 - s1_671 - s1_672 - s1_698 - s1_702;
  const double s1_856 = s1_855 - s1_703 - s1_718 - s1_719 - s1_734 - s1_735 - s1_752 - s1_756;
  work.s1_857 = 146080.6303897436 + (s1_856 - s1_757);
  const double s1_858 = work.s1_493 + (work.s1_767 + (work.s1_783 + work.s1_798));
  const double s1_859 = work.s1_350 + (work.s1_213 + (work.s1_378 + s1_858)) - work.s1_464;
  const double s1_860 = s1_859 - work.s1_364 - work.s1_325 - work.s1_188;
  const double s1_861 = s1_860 - work.s1_368*work.s1_379 + work.s1_500*s1_522 - s1_509*s1_514;
  const double s1_862 = s1_861 + work.s1_529*s1_551 - s1_538*s1_543 + 0.5*work.s1_567;
  const double s1_863 = s1_862 + work.s1_553*s1_570 - s1_558*work.s1_563 + work.s1_584*s1_596;
  const double s1_864 = s1_863 + work.s1_576*work.s1_601 - s1_587*work.s1_592;
  const double s1_865 = s1_864 + work.s1_607*work.s1_627 - work.s1_610*s1_622;
  const double s1_866 = s1_865 - s1_613*work.s1_618 + work.s1_639*work.s1_652;
  const double s1_867 = s1_866 - s1_642*work.s1_647 + work.s1_660*work.s1_674;
  const double s1_868 = s1_867 - s1_664*work.s1_669 + work.s1_684*work.s1_705;
  const double s1_869 = s1_868 - s1_691*work.s1_696 + work.s1_708*work.s1_721;
  const double s1_870 = s1_869 - s1_711*work.s1_716 + work.s1_724*work.s1_737;
  const double s1_871 = s1_870 - s1_727*work.s1_732 + work.s1_740*work.s1_759;
  const double s1_872 = s1_871 - s1_745*work.s1_750 + 0.6*(work.s1_700 - work.s1_754);
  work.N_chassis_rx_y = s1_872 + 0.72*(s1_518 - s1_547);
  work.s1_873 = s1_596 + (s1_570 + s1_622);
  const double s1_874 = work.s1_487 + (work.s1_768 + (work.s1_784 + work.s1_799));
  const double s1_875 = work.s1_344 + (work.s1_359 + (work.s1_383 + (work.s1_458 + s1_874)));
  const double s1_876 = work.s1_326 + (work.s1_207 + s1_875) - work.s1_189 - 6.639999999999995;
  const double s1_877 = s1_876 - work.s1_194*work.s1_208 - work.s1_331*work.s1_345;
  const double s1_878 = s1_877 + work.s1_353*work.s1_360 + work.s1_450*work.s1_459;
  const double s1_879 = s1_878 + work.s1_479*work.s1_488 + work.s1_507*s1_518;
  const double s1_880 = s1_879 + work.s1_503*s1_522 - work.s1_510*s1_514 + work.s1_536*s1_547;
  work.s1_881 = s1_880 + work.s1_532*s1_551 - work.s1_539*s1_543;
}

/// Part 3 of compute_chosen_accelerations: step 1: poses, axes b, accumulated inertias MR (50);
/// step 4: velocities Z (36); step 7: accelerations Zdot and accumulated forces QR - PR (51), (52).
[[gnu::noinline]] void compute_chosen_accelerations_3(const State& state,
    const Projection& projection, ChosenAccelerationsWork& __restrict work) noexcept {
  // --- step 1: poses, axes b, accumulated inertias MR (50), continued ---
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s1_882 = work.s1_881 + work.s1_559*work.s1_563 - work.s1_556*work.s1_567;
  const double s1_883 = s1_882 + work.s1_579*work.s1_601 - work.s1_588*work.s1_592;
  const double s1_884 = s1_883 + work.s1_609*work.s1_627 - work.s1_614*work.s1_618;
  const double s1_885 = s1_884 + work.s1_640*work.s1_652 - work.s1_643*work.s1_647;
  const double s1_886 = s1_885 + work.s1_662*work.s1_674 - work.s1_665*work.s1_669;
  const double s1_887 = s1_886 + work.s1_687*work.s1_705 - work.s1_689*work.s1_700;
  const double s1_888 = s1_887 - work.s1_692*work.s1_696 + work.s1_709*work.s1_721;
  const double s1_889 = s1_888 - work.s1_712*work.s1_716 + work.s1_725*work.s1_737;
  const double s1_890 = s1_889 - work.s1_728*work.s1_732 + work.s1_741*work.s1_759;
  const double s1_891 = s1_890 - work.s1_743*work.s1_754 - work.s1_746*work.s1_750;
  work.N_chassis_rx_z = s1_891 - 0.6*work.s1_873;
  const double s1_892 = work.s1_769 + (work.s1_224 + (work.s1_778 + (work.s1_85 + work.s1_793)));
  const double s1_893 = work.s1_365 + (work.N_bell_crank_y + (work.s1_465 + s1_892));
  const double s1_894 = work.s1_320 + (work.s1_183 + (work.s1_351 + s1_893)) - work.s1_494;
  const double s1_895 = s1_894 - work.s1_214 - work.s1_177*work.s1_184 + work.s1_314*work.s1_321;
  const double s1_896 = s1_895 + work.s1_503*work.s1_523 - work.s1_510*work.s1_515;
  const double s1_897 = s1_896 + work.s1_532*work.s1_552 - work.s1_539*work.s1_544;
  const double s1_898 = s1_897 + work.s1_559*work.s1_564 - 0.75*work.s1_556;
  const double s1_899 = s1_898 + work.s1_579*work.s1_602 - work.s1_588*work.s1_593;
  const double s1_900 = s1_899 + work.s1_609*work.s1_628 - work.s1_614*work.s1_619;
  const double s1_901 = s1_900 + work.s1_640*work.s1_653 - work.s1_643*work.s1_648;
  const double s1_902 = s1_901 + work.s1_662*work.s1_675 - work.s1_665*work.s1_670;
  const double s1_903 = s1_902 + work.s1_687*work.s1_706 - work.s1_692*work.s1_697;
  const double s1_904 = s1_903 + work.s1_709*work.s1_722 - work.s1_712*work.s1_717;
  const double s1_905 = s1_904 + work.s1_725*work.s1_738 - work.s1_728*work.s1_733;
  const double s1_906 = s1_905 + work.s1_741*work.s1_760 - work.s1_746*work.s1_751;
  const double s1_907 = s1_906 + work.s1_218*work.s1_225 - work.s1_79*work.s1_86;
  const double s1_908 = s1_907 + 0.6*(work.s1_623 - work.s1_571 - work.s1_597);
  const double s1_909 = 0.19999999999999998*(work.s1_743 - work.s1_689);
  work.s1_910 = s1_908 + 0.24*(work.s1_507 - work.s1_536) + s1_909;
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s1_911 = work.R_chassis_z_y*work.N_chassis_rx_y;
  const double s1_3 = work.sines[1];
  const double s1_912 = s1_911 + work.R_chassis_z_z*work.N_chassis_rx_z;
  work.N_chassis_rz_x = s1_912 - s1_3*work.N_chassis_rx_x;
  const double s1_913 = work.R_chassis_z_y*work.s1_843 + work.R_chassis_z_z*work.s1_910;
  const double N_chassis_rz_y = s1_913 - s1_3*work.N_chassis_rx_y;
  const double s1_914 = work.R_chassis_z_y*work.s1_910 + work.R_chassis_z_z*work.s1_857;
  const double N_chassis_rz_z = s1_914 - s1_3*work.N_chassis_rx_z;
  const double s1_915 = work.R_chassis_z_y*N_chassis_rz_y + work.R_chassis_z_z*N_chassis_rz_z;
  work.s1_916 = s1_915 - s1_3*work.N_chassis_rz_x;
  // operations: 979 add, 1112 multiply, 44 sin cos

  // --- step 4: velocities Z (36) ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  const double s4_1 = zd_chassis_rz*s1_3;
  const double s4_2 = zd_chassis_rz*work.R_chassis_z_y;
  const double s4_3 = zd_chassis_rz*work.R_chassis_z_z;
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  const double s4_4 = zd_chassis_ry*work.cosines[2];
  const double s4_5 = zd_chassis_ry*work.sines[2];
  work.w_chassis_y = s4_2 + s4_4;
  work.w_chassis_z = s4_3 - s4_5;
  const double zd_chassis_rx = state.zd[Coordinate::chassis_rx];
  work.w_chassis_x = zd_chassis_rx - s4_1;
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  work.w_lower_arm_left_x = zd_lower_arm_left + work.w_chassis_x;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s4_6 = zd_carrier_left_rz*R_lower_arm_left_z_y;
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double s4_7 = zd_carrier_left_rz*R_lower_arm_left_y_y;
  const double w_carrier_left_aux1_y = work.w_chassis_y - s4_6;
  const double w_carrier_left_aux1_z = work.w_chassis_z + s4_7;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double s4_8 = zd_carrier_left_rx*R_carrier_left_aux1_x_x;
  const double s4_9 = zd_carrier_left_rx*work.R_carrier_left_aux1_y_x;
  const double s4_10 = zd_carrier_left_rx*work.R_carrier_left_aux1_z_x;
  const double w_carrier_left_aux2_x = work.w_lower_arm_left_x + s4_8;
  const double w_carrier_left_aux2_y = w_carrier_left_aux1_y + s4_9;
  const double w_carrier_left_aux2_z = w_carrier_left_aux1_z + s4_10;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  const double s4_11 = zd_carrier_left_ry*work.s1_13;
  const double s4_12 = zd_carrier_left_ry*work.R_carrier_left_aux2_y_y;
  const double s4_13 = zd_carrier_left_ry*work.R_carrier_left_aux2_z_y;
  work.w_carrier_left_x = w_carrier_left_aux2_x - s4_11;
  work.w_carrier_left_y = w_carrier_left_aux2_y + s4_12;
  work.w_carrier_left_z = w_carrier_left_aux2_z + s4_13;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double zd_wheel_front_left = state.zd[Coordinate::wheel_front_left];
  const double s4_14 = zd_wheel_front_left*work.s1_13;
  const double s4_15 = zd_wheel_front_left*work.R_carrier_left_aux2_y_y;
  const double s4_16 = zd_wheel_front_left*work.R_carrier_left_aux2_z_y;
  work.w_wheel_front_left_x = work.w_carrier_left_x - s4_14;
  work.w_wheel_front_left_y = work.w_carrier_left_y + s4_15;
  work.w_wheel_front_left_z = work.w_carrier_left_z + s4_16;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  work.w_upper_arm_left_x = zd_upper_arm_left + work.w_chassis_x;
  // arb_front_left: arb_front_left, revolute, chassis
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  work.w_arb_front_left_y = zd_arb_front_left + work.w_chassis_y;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  work.w_lower_arm_right_x = zd_lower_arm_right + work.w_chassis_x;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  const double R_lower_arm_right_z_y = work.sines[9];
  const double s4_17 = zd_carrier_right_rz*R_lower_arm_right_z_y;
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s4_18 = zd_carrier_right_rz*R_lower_arm_right_y_y;
  const double w_carrier_right_aux1_y = work.w_chassis_y - s4_17;
  const double w_carrier_right_aux1_z = work.w_chassis_z + s4_18;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double s4_19 = zd_carrier_right_rx*R_carrier_right_aux1_x_x;
  const double s4_20 = zd_carrier_right_rx*work.R_carrier_right_aux1_y_x;
  const double s4_21 = zd_carrier_right_rx*work.R_carrier_right_aux1_z_x;
  const double w_carrier_right_aux2_x = work.w_lower_arm_right_x + s4_19;
  const double w_carrier_right_aux2_y = w_carrier_right_aux1_y + s4_20;
  const double w_carrier_right_aux2_z = w_carrier_right_aux1_z + s4_21;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  const double s4_22 = zd_carrier_right_ry*work.s1_40;
  const double s4_23 = zd_carrier_right_ry*work.R_carrier_right_aux2_y_y;
  const double s4_24 = zd_carrier_right_ry*work.R_carrier_right_aux2_z_y;
  work.w_carrier_right_x = w_carrier_right_aux2_x - s4_22;
  work.w_carrier_right_y = w_carrier_right_aux2_y + s4_23;
  work.w_carrier_right_z = w_carrier_right_aux2_z + s4_24;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double zd_wheel_front_right = state.zd[Coordinate::wheel_front_right];
  const double s4_25 = zd_wheel_front_right*work.s1_40;
  const double s4_26 = zd_wheel_front_right*work.R_carrier_right_aux2_y_y;
  const double s4_27 = zd_wheel_front_right*work.R_carrier_right_aux2_z_y;
  work.w_wheel_front_right_x = work.w_carrier_right_x - s4_25;
  work.w_wheel_front_right_y = work.w_carrier_right_y + s4_26;
  work.w_wheel_front_right_z = work.w_carrier_right_z + s4_27;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  work.w_upper_arm_right_x = zd_upper_arm_right + work.w_chassis_x;
  // arb_front_right: arb_front_right, revolute, chassis
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  work.w_arb_front_right_y = zd_arb_front_right + work.w_chassis_y;
  // pitman_arm: pitman_arm, revolute, chassis
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  work.w_pitman_arm_y = zd_pitman_arm + work.w_chassis_y;
  // bell_crank: bell_crank, revolute, chassis
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  work.w_bell_crank_z = zd_bell_crank + work.w_chassis_z;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  work.w_rear_axle_aux4_z = state.zd[Coordinate::rear_axle_rz] + work.w_chassis_z;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  work.s4_28 = zd_rear_axle_ry*work.sines[17];
  work.s4_29 = zd_rear_axle_ry*work.cosines[17];
  work.w_rear_axle_aux5_x = work.w_chassis_x - work.s4_28;
  work.w_rear_axle_aux5_y = work.w_chassis_y + work.s4_29;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  work.s4_30 = zd_rear_axle_rx*work.R_rear_axle_aux5_x_x;
  work.s4_31 = zd_rear_axle_rx*work.R_rear_axle_aux5_y_x;
  work.s4_32 = zd_rear_axle_rx*work.sines[18];
  work.w_rear_axle_x = work.w_rear_axle_aux5_x + work.s4_30;
  work.w_rear_axle_y = work.w_rear_axle_aux5_y + work.s4_31;
  work.w_rear_axle_z = work.w_rear_axle_aux4_z - work.s4_32;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double zd_wheel_rear_left = state.zd[Coordinate::wheel_rear_left];
  work.s4_33 = zd_wheel_rear_left*work.R_rear_axle_x_y;
  work.s4_34 = zd_wheel_rear_left*work.R_rear_axle_y_y;
  work.s4_35 = zd_wheel_rear_left*work.R_rear_axle_z_y;
  work.w_wheel_rear_left_x = work.w_rear_axle_x + work.s4_33;
  work.w_wheel_rear_left_y = work.w_rear_axle_y + work.s4_34;
  work.w_wheel_rear_left_z = work.w_rear_axle_z + work.s4_35;
  // arb_rear_left: arb_rear_left, revolute, chassis
  work.w_arb_rear_left_y = state.zd[Coordinate::arb_rear_left] + work.w_chassis_y;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double zd_wheel_rear_right = state.zd[Coordinate::wheel_rear_right];
  work.s4_36 = zd_wheel_rear_right*work.R_rear_axle_x_y;
  work.s4_37 = zd_wheel_rear_right*work.R_rear_axle_y_y;
  work.s4_38 = zd_wheel_rear_right*work.R_rear_axle_z_y;
  work.w_wheel_rear_right_x = work.w_rear_axle_x + work.s4_36;
  work.w_wheel_rear_right_y = work.w_rear_axle_y + work.s4_37;
  work.w_wheel_rear_right_z = work.w_rear_axle_z + work.s4_38;
  // arb_rear_right: arb_rear_right, revolute, chassis
  work.w_arb_rear_right_y = state.zd[Coordinate::arb_rear_right] + work.w_chassis_y;
  // operations: 47 add, 38 multiply

  // --- step 7: accelerations Zdot and accumulated forces QR - PR (51), (52) ---
  // chassis: chassis_rx, revolute, chassis_aux5
  work.s7_1 = 9.81*s1_3;
  work.a_chassis_y = 9.81*work.R_chassis_z_y;
  work.a_chassis_z = 9.81*work.R_chassis_z_z;
  work.s7_2 = s4_3*s4_4 + s4_2*s4_5;
  work.s7_3 = work.w_chassis_y*work.w_chassis_y;
  work.s7_4 = work.w_chassis_z*work.w_chassis_z;
  const double s7_5 = work.w_chassis_y*work.w_chassis_z;
  work.s7_6 = work.s7_3 + work.s7_4;
  work.s7_7 = s7_5 - work.s7_2;
  work.s7_8 = work.s7_2 + s7_5;
  work.alpha_chassis_y = zd_chassis_rx*work.w_chassis_z - s4_1*s4_5;
  work.s7_9 = s4_1*s4_4 + zd_chassis_rx*work.w_chassis_y;
  work.s7_10 = work.w_chassis_x*work.w_chassis_x;
  work.s7_11 = work.w_chassis_y*work.w_chassis_x;
  work.s7_12 = work.w_chassis_z*work.w_chassis_x;
  work.s7_13 = work.s7_11 - work.s7_9;
  work.s7_14 = work.s7_12 - work.alpha_chassis_y;
  work.s7_15 = work.s7_9 + work.s7_11;
  work.s7_16 = work.s7_4 + work.s7_10;
  work.s7_17 = work.alpha_chassis_y + work.s7_12;
  work.s7_18 = work.s7_3 + work.s7_10;
  // lower_arm_left: lower_arm_left, revolute, chassis
  work.alpha_lower_arm_left_x = projection.zdd_star[0] - work.s7_2;
  work.alpha_lower_arm_left_y = work.alpha_chassis_y + zd_lower_arm_left*work.w_chassis_z;
  work.s7_19 = work.s7_9 + zd_lower_arm_left*work.w_chassis_y;
  const double s7_20 = work.w_lower_arm_left_x*work.w_lower_arm_left_x;
  const double s7_21 = work.w_chassis_y*work.w_lower_arm_left_x;
  const double s7_22 = work.w_chassis_z*work.w_lower_arm_left_x;
  work.s7_23 = s7_21 - work.s7_19;
  work.s7_24 = s7_22 - work.alpha_lower_arm_left_y;
  work.s7_25 = work.s7_19 + s7_21;
  work.s7_26 = work.s7_4 + s7_20;
  work.s7_27 = s7_5 + work.alpha_lower_arm_left_x;
  work.s7_28 = work.alpha_lower_arm_left_y + s7_22;
  work.s7_29 = s7_5 - work.alpha_lower_arm_left_x;
  work.s7_30 = work.s7_3 + s7_20;
  const double s7_31 = 0.4*(work.s7_15 - work.s7_25) - work.s7_1;
  work.a_lower_arm_left_x = s7_31 - 0.62*(work.s7_17 - work.s7_28);
  const double s7_32 = work.a_chassis_y + 0.4*(work.s7_26 - work.s7_16);
  work.a_lower_arm_left_y = s7_32 + 3.6*(work.s7_13 - work.s7_23) - 0.62*(work.s7_8 - work.s7_29);
  const double s7_33 = work.a_chassis_z + 0.4*(work.s7_7 - work.s7_27);
  work.a_lower_arm_left_z = s7_33 + 3.6*(work.s7_14 - work.s7_24) - 0.62*(work.s7_30 - work.s7_18);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s7_34 = work.alpha_lower_arm_left_x + work.w_chassis_z*s4_6;
  const double alpha_carrier_left_aux1_x = s7_34 + work.w_chassis_y*s4_7;
  const double s7_35 = R_lower_arm_left_z_y*projection.zdd_star[1];
  const double alpha_carrier_left_aux1_y = work.alpha_lower_arm_left_y - s7_35 -
      work.w_lower_arm_left_x*s4_7;
  const double s7_36 = R_lower_arm_left_y_y*projection.zdd_star[1] - work.s7_19;
  const double alpha_carrier_left_aux1_z = s7_36 - work.w_lower_arm_left_x*s4_6;
  const double s7_37 = w_carrier_left_aux1_y*w_carrier_left_aux1_y;
  const double s7_38 = w_carrier_left_aux1_z*w_carrier_left_aux1_z;
  const double s7_39 = work.w_lower_arm_left_x*w_carrier_left_aux1_y;
  const double s7_40 = work.w_lower_arm_left_x*w_carrier_left_aux1_z;
  const double s7_41 = w_carrier_left_aux1_y*w_carrier_left_aux1_z;
  const double s7_42 = s7_37 + s7_38;
  const double s7_43 = alpha_carrier_left_aux1_z + s7_39;
  const double s7_44 = s7_40 - alpha_carrier_left_aux1_y;
  const double s7_45 = s7_39 - alpha_carrier_left_aux1_z;
  const double s7_46 = s7_20 + s7_38;
  const double s7_47 = alpha_carrier_left_aux1_x + s7_41;
  const double s7_48 = alpha_carrier_left_aux1_y + s7_40;
  const double s7_49 = s7_41 - alpha_carrier_left_aux1_x;
  const double s7_50 = s7_20 + s7_37;
  const double s7_51 = work.r_carrier_left_aux1_y*(work.s7_25 - s7_45);
  const double s7_52 = work.r_carrier_left_aux1_z*(work.s7_28 - s7_48);
  const double a_carrier_left_aux1_x = work.a_lower_arm_left_x + s7_51 + s7_52 + 3.6*(s7_42 -
      work.s7_6);
  const double s7_53 = work.r_carrier_left_aux1_y*(s7_46 - work.s7_26);
  const double s7_54 = work.r_carrier_left_aux1_z*(work.s7_29 - s7_49);
  const double a_carrier_left_aux1_y = work.a_lower_arm_left_y + s7_53 + s7_54 + 3.6*(work.s7_23 -
      s7_43);
  const double s7_55 = work.r_carrier_left_aux1_y*(work.s7_27 - s7_47);
  const double s7_56 = work.r_carrier_left_aux1_z*(s7_50 - work.s7_30);
  const double a_carrier_left_aux1_z = work.a_lower_arm_left_z + s7_55 + s7_56 + 3.6*(work.s7_24 -
      s7_44);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s7_57 = alpha_carrier_left_aux1_x + w_carrier_left_aux1_y*s4_10;
  const double s7_58 = R_carrier_left_aux1_x_x*projection.zdd_star[2];
  const double alpha_carrier_left_aux2_x = s7_57 - w_carrier_left_aux1_z*s4_9 + s7_58;
  const double s7_59 = alpha_carrier_left_aux1_y + w_carrier_left_aux1_z*s4_8;
  const double s7_60 = work.R_carrier_left_aux1_y_x*projection.zdd_star[2];
  const double alpha_carrier_left_aux2_y = s7_59 - work.w_lower_arm_left_x*s4_10 + s7_60;
  const double s7_61 = alpha_carrier_left_aux1_z + work.w_lower_arm_left_x*s4_9;
  const double s7_62 = work.R_carrier_left_aux1_z_x*projection.zdd_star[2];
  const double alpha_carrier_left_aux2_z = s7_61 - w_carrier_left_aux1_y*s4_8 + s7_62;
  const double s7_63 = w_carrier_left_aux2_x*w_carrier_left_aux2_x;
  const double s7_64 = w_carrier_left_aux2_y*w_carrier_left_aux2_y;
  const double s7_65 = w_carrier_left_aux2_z*w_carrier_left_aux2_z;
  const double s7_66 = w_carrier_left_aux2_x*w_carrier_left_aux2_y;
  const double s7_67 = w_carrier_left_aux2_x*w_carrier_left_aux2_z;
  const double s7_68 = w_carrier_left_aux2_y*w_carrier_left_aux2_z;
  const double s7_69 = s7_64 + s7_65;
  const double s7_70 = alpha_carrier_left_aux2_z + s7_66;
  const double s7_71 = s7_67 - alpha_carrier_left_aux2_y;
  const double s7_72 = s7_66 - alpha_carrier_left_aux2_z;
  const double s7_73 = s7_63 + s7_65;
  const double s7_74 = alpha_carrier_left_aux2_x + s7_68;
  const double s7_75 = alpha_carrier_left_aux2_y + s7_67;
  const double s7_76 = s7_68 - alpha_carrier_left_aux2_x;
  const double s7_77 = s7_63 + s7_64;
  const double s7_78 = a_carrier_left_aux1_x + work.r_carrier_left_aux1_y*(s7_45 - s7_72);
  const double a_carrier_left_aux2_x = s7_78 + work.r_carrier_left_aux1_z*(s7_48 - s7_75) +
      3.6*(s7_69 - s7_42);
  const double s7_79 = a_carrier_left_aux1_y + work.r_carrier_left_aux1_y*(s7_73 - s7_46);
  const double a_carrier_left_aux2_y = s7_79 + work.r_carrier_left_aux1_z*(s7_49 - s7_76) +
      3.6*(s7_43 - s7_70);
  const double s7_80 = a_carrier_left_aux1_z + work.r_carrier_left_aux1_y*(s7_47 - s7_74);
  const double a_carrier_left_aux2_z = s7_80 + work.r_carrier_left_aux1_z*(s7_77 - s7_50) +
      3.6*(s7_44 - s7_71);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_81 = alpha_carrier_left_aux2_x + w_carrier_left_aux2_y*s4_13;
  work.alpha_carrier_left_x = s7_81 - w_carrier_left_aux2_z*s4_12 -
      work.s1_13*projection.zdd_star[3];
  const double s7_82 = work.R_carrier_left_aux2_y_y*projection.zdd_star[3];
  const double s7_83 = alpha_carrier_left_aux2_y + s7_82 - w_carrier_left_aux2_x*s4_13;
  work.alpha_carrier_left_y = s7_83 - w_carrier_left_aux2_z*s4_11;
  const double s7_84 = alpha_carrier_left_aux2_z + w_carrier_left_aux2_y*s4_11;
  const double s7_85 = work.R_carrier_left_aux2_z_y*projection.zdd_star[3];
  work.alpha_carrier_left_z = s7_84 + w_carrier_left_aux2_x*s4_12 + s7_85;
  const double s7_86 = work.w_carrier_left_x*work.w_carrier_left_x;
  const double s7_87 = work.w_carrier_left_y*work.w_carrier_left_y;
  const double s7_88 = work.w_carrier_left_z*work.w_carrier_left_z;
  const double s7_89 = work.w_carrier_left_x*work.w_carrier_left_y;
  const double s7_90 = work.w_carrier_left_x*work.w_carrier_left_z;
  const double s7_91 = work.w_carrier_left_y*work.w_carrier_left_z;
  work.s7_92 = s7_87 + s7_88;
  work.s7_93 = work.alpha_carrier_left_z + s7_89;
  work.s7_94 = s7_90 - work.alpha_carrier_left_y;
  work.s7_95 = s7_89 - work.alpha_carrier_left_z;
  work.s7_96 = s7_86 + s7_88;
  work.s7_97 = work.alpha_carrier_left_x + s7_91;
  work.s7_98 = work.alpha_carrier_left_y + s7_90;
  work.s7_99 = s7_91 - work.alpha_carrier_left_x;
  work.s7_100 = s7_86 + s7_87;
  const double s7_101 = a_carrier_left_aux2_x + work.r_carrier_left_aux1_y*(s7_72 - work.s7_95);
  const double s7_102 = s7_101 + work.r_carrier_left_aux1_z*(s7_75 - work.s7_98);
  work.a_carrier_left_x = s7_102 + 3.6*(work.s7_92 - s7_69);
  const double s7_103 = a_carrier_left_aux2_y + work.r_carrier_left_aux1_y*(work.s7_96 - s7_73);
  const double s7_104 = s7_103 + work.r_carrier_left_aux1_z*(s7_76 - work.s7_99);
  work.a_carrier_left_y = s7_104 + 3.6*(s7_70 - work.s7_93);
  const double s7_105 = a_carrier_left_aux2_z + work.r_carrier_left_aux1_y*(s7_74 - work.s7_97);
  const double s7_106 = s7_105 + work.r_carrier_left_aux1_z*(work.s7_100 - s7_77);
  work.a_carrier_left_z = s7_106 + 3.6*(s7_71 - work.s7_94);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s7_107 = work.alpha_carrier_left_x + work.w_carrier_left_y*s4_16;
  work.alpha_wheel_front_left_x = s7_107 - work.w_carrier_left_z*s4_15;
  const double s7_108 = work.alpha_carrier_left_y - work.w_carrier_left_x*s4_16;
  work.alpha_wheel_front_left_y = s7_108 - work.w_carrier_left_z*s4_14;
  const double s7_109 = work.alpha_carrier_left_z + work.w_carrier_left_y*s4_14;
  work.alpha_wheel_front_left_z = s7_109 + work.w_carrier_left_x*s4_15;
  const double s7_110 = work.w_wheel_front_left_x*work.w_wheel_front_left_x;
  const double s7_111 = work.w_wheel_front_left_y*work.w_wheel_front_left_y;
  const double s7_112 = work.w_wheel_front_left_z*work.w_wheel_front_left_z;
  const double s7_113 = work.w_wheel_front_left_x*work.w_wheel_front_left_y;
  const double s7_114 = work.w_wheel_front_left_x*work.w_wheel_front_left_z;
  const double s7_115 = work.w_wheel_front_left_y*work.w_wheel_front_left_z;
  work.s7_116 = s7_111 + s7_112;
  work.s7_117 = work.alpha_wheel_front_left_z + s7_113;
  work.s7_118 = s7_114 - work.alpha_wheel_front_left_y;
  work.s7_119 = s7_113 - work.alpha_wheel_front_left_z;
  work.s7_120 = s7_110 + s7_112;
  work.s7_121 = work.alpha_wheel_front_left_x + s7_115;
  work.s7_122 = work.alpha_wheel_front_left_y + s7_114;
  work.s7_123 = s7_115 - work.alpha_wheel_front_left_x;
  work.s7_124 = s7_110 + s7_111;
  const double s7_125 = work.r_wheel_front_left_y*(work.s7_95 - work.s7_119);
  const double s7_126 = work.r_wheel_front_left_z*(work.s7_98 - work.s7_122);
  const double s7_127 = work.r_wheel_front_left_x*(work.s7_116 - work.s7_92);
  work.a_wheel_front_left_x = work.a_carrier_left_x + s7_125 + s7_126 + s7_127;
  const double s7_128 = work.r_wheel_front_left_y*(work.s7_120 - work.s7_96);
  const double s7_129 = work.r_wheel_front_left_z*(work.s7_99 - work.s7_123);
  const double s7_130 = work.r_wheel_front_left_x*(work.s7_93 - work.s7_117);
  work.a_wheel_front_left_y = work.a_carrier_left_y + s7_128 + s7_129 + s7_130;
  const double s7_131 = work.r_wheel_front_left_y*(work.s7_97 - work.s7_121);
  const double s7_132 = work.r_wheel_front_left_z*(work.s7_124 - work.s7_100);
  const double s7_133 = work.r_wheel_front_left_x*(work.s7_94 - work.s7_118);
  work.a_wheel_front_left_z = work.a_carrier_left_z + s7_131 + s7_132 + s7_133;
  // upper_arm_left: upper_arm_left, revolute, chassis
  work.alpha_upper_arm_left_x = projection.zdd_star[4] - work.s7_2;
  work.alpha_upper_arm_left_y = work.alpha_chassis_y + zd_upper_arm_left*work.w_chassis_z;
  work.s7_134 = work.s7_9 + zd_upper_arm_left*work.w_chassis_y;
  const double s7_135 = work.w_upper_arm_left_x*work.w_upper_arm_left_x;
  const double s7_136 = work.w_chassis_y*work.w_upper_arm_left_x;
  const double s7_137 = work.w_chassis_z*work.w_upper_arm_left_x;
  work.s7_138 = s7_136 - work.s7_134;
  work.s7_139 = s7_137 - work.alpha_upper_arm_left_y;
  work.s7_140 = work.s7_134 + s7_136;
  work.s7_141 = work.s7_4 + s7_135;
  work.s7_142 = s7_5 + work.alpha_upper_arm_left_x;
  work.s7_143 = work.alpha_upper_arm_left_y + s7_137;
  work.s7_144 = s7_5 - work.alpha_upper_arm_left_x;
  work.s7_145 = work.s7_3 + s7_135;
  const double s7_146 = 0.5*(work.s7_15 - work.s7_140) - work.s7_1;
  work.a_upper_arm_left_x = s7_146 - 0.28*(work.s7_17 - work.s7_143);
  const double s7_147 = work.a_chassis_y + 0.5*(work.s7_141 - work.s7_16);
  work.a_upper_arm_left_y = s7_147 + 3.6*(work.s7_13 - work.s7_138) - 0.28*(work.s7_8 -
      work.s7_144);
  const double s7_148 = work.a_chassis_z + 0.5*(work.s7_7 - work.s7_142);
  const double s7_149 = s7_148 + 3.6*(work.s7_14 - work.s7_139);
  work.a_upper_arm_left_z = s7_149 - 0.28*(work.s7_145 - work.s7_18);
  // arb_front_left: arb_front_left, revolute, chassis
  work.alpha_arb_front_left_y = projection.zdd_star[5] + work.alpha_chassis_y;
  work.s7_150 = work.s7_2 + zd_arb_front_left*work.w_chassis_z;
  work.alpha_arb_front_left_z = zd_arb_front_left*work.w_chassis_x - work.s7_9;
  const double s7_151 = work.w_arb_front_left_y*work.w_arb_front_left_y;
  const double s7_152 = work.w_chassis_x*work.w_arb_front_left_y;
  const double s7_153 = work.w_chassis_z*work.w_arb_front_left_y;
  work.s7_154 = work.s7_4 + s7_151;
  work.s7_155 = work.alpha_arb_front_left_z + s7_152;
  work.s7_156 = work.s7_12 - work.alpha_arb_front_left_y;
  work.s7_157 = s7_152 - work.alpha_arb_front_left_z;
  work.s7_158 = s7_153 - work.s7_150;
  work.s7_159 = work.s7_12 + work.alpha_arb_front_left_y;
  work.s7_160 = work.s7_150 + s7_153;
  work.s7_161 = work.s7_10 + s7_151;
  const double s7_162 = 0.45*(work.s7_15 - work.s7_157) - work.s7_1;
  work.a_arb_front_left_x = s7_162 + 3.95*(work.s7_154 - work.s7_6) - 0.5*(work.s7_17 -
      work.s7_159);
  const double s7_163 = work.a_chassis_y + 3.95*(work.s7_13 - work.s7_155);
  work.a_arb_front_left_y = s7_163 - 0.5*(work.s7_8 - work.s7_160);
  const double s7_164 = work.a_chassis_z + 0.45*(work.s7_7 - work.s7_158);
  const double s7_165 = s7_164 + 3.95*(work.s7_14 - work.s7_156);
  work.a_arb_front_left_z = s7_165 - 0.5*(work.s7_161 - work.s7_18);
  // lower_arm_right: lower_arm_right, revolute, chassis
  work.alpha_lower_arm_right_x = projection.zdd_star[6] - work.s7_2;
  work.alpha_lower_arm_right_y = work.alpha_chassis_y + zd_lower_arm_right*work.w_chassis_z;
  work.s7_166 = work.s7_9 + zd_lower_arm_right*work.w_chassis_y;
  const double s7_167 = work.w_lower_arm_right_x*work.w_lower_arm_right_x;
  const double s7_168 = work.w_chassis_y*work.w_lower_arm_right_x;
  const double s7_169 = work.w_chassis_z*work.w_lower_arm_right_x;
  work.s7_170 = s7_168 - work.s7_166;
  work.s7_171 = s7_169 - work.alpha_lower_arm_right_y;
  work.s7_172 = work.s7_166 + s7_168;
  work.s7_173 = work.s7_4 + s7_167;
  work.s7_174 = s7_5 + work.alpha_lower_arm_right_x;
  work.s7_175 = work.alpha_lower_arm_right_y + s7_169;
  work.s7_176 = s7_5 - work.alpha_lower_arm_right_x;
  work.s7_177 = work.s7_3 + s7_167;
  const double s7_178 = work.s7_1 + 0.4*(work.s7_15 - work.s7_172);
  work.s7_179 = s7_178 + 0.62*(work.s7_17 - work.s7_175);
  const double s7_180 = work.a_chassis_y + 3.6*(work.s7_13 - work.s7_170);
  work.a_lower_arm_right_y = s7_180 - 0.62*(work.s7_8 - work.s7_176) - 0.4*(work.s7_173 -
      work.s7_16);
  const double s7_181 = work.a_chassis_z + 3.6*(work.s7_14 - work.s7_171);
  work.a_lower_arm_right_z = s7_181 - 0.62*(work.s7_177 - work.s7_18) - 0.4*(work.s7_7 -
      work.s7_174);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s7_182 = work.alpha_lower_arm_right_x + work.w_chassis_z*s4_17;
  const double alpha_carrier_right_aux1_x = s7_182 + work.w_chassis_y*s4_18;
  const double s7_183 = R_lower_arm_right_z_y*projection.zdd_star[7];
  const double alpha_carrier_right_aux1_y = work.alpha_lower_arm_right_y - s7_183 -
      work.w_lower_arm_right_x*s4_18;
  const double s7_184 = R_lower_arm_right_y_y*projection.zdd_star[7] - work.s7_166;
  const double alpha_carrier_right_aux1_z = s7_184 - work.w_lower_arm_right_x*s4_17;
  const double s7_185 = w_carrier_right_aux1_y*w_carrier_right_aux1_y;
  const double s7_186 = w_carrier_right_aux1_z*w_carrier_right_aux1_z;
  const double s7_187 = work.w_lower_arm_right_x*w_carrier_right_aux1_y;
  const double s7_188 = work.w_lower_arm_right_x*w_carrier_right_aux1_z;
  const double s7_189 = w_carrier_right_aux1_y*w_carrier_right_aux1_z;
  const double s7_190 = s7_185 + s7_186;
  const double s7_191 = alpha_carrier_right_aux1_z + s7_187;
  const double s7_192 = s7_188 - alpha_carrier_right_aux1_y;
  const double s7_193 = s7_187 - alpha_carrier_right_aux1_z;
  const double s7_194 = s7_167 + s7_186;
  const double s7_195 = alpha_carrier_right_aux1_x + s7_189;
  const double s7_196 = alpha_carrier_right_aux1_y + s7_188;
  const double s7_197 = s7_189 - alpha_carrier_right_aux1_x;
  const double s7_198 = s7_167 + s7_185;
  const double s7_199 = work.r_carrier_right_aux1_y*(work.s7_172 - s7_193) - work.s7_179;
  const double a_carrier_right_aux1_x = s7_199 + 3.6*(s7_190 - work.s7_6) - work.s1_34*(work.s7_175
      - s7_196);
  const double s7_200 = work.r_carrier_right_aux1_y*(s7_194 - work.s7_173);
  const double s7_201 = work.a_lower_arm_right_y + s7_200 + 3.6*(work.s7_170 - s7_191);
  const double a_carrier_right_aux1_y = s7_201 - work.s1_34*(work.s7_176 - s7_197);
  const double s7_202 = work.r_carrier_right_aux1_y*(work.s7_174 - s7_195);
  const double s7_203 = work.a_lower_arm_right_z + s7_202 + 3.6*(work.s7_171 - s7_192);
  const double a_carrier_right_aux1_z = s7_203 - work.s1_34*(s7_198 - work.s7_177);
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s7_204 = alpha_carrier_right_aux1_x + w_carrier_right_aux1_y*s4_21;
  const double s7_205 = R_carrier_right_aux1_x_x*projection.zdd_star[8];
  const double alpha_carrier_right_aux2_x = s7_204 - w_carrier_right_aux1_z*s4_20 + s7_205;
  const double s7_206 = alpha_carrier_right_aux1_y + w_carrier_right_aux1_z*s4_19;
  const double s7_207 = work.R_carrier_right_aux1_y_x*projection.zdd_star[8];
  const double alpha_carrier_right_aux2_y = s7_206 - work.w_lower_arm_right_x*s4_21 + s7_207;
  const double s7_208 = alpha_carrier_right_aux1_z + work.w_lower_arm_right_x*s4_20;
  const double s7_209 = work.R_carrier_right_aux1_z_x*projection.zdd_star[8];
  const double alpha_carrier_right_aux2_z = s7_208 - w_carrier_right_aux1_y*s4_19 + s7_209;
  const double s7_210 = w_carrier_right_aux2_x*w_carrier_right_aux2_x;
  const double s7_211 = w_carrier_right_aux2_y*w_carrier_right_aux2_y;
  const double s7_212 = w_carrier_right_aux2_z*w_carrier_right_aux2_z;
  const double s7_213 = w_carrier_right_aux2_x*w_carrier_right_aux2_y;
  const double s7_214 = w_carrier_right_aux2_x*w_carrier_right_aux2_z;
  const double s7_215 = w_carrier_right_aux2_y*w_carrier_right_aux2_z;
  const double s7_216 = s7_211 + s7_212;
  const double s7_217 = alpha_carrier_right_aux2_z + s7_213;
  const double s7_218 = s7_214 - alpha_carrier_right_aux2_y;
  const double s7_219 = s7_213 - alpha_carrier_right_aux2_z;
  const double s7_220 = s7_210 + s7_212;
  const double s7_221 = alpha_carrier_right_aux2_x + s7_215;
  const double s7_222 = alpha_carrier_right_aux2_y + s7_214;
  const double s7_223 = s7_215 - alpha_carrier_right_aux2_x;
  const double s7_224 = s7_210 + s7_211;
  const double s7_225 = a_carrier_right_aux1_x + work.r_carrier_right_aux1_y*(s7_193 - s7_219);
  const double a_carrier_right_aux2_x = s7_225 + 3.6*(s7_216 - s7_190) - work.s1_34*(s7_196 -
      s7_222);
  const double s7_226 = a_carrier_right_aux1_y + work.r_carrier_right_aux1_y*(s7_220 - s7_194);
  const double a_carrier_right_aux2_y = s7_226 + 3.6*(s7_191 - s7_217) - work.s1_34*(s7_197 -
      s7_223);
  const double s7_227 = a_carrier_right_aux1_z + work.r_carrier_right_aux1_y*(s7_195 - s7_221);
  const double a_carrier_right_aux2_z = s7_227 + 3.6*(s7_192 - s7_218) - work.s1_34*(s7_224 -
      s7_198);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_228 = alpha_carrier_right_aux2_x + w_carrier_right_aux2_y*s4_24;
  const double s7_229 = s7_228 - w_carrier_right_aux2_z*s4_23;
  work.alpha_carrier_right_x = s7_229 - work.s1_40*projection.zdd_star[9];
  const double s7_230 = work.R_carrier_right_aux2_y_y*projection.zdd_star[9];
  const double s7_231 = alpha_carrier_right_aux2_y + s7_230 - w_carrier_right_aux2_x*s4_24;
  work.alpha_carrier_right_y = s7_231 - w_carrier_right_aux2_z*s4_22;
  const double s7_232 = alpha_carrier_right_aux2_z + w_carrier_right_aux2_y*s4_22;
  const double s7_233 = work.R_carrier_right_aux2_z_y*projection.zdd_star[9];
  work.alpha_carrier_right_z = s7_232 + w_carrier_right_aux2_x*s4_23 + s7_233;
  const double s7_234 = work.w_carrier_right_x*work.w_carrier_right_x;
  const double s7_235 = work.w_carrier_right_y*work.w_carrier_right_y;
  const double s7_236 = work.w_carrier_right_z*work.w_carrier_right_z;
  const double s7_237 = work.w_carrier_right_x*work.w_carrier_right_y;
  const double s7_238 = work.w_carrier_right_x*work.w_carrier_right_z;
  const double s7_239 = work.w_carrier_right_y*work.w_carrier_right_z;
  work.s7_240 = s7_235 + s7_236;
  work.s7_241 = work.alpha_carrier_right_z + s7_237;
  work.s7_242 = s7_238 - work.alpha_carrier_right_y;
  work.s7_243 = s7_237 - work.alpha_carrier_right_z;
  work.s7_244 = s7_234 + s7_236;
  work.s7_245 = work.alpha_carrier_right_x + s7_239;
  work.s7_246 = work.alpha_carrier_right_y + s7_238;
  work.s7_247 = s7_239 - work.alpha_carrier_right_x;
  work.s7_248 = s7_234 + s7_235;
  const double s7_249 = work.r_carrier_right_aux1_y*(s7_219 - work.s7_243);
  const double s7_250 = a_carrier_right_aux2_x + s7_249 + 3.6*(work.s7_240 - s7_216);
  work.a_carrier_right_x = s7_250 - work.s1_34*(s7_222 - work.s7_246);
  const double s7_251 = work.r_carrier_right_aux1_y*(work.s7_244 - s7_220);
  const double s7_252 = a_carrier_right_aux2_y + s7_251 + 3.6*(s7_217 - work.s7_241);
  work.a_carrier_right_y = s7_252 - work.s1_34*(s7_223 - work.s7_247);
  const double s7_253 = work.r_carrier_right_aux1_y*(s7_221 - work.s7_245);
  const double s7_254 = a_carrier_right_aux2_z + s7_253 + 3.6*(s7_218 - work.s7_242);
  work.a_carrier_right_z = s7_254 - work.s1_34*(work.s7_248 - s7_224);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s7_255 = work.alpha_carrier_right_x + work.w_carrier_right_y*s4_27;
  work.alpha_wheel_front_right_x = s7_255 - work.w_carrier_right_z*s4_26;
  const double s7_256 = work.alpha_carrier_right_y - work.w_carrier_right_x*s4_27;
  work.alpha_wheel_front_right_y = s7_256 - work.w_carrier_right_z*s4_25;
  const double s7_257 = work.alpha_carrier_right_z + work.w_carrier_right_y*s4_25;
  work.alpha_wheel_front_right_z = s7_257 + work.w_carrier_right_x*s4_26;
  const double s7_258 = work.w_wheel_front_right_x*work.w_wheel_front_right_x;
  const double s7_259 = work.w_wheel_front_right_y*work.w_wheel_front_right_y;
  const double s7_260 = work.w_wheel_front_right_z*work.w_wheel_front_right_z;
  const double s7_261 = work.w_wheel_front_right_x*work.w_wheel_front_right_y;
  const double s7_262 = work.w_wheel_front_right_x*work.w_wheel_front_right_z;
  const double s7_263 = work.w_wheel_front_right_y*work.w_wheel_front_right_z;
  work.s7_264 = s7_259 + s7_260;
  work.s7_265 = work.alpha_wheel_front_right_z + s7_261;
  work.s7_266 = s7_262 - work.alpha_wheel_front_right_y;
  work.s7_267 = s7_261 - work.alpha_wheel_front_right_z;
  work.s7_268 = s7_258 + s7_260;
  work.s7_269 = work.alpha_wheel_front_right_x + s7_263;
  work.s7_270 = work.alpha_wheel_front_right_y + s7_262;
  work.s7_271 = s7_263 - work.alpha_wheel_front_right_x;
  work.s7_272 = s7_258 + s7_259;
  const double s7_273 = work.r_wheel_front_right_y*(work.s7_243 - work.s7_267);
  const double s7_274 = work.r_wheel_front_right_z*(work.s7_246 - work.s7_270);
  const double s7_275 = work.r_wheel_front_right_x*(work.s7_264 - work.s7_240);
  work.a_wheel_front_right_x = work.a_carrier_right_x + s7_273 + s7_274 + s7_275;
  const double s7_276 = work.r_wheel_front_right_y*(work.s7_268 - work.s7_244);
  const double s7_277 = work.r_wheel_front_right_z*(work.s7_247 - work.s7_271);
  const double s7_278 = work.r_wheel_front_right_x*(work.s7_241 - work.s7_265);
  work.a_wheel_front_right_y = work.a_carrier_right_y + s7_276 + s7_277 + s7_278;
  const double s7_279 = work.r_wheel_front_right_y*(work.s7_245 - work.s7_269);
  const double s7_280 = work.r_wheel_front_right_z*(work.s7_272 - work.s7_248);
  const double s7_281 = work.r_wheel_front_right_x*(work.s7_242 - work.s7_266);
  work.a_wheel_front_right_z = work.a_carrier_right_z + s7_279 + s7_280 + s7_281;
  // upper_arm_right: upper_arm_right, revolute, chassis
  work.alpha_upper_arm_right_x = projection.zdd_star[10] - work.s7_2;
  work.alpha_upper_arm_right_y = work.alpha_chassis_y + zd_upper_arm_right*work.w_chassis_z;
  work.s7_282 = work.s7_9 + zd_upper_arm_right*work.w_chassis_y;
  const double s7_283 = work.w_upper_arm_right_x*work.w_upper_arm_right_x;
  const double s7_284 = work.w_chassis_y*work.w_upper_arm_right_x;
  const double s7_285 = work.w_chassis_z*work.w_upper_arm_right_x;
  work.s7_286 = s7_284 - work.s7_282;
  work.s7_287 = s7_285 - work.alpha_upper_arm_right_y;
  work.s7_288 = work.s7_282 + s7_284;
  work.s7_289 = work.s7_4 + s7_283;
  work.s7_290 = s7_5 + work.alpha_upper_arm_right_x;
  work.s7_291 = work.alpha_upper_arm_right_y + s7_285;
  work.s7_292 = s7_5 - work.alpha_upper_arm_right_x;
  work.s7_293 = work.s7_3 + s7_283;
  work.s7_294 = work.s7_15 - work.s7_288;
  work.s7_295 = work.s7_17 - work.s7_291;
  const double s7_296 = work.a_chassis_y + 3.6*(work.s7_13 - work.s7_286);
  work.a_upper_arm_right_y = s7_296 - 0.28*(work.s7_8 - work.s7_292) - 0.5*(work.s7_289 -
      work.s7_16);
  const double s7_297 = work.a_chassis_z + 3.6*(work.s7_14 - work.s7_287);
  work.a_upper_arm_right_z = s7_297 - 0.28*(work.s7_293 - work.s7_18) - 0.5*(work.s7_7 -
      work.s7_290);
  // arb_front_right: arb_front_right, revolute, chassis
  work.alpha_arb_front_right_y = projection.zdd_star[11] + work.alpha_chassis_y;
  work.s7_298 = work.s7_2 + zd_arb_front_right*work.w_chassis_z;
  work.alpha_arb_front_right_z = zd_arb_front_right*work.w_chassis_x - work.s7_9;
  const double s7_299 = work.w_arb_front_right_y*work.w_arb_front_right_y;
  const double s7_300 = work.w_chassis_x*work.w_arb_front_right_y;
  const double s7_301 = work.w_chassis_z*work.w_arb_front_right_y;
  work.s7_302 = work.s7_4 + s7_299;
  work.s7_303 = work.alpha_arb_front_right_z + s7_300;
  work.s7_304 = work.s7_12 - work.alpha_arb_front_right_y;
  work.s7_305 = s7_300 - work.alpha_arb_front_right_z;
  work.s7_306 = s7_301 - work.s7_298;
  work.s7_307 = work.s7_12 + work.alpha_arb_front_right_y;
  work.s7_308 = work.s7_298 + s7_301;
  work.s7_309 = work.s7_10 + s7_299;
  const double s7_310 = 3.95*(work.s7_302 - work.s7_6) - work.s7_1;
  const double s7_311 = s7_310 - 0.5*(work.s7_17 - work.s7_307);
  work.a_arb_front_right_x = s7_311 - 0.45*(work.s7_15 - work.s7_305);
  const double s7_312 = work.a_chassis_y + 3.95*(work.s7_13 - work.s7_303);
  work.a_arb_front_right_y = s7_312 - 0.5*(work.s7_8 - work.s7_308);
  const double s7_313 = work.a_chassis_z + 3.95*(work.s7_14 - work.s7_304);
  work.a_arb_front_right_z = s7_313 - 0.5*(work.s7_309 - work.s7_18) - 0.45*(work.s7_7 -
      work.s7_306);
  // pitman_arm: pitman_arm, revolute, chassis
  work.alpha_pitman_arm_y = projection.zdd_star[12] + work.alpha_chassis_y;
  work.s7_314 = work.s7_2 + zd_pitman_arm*work.w_chassis_z;
  work.alpha_pitman_arm_z = zd_pitman_arm*work.w_chassis_x - work.s7_9;
  const double s7_315 = work.w_pitman_arm_y*work.w_pitman_arm_y;
  const double s7_316 = work.w_chassis_x*work.w_pitman_arm_y;
  const double s7_317 = work.w_chassis_z*work.w_pitman_arm_y;
  work.s7_318 = work.s7_4 + s7_315;
  work.s7_319 = work.alpha_pitman_arm_z + s7_316;
  work.s7_320 = work.s7_12 - work.alpha_pitman_arm_y;
  work.s7_321 = s7_316 - work.alpha_pitman_arm_z;
  work.s7_322 = s7_317 - work.s7_314;
  work.s7_323 = work.s7_12 + work.alpha_pitman_arm_y;
  work.s7_324 = work.s7_314 + s7_317;
  work.s7_325 = work.s7_10 + s7_315;
  const double s7_326 = 0.5*(work.s7_15 - work.s7_321) - work.s7_1;
  work.a_pitman_arm_x = s7_326 + 4.4*(work.s7_318 - work.s7_6) - 0.4*(work.s7_17 - work.s7_323);
  const double s7_327 = work.a_chassis_y + 4.4*(work.s7_13 - work.s7_319);
  work.a_pitman_arm_y = s7_327 - 0.4*(work.s7_8 - work.s7_324);
  const double s7_328 = work.a_chassis_z + 0.5*(work.s7_7 - work.s7_322);
  work.a_pitman_arm_z = s7_328 + 4.4*(work.s7_14 - work.s7_320) - 0.4*(work.s7_325 - work.s7_18);
  // bell_crank: bell_crank, revolute, chassis
  work.alpha_bell_crank_z = projection.zdd_star[13] - work.s7_9;
  work.alpha_bell_crank_x = zd_bell_crank*work.w_chassis_y - work.s7_2;
  work.alpha_bell_crank_y = work.alpha_chassis_y - zd_bell_crank*work.w_chassis_x;
  const double s7_329 = work.w_bell_crank_z*work.w_bell_crank_z;
  const double s7_330 = work.w_chassis_x*work.w_bell_crank_z;
  const double s7_331 = work.w_chassis_y*work.w_bell_crank_z;
  work.s7_332 = work.s7_3 + s7_329;
  work.s7_333 = work.s7_11 + work.alpha_bell_crank_z;
  work.s7_334 = s7_330 - work.alpha_bell_crank_y;
  work.s7_335 = work.s7_11 - work.alpha_bell_crank_z;
  work.s7_336 = work.s7_10 + s7_329;
  work.s7_337 = work.alpha_bell_crank_x + s7_331;
  work.s7_338 = work.alpha_bell_crank_y + s7_330;
  work.s7_339 = s7_331 - work.alpha_bell_crank_x;
  work.s7_340 = work.s7_13 - work.s7_333;
  work.s7_341 = work.s7_14 - work.s7_334;
  work.s7_342 = work.s7_17 - work.s7_338;
  work.s7_343 = work.s7_8 - work.s7_339;
  work.s7_344 = 3.25*(work.s7_332 - work.s7_6);
}

/// Part 4 of compute_chosen_accelerations: step 7: accelerations Zdot and accumulated forces QR -
/// PR (51), (52).
[[gnu::noinline]] void compute_chosen_accelerations_4(const State& state,
    const Projection& projection, ChosenAccelerationsWork& __restrict work) noexcept {
  // --- step 7: accelerations Zdot and accumulated forces QR - PR (51), (52), continued ---
  // bell_crank: bell_crank, revolute, chassis
  const double a_bell_crank_x = work.s7_344 - work.s7_1 - 0.6*work.s7_342;
  const double a_bell_crank_y = work.a_chassis_y + 3.25*work.s7_340 - 0.6*work.s7_343;
  const double a_bell_crank_z = work.a_chassis_z + 3.25*work.s7_341;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s7_345 = zd_rear_axle_tx*work.w_chassis_z;
  const double s7_346 = zd_rear_axle_tx*work.w_chassis_y;
  const double a_rear_axle_aux1_x = projection.zdd_star[14] - work.s7_1;
  const double a_rear_axle_aux1_y = s7_345 + (work.a_chassis_y + s7_345);
  const double a_rear_axle_aux1_z = work.a_chassis_z - s7_346 - s7_346;
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s7_347 = zd_rear_axle_ty*work.w_chassis_z;
  const double s7_348 = zd_rear_axle_ty*work.w_chassis_x;
  const double a_rear_axle_aux2_y = projection.zdd_star[15] + a_rear_axle_aux1_y;
  const double a_rear_axle_aux2_x = a_rear_axle_aux1_x - s7_347 - s7_347;
  const double a_rear_axle_aux2_z = s7_348 + (a_rear_axle_aux1_z + s7_348);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s7_349 = zd_rear_axle_tz*work.w_chassis_y;
  const double s7_350 = zd_rear_axle_tz*work.w_chassis_x;
  const double a_rear_axle_aux3_z = projection.zdd_star[16] + a_rear_axle_aux2_z;
  const double a_rear_axle_aux3_x = s7_349 + (a_rear_axle_aux2_x + s7_349);
  const double a_rear_axle_aux3_y = a_rear_axle_aux2_y - s7_350 - s7_350;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double alpha_rear_axle_aux4_z = projection.zdd_star[17] - work.s7_9;
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  const double alpha_rear_axle_aux4_x = zd_rear_axle_rz*work.w_chassis_y - work.s7_2;
  const double alpha_rear_axle_aux4_y = work.alpha_chassis_y - zd_rear_axle_rz*work.w_chassis_x;
  const double s7_351 = work.w_rear_axle_aux4_z*work.w_rear_axle_aux4_z;
  const double s7_352 = work.w_chassis_x*work.w_rear_axle_aux4_z;
  const double s7_353 = work.w_chassis_y*work.w_rear_axle_aux4_z;
  const double s7_354 = work.s7_3 + s7_351;
  const double s7_355 = work.s7_11 + alpha_rear_axle_aux4_z;
  const double s7_356 = s7_352 - alpha_rear_axle_aux4_y;
  const double s7_357 = work.s7_11 - alpha_rear_axle_aux4_z;
  const double s7_358 = work.s7_10 + s7_351;
  const double s7_359 = alpha_rear_axle_aux4_x + s7_353;
  const double s7_360 = alpha_rear_axle_aux4_y + s7_352;
  const double s7_361 = s7_353 - alpha_rear_axle_aux4_x;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s7_362 = a_rear_axle_aux3_x + z_rear_axle_ty*(work.s7_15 - s7_357);
  const double s7_363 = s7_362 + work.r_rear_axle_aux3_z*(work.s7_17 - s7_360);
  const double a_rear_axle_aux4_x = s7_363 + work.r_rear_axle_aux1_x*(s7_354 - work.s7_6);
  const double s7_364 = a_rear_axle_aux3_y + z_rear_axle_ty*(s7_358 - work.s7_16);
  const double s7_365 = s7_364 + work.r_rear_axle_aux3_z*(work.s7_8 - s7_361);
  const double a_rear_axle_aux4_y = s7_365 + work.r_rear_axle_aux1_x*(work.s7_13 - s7_355);
  const double s7_366 = a_rear_axle_aux3_z + z_rear_axle_ty*(work.s7_7 - s7_359);
  const double a_rear_axle_aux4_z = s7_366 + work.r_rear_axle_aux1_x*(work.s7_14 - s7_356);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double s7_367 = alpha_rear_axle_aux4_x - work.sines[17]*projection.zdd_star[18];
  const double alpha_rear_axle_aux5_x = s7_367 - work.w_rear_axle_aux4_z*work.s4_29;
  const double s7_368 = alpha_rear_axle_aux4_y + work.cosines[17]*projection.zdd_star[18];
  const double alpha_rear_axle_aux5_y = s7_368 - work.w_rear_axle_aux4_z*work.s4_28;
  const double s7_369 = alpha_rear_axle_aux4_z + work.w_chassis_y*work.s4_28;
  const double alpha_rear_axle_aux5_z = s7_369 + work.w_chassis_x*work.s4_29;
  const double s7_370 = work.w_rear_axle_aux5_x*work.w_rear_axle_aux5_x;
  const double s7_371 = work.w_rear_axle_aux5_y*work.w_rear_axle_aux5_y;
  const double s7_372 = work.w_rear_axle_aux5_x*work.w_rear_axle_aux5_y;
  const double s7_373 = work.w_rear_axle_aux4_z*work.w_rear_axle_aux5_x;
  const double s7_374 = work.w_rear_axle_aux4_z*work.w_rear_axle_aux5_y;
  const double s7_375 = s7_351 + s7_371;
  const double s7_376 = alpha_rear_axle_aux5_z + s7_372;
  const double s7_377 = s7_373 - alpha_rear_axle_aux5_y;
  const double s7_378 = s7_372 - alpha_rear_axle_aux5_z;
  const double s7_379 = s7_351 + s7_370;
  const double s7_380 = alpha_rear_axle_aux5_x + s7_374;
  const double s7_381 = alpha_rear_axle_aux5_y + s7_373;
  const double s7_382 = s7_374 - alpha_rear_axle_aux5_x;
  const double s7_383 = s7_370 + s7_371;
  const double s7_384 = a_rear_axle_aux4_x + z_rear_axle_ty*(s7_357 - s7_378);
  const double s7_385 = s7_384 + work.r_rear_axle_aux3_z*(s7_360 - s7_381);
  const double a_rear_axle_aux5_x = s7_385 + work.r_rear_axle_aux1_x*(s7_375 - s7_354);
  const double s7_386 = a_rear_axle_aux4_y + z_rear_axle_ty*(s7_379 - s7_358);
  const double s7_387 = s7_386 + work.r_rear_axle_aux3_z*(s7_361 - s7_382);
  const double a_rear_axle_aux5_y = s7_387 + work.r_rear_axle_aux1_x*(s7_355 - s7_376);
  const double s7_388 = a_rear_axle_aux4_z + z_rear_axle_ty*(s7_359 - s7_380);
  const double s7_389 = s7_388 + work.r_rear_axle_aux3_z*(s7_383 - work.s7_18);
  const double a_rear_axle_aux5_z = s7_389 + work.r_rear_axle_aux1_x*(s7_356 - s7_377);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_390 = work.R_rear_axle_aux5_x_x*projection.zdd_star[19];
  const double s7_391 = alpha_rear_axle_aux5_x + s7_390 - work.w_rear_axle_aux4_z*work.s4_31;
  work.alpha_rear_axle_x = s7_391 - work.w_rear_axle_aux5_y*work.s4_32;
  const double s7_392 = alpha_rear_axle_aux5_y + work.w_rear_axle_aux5_x*work.s4_32;
  const double s7_393 = work.R_rear_axle_aux5_y_x*projection.zdd_star[19];
  work.alpha_rear_axle_y = s7_392 + work.w_rear_axle_aux4_z*work.s4_30 + s7_393;
  const double s7_394 = alpha_rear_axle_aux5_z + work.w_rear_axle_aux5_x*work.s4_31;
  const double s7_395 = s7_394 - work.w_rear_axle_aux5_y*work.s4_30;
  work.alpha_rear_axle_z = s7_395 - work.sines[18]*projection.zdd_star[19];
  const double s7_396 = work.w_rear_axle_x*work.w_rear_axle_x;
  const double s7_397 = work.w_rear_axle_y*work.w_rear_axle_y;
  const double s7_398 = work.w_rear_axle_z*work.w_rear_axle_z;
  const double s7_399 = work.w_rear_axle_x*work.w_rear_axle_y;
  const double s7_400 = work.w_rear_axle_x*work.w_rear_axle_z;
  const double s7_401 = work.w_rear_axle_y*work.w_rear_axle_z;
  work.s7_402 = s7_397 + s7_398;
  work.s7_403 = work.alpha_rear_axle_z + s7_399;
  work.s7_404 = s7_400 - work.alpha_rear_axle_y;
  work.s7_405 = s7_399 - work.alpha_rear_axle_z;
  work.s7_406 = s7_396 + s7_398;
  work.s7_407 = work.alpha_rear_axle_x + s7_401;
  work.s7_408 = work.alpha_rear_axle_y + s7_400;
  work.s7_409 = s7_401 - work.alpha_rear_axle_x;
  work.s7_410 = s7_396 + s7_397;
  const double s7_411 = a_rear_axle_aux5_x + z_rear_axle_ty*(s7_378 - work.s7_405);
  const double s7_412 = s7_411 + work.r_rear_axle_aux3_z*(s7_381 - work.s7_408);
  work.a_rear_axle_x = s7_412 + work.r_rear_axle_aux1_x*(work.s7_402 - s7_375);
  const double s7_413 = a_rear_axle_aux5_y + z_rear_axle_ty*(work.s7_406 - s7_379);
  const double s7_414 = s7_413 + work.r_rear_axle_aux3_z*(s7_382 - work.s7_409);
  work.a_rear_axle_y = s7_414 + work.r_rear_axle_aux1_x*(s7_376 - work.s7_403);
  const double s7_415 = a_rear_axle_aux5_z + z_rear_axle_ty*(s7_380 - work.s7_407);
  const double s7_416 = s7_415 + work.r_rear_axle_aux3_z*(work.s7_410 - s7_383);
  work.a_rear_axle_z = s7_416 + work.r_rear_axle_aux1_x*(s7_377 - work.s7_404);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s7_417 = work.alpha_rear_axle_x + work.w_rear_axle_y*work.s4_35;
  work.alpha_wheel_rear_left_x = s7_417 - work.w_rear_axle_z*work.s4_34;
  const double s7_418 = work.alpha_rear_axle_y + work.w_rear_axle_z*work.s4_33;
  work.alpha_wheel_rear_left_y = s7_418 - work.w_rear_axle_x*work.s4_35;
  const double s7_419 = work.alpha_rear_axle_z + work.w_rear_axle_x*work.s4_34;
  work.alpha_wheel_rear_left_z = s7_419 - work.w_rear_axle_y*work.s4_33;
  const double s7_420 = work.w_wheel_rear_left_x*work.w_wheel_rear_left_x;
  const double s7_421 = work.w_wheel_rear_left_y*work.w_wheel_rear_left_y;
  const double s7_422 = work.w_wheel_rear_left_z*work.w_wheel_rear_left_z;
  const double s7_423 = work.w_wheel_rear_left_x*work.w_wheel_rear_left_y;
  const double s7_424 = work.w_wheel_rear_left_x*work.w_wheel_rear_left_z;
  const double s7_425 = work.w_wheel_rear_left_y*work.w_wheel_rear_left_z;
  work.s7_426 = s7_421 + s7_422;
  work.s7_427 = work.alpha_wheel_rear_left_z + s7_423;
  work.s7_428 = s7_424 - work.alpha_wheel_rear_left_y;
  work.s7_429 = s7_423 - work.alpha_wheel_rear_left_z;
  work.s7_430 = s7_420 + s7_422;
  work.s7_431 = work.alpha_wheel_rear_left_x + s7_425;
  work.s7_432 = work.alpha_wheel_rear_left_y + s7_424;
  work.s7_433 = s7_425 - work.alpha_wheel_rear_left_x;
  work.s7_434 = s7_420 + s7_421;
  const double s7_435 = work.r_wheel_rear_left_y*(work.s7_405 - work.s7_429);
  const double s7_436 = work.r_wheel_rear_left_z*(work.s7_408 - work.s7_432);
  const double s7_437 = work.r_wheel_rear_left_x*(work.s7_426 - work.s7_402);
  work.a_wheel_rear_left_x = work.a_rear_axle_x + s7_435 + s7_436 + s7_437;
  const double s7_438 = work.r_wheel_rear_left_y*(work.s7_430 - work.s7_406);
  const double s7_439 = work.r_wheel_rear_left_z*(work.s7_409 - work.s7_433);
  const double s7_440 = work.r_wheel_rear_left_x*(work.s7_403 - work.s7_427);
  work.a_wheel_rear_left_y = work.a_rear_axle_y + s7_438 + s7_439 + s7_440;
  const double s7_441 = work.r_wheel_rear_left_y*(work.s7_407 - work.s7_431);
  const double s7_442 = work.r_wheel_rear_left_z*(work.s7_434 - work.s7_410);
  const double s7_443 = work.r_wheel_rear_left_x*(work.s7_404 - work.s7_428);
  work.a_wheel_rear_left_z = work.a_rear_axle_z + s7_441 + s7_442 + s7_443;
  // arb_rear_left: arb_rear_left, revolute, chassis
  work.alpha_arb_rear_left_y = projection.zdd_star[20] + work.alpha_chassis_y;
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  work.s7_444 = work.s7_2 + zd_arb_rear_left*work.w_chassis_z;
  work.alpha_arb_rear_left_z = zd_arb_rear_left*work.w_chassis_x - work.s7_9;
  const double s7_445 = work.w_arb_rear_left_y*work.w_arb_rear_left_y;
  const double s7_446 = work.w_chassis_x*work.w_arb_rear_left_y;
  const double s7_447 = work.w_chassis_z*work.w_arb_rear_left_y;
  work.s7_448 = work.s7_4 + s7_445;
  work.s7_449 = work.alpha_arb_rear_left_z + s7_446;
  work.s7_450 = work.s7_12 - work.alpha_arb_rear_left_y;
  work.s7_451 = s7_446 - work.alpha_arb_rear_left_z;
  work.s7_452 = s7_447 - work.s7_444;
  work.s7_453 = work.s7_12 + work.alpha_arb_rear_left_y;
  work.s7_454 = work.s7_444 + s7_447;
  work.s7_455 = work.s7_10 + s7_445;
  const double s7_456 = 0.44999999999999996*(work.s7_17 - work.s7_453);
  const double s7_457 = 0.45*(work.s7_15 - work.s7_451) - work.s7_1 - s7_456;
  work.a_arb_rear_left_x = s7_457 - 3.3000000000000003*(work.s7_448 - work.s7_6);
  const double s7_458 = work.a_chassis_y - 0.44999999999999996*(work.s7_8 - work.s7_454);
  work.a_arb_rear_left_y = s7_458 - 3.3000000000000003*(work.s7_13 - work.s7_449);
  const double s7_459 = work.a_chassis_z + 0.45*(work.s7_7 - work.s7_452);
  const double s7_460 = s7_459 - 0.44999999999999996*(work.s7_455 - work.s7_18);
  work.a_arb_rear_left_z = s7_460 - 3.3000000000000003*(work.s7_14 - work.s7_450);
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s7_461 = work.alpha_rear_axle_x + work.w_rear_axle_y*work.s4_38;
  work.alpha_wheel_rear_right_x = s7_461 - work.w_rear_axle_z*work.s4_37;
  const double s7_462 = work.alpha_rear_axle_y + work.w_rear_axle_z*work.s4_36;
  work.alpha_wheel_rear_right_y = s7_462 - work.w_rear_axle_x*work.s4_38;
  const double s7_463 = work.alpha_rear_axle_z + work.w_rear_axle_x*work.s4_37;
  work.alpha_wheel_rear_right_z = s7_463 - work.w_rear_axle_y*work.s4_36;
  const double s7_464 = work.w_wheel_rear_right_x*work.w_wheel_rear_right_x;
  const double s7_465 = work.w_wheel_rear_right_y*work.w_wheel_rear_right_y;
  const double s7_466 = work.w_wheel_rear_right_z*work.w_wheel_rear_right_z;
  const double s7_467 = work.w_wheel_rear_right_x*work.w_wheel_rear_right_y;
  const double s7_468 = work.w_wheel_rear_right_x*work.w_wheel_rear_right_z;
  const double s7_469 = work.w_wheel_rear_right_y*work.w_wheel_rear_right_z;
  work.s7_470 = s7_465 + s7_466;
  work.s7_471 = work.alpha_wheel_rear_right_z + s7_467;
  work.s7_472 = s7_468 - work.alpha_wheel_rear_right_y;
  work.s7_473 = s7_467 - work.alpha_wheel_rear_right_z;
  work.s7_474 = s7_464 + s7_466;
  work.s7_475 = work.alpha_wheel_rear_right_x + s7_469;
  work.s7_476 = work.alpha_wheel_rear_right_y + s7_468;
  work.s7_477 = s7_469 - work.alpha_wheel_rear_right_x;
  work.s7_478 = s7_464 + s7_465;
  const double s7_479 = work.r_wheel_rear_right_y*(work.s7_405 - work.s7_473);
  const double s7_480 = work.r_wheel_rear_right_z*(work.s7_408 - work.s7_476);
  const double s7_481 = work.r_wheel_rear_right_x*(work.s7_470 - work.s7_402);
  work.a_wheel_rear_right_x = work.a_rear_axle_x + s7_479 + s7_480 + s7_481;
  const double s7_482 = work.r_wheel_rear_right_y*(work.s7_474 - work.s7_406);
  const double s7_483 = work.r_wheel_rear_right_z*(work.s7_409 - work.s7_477);
  const double s7_484 = work.r_wheel_rear_right_x*(work.s7_403 - work.s7_471);
  work.a_wheel_rear_right_y = work.a_rear_axle_y + s7_482 + s7_483 + s7_484;
  const double s7_485 = work.r_wheel_rear_right_y*(work.s7_407 - work.s7_475);
  const double s7_486 = work.r_wheel_rear_right_z*(work.s7_478 - work.s7_410);
  const double s7_487 = work.r_wheel_rear_right_x*(work.s7_404 - work.s7_472);
  work.a_wheel_rear_right_z = work.a_rear_axle_z + s7_485 + s7_486 + s7_487;
  // arb_rear_right: arb_rear_right, revolute, chassis
  work.alpha_arb_rear_right_y = projection.zdd_star[21] + work.alpha_chassis_y;
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  work.s7_488 = work.s7_2 + zd_arb_rear_right*work.w_chassis_z;
  work.alpha_arb_rear_right_z = zd_arb_rear_right*work.w_chassis_x - work.s7_9;
  const double s7_489 = work.w_arb_rear_right_y*work.w_arb_rear_right_y;
  const double s7_490 = work.w_chassis_x*work.w_arb_rear_right_y;
  const double s7_491 = work.w_chassis_z*work.w_arb_rear_right_y;
  work.s7_492 = work.s7_4 + s7_489;
  work.s7_493 = work.alpha_arb_rear_right_z + s7_490;
  work.s7_494 = work.s7_12 - work.alpha_arb_rear_right_y;
  work.s7_495 = s7_490 - work.alpha_arb_rear_right_z;
  work.s7_496 = s7_491 - work.s7_488;
  work.s7_497 = work.s7_12 + work.alpha_arb_rear_right_y;
  work.s7_498 = work.s7_488 + s7_491;
  work.s7_499 = work.s7_10 + s7_489;
  const double s7_500 = 0.44999999999999996*(work.s7_17 - work.s7_497);
  const double s7_501 = work.s7_1 + 0.45*(work.s7_15 - work.s7_495) + s7_500;
  work.s7_502 = s7_501 + 3.3000000000000003*(work.s7_492 - work.s7_6);
  const double s7_503 = work.a_chassis_y - 0.44999999999999996*(work.s7_8 - work.s7_498);
  work.a_arb_rear_right_y = s7_503 - 3.3000000000000003*(work.s7_13 - work.s7_493);
  const double s7_504 = work.a_chassis_z - 0.45*(work.s7_7 - work.s7_496);
  const double s7_505 = s7_504 - 0.44999999999999996*(work.s7_499 - work.s7_18);
  work.a_arb_rear_right_z = s7_505 - 3.3000000000000003*(work.s7_14 - work.s7_494);
  // arb_link_front_left
  const double s7_506 = work.a_carrier_left_x + work.s1_500*work.s7_95 + work.s1_503*work.s7_98;
  const double s7_507 = work.a_carrier_left_y + work.s1_503*work.s7_99 + work.s1_497*work.s7_93;
  const double s7_508 = work.a_carrier_left_z + work.s1_500*work.s7_97 + work.s1_497*work.s7_94;
  work.s7_509 = 0.3333333333333333*(s7_506 - work.s1_497*work.s7_92);
  work.s7_510 = 0.3333333333333333*(s7_507 - work.s1_500*work.s7_96);
  work.s7_511 = 0.3333333333333333*(s7_508 - work.s1_503*work.s7_100);
  const double s7_512 = 0.72*work.s7_16;
  const double s7_513 = work.a_arb_front_left_x + 0.72*work.s7_157 + work.s1_507*work.s7_159;
  const double s7_514 = work.a_arb_front_left_y - s7_512 + work.s1_507*work.s7_160;
  const double s7_515 = work.a_arb_front_left_z + 0.72*work.s7_158 + work.s1_505*work.s7_156;
  work.s7_516 = 0.3333333333333333*(s7_513 - work.s1_505*work.s7_154);
  work.s7_517 = 0.3333333333333333*(s7_514 + work.s1_505*work.s7_155);
  work.s7_518 = 0.3333333333333333*(s7_515 - work.s1_507*work.s7_161);
  // arb_link_front_right
  const double s7_519 = work.a_carrier_right_x + work.s1_529*work.s7_243;
  const double s7_520 = work.a_carrier_right_y + work.s1_532*work.s7_247;
  const double s7_521 = work.a_carrier_right_z + work.s1_529*work.s7_245;
  const double s7_522 = s7_519 + work.s1_532*work.s7_246 - work.s1_525*work.s7_240;
  work.s7_523 = 0.3333333333333333*s7_522;
  const double s7_524 = s7_520 + work.s1_525*work.s7_241 - work.s1_529*work.s7_244;
  work.s7_525 = 0.3333333333333333*s7_524;
  const double s7_526 = s7_521 + work.s1_525*work.s7_242 - work.s1_532*work.s7_248;
  work.s7_527 = 0.3333333333333333*s7_526;
  const double s7_528 = work.a_arb_front_right_x + work.s1_536*work.s7_307;
  const double s7_529 = work.a_arb_front_right_y + s7_512 + work.s1_536*work.s7_308;
  const double s7_530 = work.a_arb_front_right_z + work.s1_534*work.s7_304;
  work.s7_531 = 0.3333333333333333*(s7_528 - work.s1_534*work.s7_302 - 0.72*work.s7_305);
  work.s7_532 = 0.3333333333333333*(s7_529 + work.s1_534*work.s7_303);
  work.s7_533 = 0.3333333333333333*(s7_530 - work.s1_536*work.s7_309 - 0.72*work.s7_306);
  // drag_link
  work.s7_534 = a_bell_crank_x - 0.6*work.s7_338;
  work.s7_535 = a_bell_crank_y - 0.6*work.s7_339;
  work.s7_536 = a_bell_crank_z + 0.6*work.s7_18;
  work.s7_537 = 1.5*(work.s7_534 + work.s1_553*work.s7_335 - work.s1_554*work.s7_332);
  work.s7_538 = 1.5*(work.s7_535 + work.s1_554*work.s7_333 - work.s1_553*work.s7_336);
  work.s7_539 = 1.5*(work.s7_536 + work.s1_553*work.s7_337 + work.s1_554*work.s7_334);
  work.s7_540 = work.a_pitman_arm_x + 0.5*work.s7_321;
  work.s7_541 = work.a_pitman_arm_y - 0.5*work.s7_16;
  work.s7_542 = work.a_pitman_arm_z + 0.5*work.s7_322;
  work.s7_543 = 1.5*(work.s7_540 - work.s1_556*work.s7_323 - work.s1_555*work.s7_318);
  work.s7_544 = 1.5*(work.s7_541 + work.s1_555*work.s7_319 - work.s1_556*work.s7_324);
  work.s7_545 = 1.5*(work.s7_542 + work.s1_556*work.s7_325 + work.s1_555*work.s7_320);
  // tie_rod_left
  const double s7_546 = work.a_carrier_left_x + work.s1_576*work.s7_95 + work.s1_579*work.s7_98;
  const double s7_547 = work.a_carrier_left_y + work.s1_579*work.s7_99 + work.s1_573*work.s7_93;
  const double s7_548 = work.a_carrier_left_z + work.s1_576*work.s7_97 + work.s1_573*work.s7_94;
  work.s7_549 = 1.1666666666666667*(s7_546 - work.s1_573*work.s7_92);
  work.s7_550 = 1.1666666666666667*(s7_547 - work.s1_576*work.s7_96);
  work.s7_551 = 1.1666666666666667*(s7_548 - work.s1_579*work.s7_100);
  const double s7_552 = work.s7_534 + work.s1_584*work.s7_335 - work.s1_585*work.s7_332;
  work.s7_553 = 1.1666666666666667*s7_552;
  const double s7_554 = work.s7_535 + work.s1_585*work.s7_333 - work.s1_584*work.s7_336;
  work.s7_555 = 1.1666666666666667*s7_554;
  const double s7_556 = work.s7_536 + work.s1_584*work.s7_337 + work.s1_585*work.s7_334;
  work.s7_557 = 1.1666666666666667*s7_556;
  // tie_rod_right
  const double s7_558 = work.a_carrier_right_x + work.s1_607*work.s7_243;
  const double s7_559 = work.a_carrier_right_y + work.s1_609*work.s7_247;
  const double s7_560 = work.a_carrier_right_z + work.s1_607*work.s7_245;
  const double s7_561 = s7_558 + work.s1_609*work.s7_246 - work.s1_604*work.s7_240;
  work.s7_562 = 1.1666666666666667*s7_561;
  const double s7_563 = s7_559 + work.s1_604*work.s7_241 - work.s1_607*work.s7_244;
  work.s7_564 = 1.1666666666666667*s7_563;
  const double s7_565 = s7_560 + work.s1_604*work.s7_242 - work.s1_609*work.s7_248;
  work.s7_566 = 1.1666666666666667*s7_565;
  const double s7_567 = work.s7_534 - work.s1_610*work.s7_335 - work.s1_611*work.s7_332;
  work.s7_568 = 1.1666666666666667*s7_567;
  const double s7_569 = work.s7_535 + work.s1_610*work.s7_336 + work.s1_611*work.s7_333;
  work.s7_570 = 1.1666666666666667*s7_569;
  const double s7_571 = work.s7_536 + work.s1_611*work.s7_334 - work.s1_610*work.s7_337;
  work.s7_572 = 1.1666666666666667*s7_571;
  // long_rod_left
  const double s7_573 = work.a_rear_axle_x + work.s1_639*work.s7_405 + work.s1_640*work.s7_408;
  const double s7_574 = work.a_rear_axle_y + work.s1_640*work.s7_409 + work.s1_637*work.s7_403;
  const double s7_575 = work.a_rear_axle_z + work.s1_639*work.s7_407 + work.s1_637*work.s7_404;
  work.s7_576 = 3.0*(s7_573 - work.s1_637*work.s7_402);
  work.s7_577 = 3.0*(s7_574 - work.s1_639*work.s7_406);
  work.s7_578 = 3.0*(s7_575 - work.s1_640*work.s7_410);
  work.s7_579 = 0.55*work.s7_576;
  const double s7_580 = 0.55*work.s7_15;
  const double s7_581 = 1.6*work.s7_6 - 0.55*work.s7_17;
  const double s7_582 = 0.55*work.s7_16;
  const double s7_583 = 0.55*work.s7_8 + 1.6*work.s7_13;
  const double s7_584 = 0.55*work.s7_7;
  const double s7_585 = work.a_chassis_z + (0.55*work.s7_18 - 1.6*work.s7_14);
  work.s7_586 = 3.0*(s7_580 + s7_581 - work.s7_1);
  work.s7_587 = 3.0*(work.a_chassis_y - s7_582 - s7_583);
  work.s7_588 = 3.0*(s7_584 + s7_585);
  // diag_rod_left
  const double s7_589 = work.a_rear_axle_x + work.s1_660*work.s7_405 + work.s1_662*work.s7_408;
  const double s7_590 = work.a_rear_axle_y + work.s1_662*work.s7_409 + work.s1_658*work.s7_403;
  const double s7_591 = work.a_rear_axle_z + work.s1_660*work.s7_407 + work.s1_658*work.s7_404;
  work.s7_592 = 2.6666666666666665*(s7_589 - work.s1_658*work.s7_402);
  work.s7_593 = 2.6666666666666665*(s7_590 - work.s1_660*work.s7_406);
  work.s7_594 = 2.6666666666666665*(s7_591 - work.s1_662*work.s7_410);
  const double s7_595 = 0.4*work.s7_15;
  const double s7_596 = 1.6999999999999997*work.s7_6 - 0.15000000000000002*work.s7_17;
  const double s7_597 = 0.4*work.s7_16;
  const double s7_598 = 0.15000000000000002*work.s7_8 + 1.6999999999999997*work.s7_13;
  const double s7_599 = 0.4*work.s7_7;
  const double s7_600 = 0.15000000000000002*work.s7_18 - 1.6999999999999997*work.s7_14;
  const double s7_601 = work.a_chassis_z + s7_600;
  work.s7_602 = 2.6666666666666665*(s7_595 + s7_596 - work.s7_1);
  work.s7_603 = 2.6666666666666665*(work.a_chassis_y - s7_597 - s7_598);
  work.s7_604 = 2.6666666666666665*(s7_599 + s7_601);
  // arb_link_rear_left
  const double s7_605 = work.a_rear_axle_x + work.s1_684*work.s7_405 + work.s1_687*work.s7_408;
  const double s7_606 = work.a_rear_axle_y + work.s1_687*work.s7_409 + work.s1_683*work.s7_403;
  const double s7_607 = work.a_rear_axle_z + work.s1_684*work.s7_407 + work.s1_683*work.s7_404;
  work.s7_608 = 0.3333333333333333*(s7_605 - work.s1_683*work.s7_402);
  work.s7_609 = 0.3333333333333333*(s7_606 - work.s1_684*work.s7_406);
  work.s7_610 = 0.3333333333333333*(s7_607 - work.s1_687*work.s7_410);
  const double s7_611 = 0.6*work.s7_16;
  const double s7_612 = work.a_arb_rear_left_x + 0.6*work.s7_451 - work.s1_689*work.s7_453;
  const double s7_613 = work.a_arb_rear_left_y - s7_611 + work.s1_688*work.s7_449;
  const double s7_614 = work.a_arb_rear_left_z + 0.6*work.s7_452 + work.s1_689*work.s7_455;
  work.s7_615 = 0.3333333333333333*(s7_612 - work.s1_688*work.s7_448);
  work.s7_616 = 0.3333333333333333*(s7_613 - work.s1_689*work.s7_454);
  work.s7_617 = 0.3333333333333333*(s7_614 + work.s1_688*work.s7_450);
  // long_rod_right
  const double s7_618 = work.a_rear_axle_x + work.s1_708*work.s7_405 + work.s1_709*work.s7_408;
  const double s7_619 = work.a_rear_axle_y + work.s1_709*work.s7_409 + work.s1_707*work.s7_403;
  const double s7_620 = work.a_rear_axle_z + work.s1_708*work.s7_407 + work.s1_707*work.s7_404;
  work.s7_621 = 3.0*(s7_618 - work.s1_707*work.s7_402);
  work.s7_622 = 3.0*(s7_619 - work.s1_708*work.s7_406);
  work.s7_623 = 3.0*(s7_620 - work.s1_709*work.s7_410);
  work.s7_624 = 0.55*work.s7_621;
  work.s7_625 = 3.0*(s7_581 - s7_580 - work.s7_1);
  work.s7_626 = 3.0*(work.a_chassis_y + s7_582 - s7_583);
  work.s7_627 = 3.0*(s7_585 - s7_584);
  // diag_rod_right
  const double s7_628 = work.a_rear_axle_x + work.s1_724*work.s7_405 + work.s1_725*work.s7_408;
  const double s7_629 = work.a_rear_axle_y + work.s1_725*work.s7_409 + work.s1_723*work.s7_403;
  const double s7_630 = work.a_rear_axle_z + work.s1_724*work.s7_407 + work.s1_723*work.s7_404;
  work.s7_631 = 2.6666666666666665*(s7_628 - work.s1_723*work.s7_402);
  work.s7_632 = 2.6666666666666665*(s7_629 - work.s1_724*work.s7_406);
  work.s7_633 = 2.6666666666666665*(s7_630 - work.s1_725*work.s7_410);
  work.s7_634 = 2.6666666666666665*(s7_596 - s7_595 - work.s7_1);
  work.s7_635 = 2.6666666666666665*(work.a_chassis_y + s7_597 - s7_598);
  work.s7_636 = 2.6666666666666665*(s7_601 - s7_599);
  // arb_link_rear_right
  const double s7_637 = work.a_rear_axle_x + work.s1_740*work.s7_405 + work.s1_741*work.s7_408;
  const double s7_638 = work.a_rear_axle_y + work.s1_741*work.s7_409 + work.s1_739*work.s7_403;
  const double s7_639 = work.a_rear_axle_z + work.s1_740*work.s7_407 + work.s1_739*work.s7_404;
  work.s7_640 = 0.3333333333333333*(s7_637 - work.s1_739*work.s7_402);
  work.s7_641 = 0.3333333333333333*(s7_638 - work.s1_740*work.s7_406);
  work.s7_642 = 0.3333333333333333*(s7_639 - work.s1_741*work.s7_410);
  const double s7_643 = work.s7_502 + 0.6*work.s7_495 + work.s1_743*work.s7_497;
  const double s7_644 = work.a_arb_rear_right_y + s7_611 + work.s1_742*work.s7_493;
  const double s7_645 = work.a_arb_rear_right_z + work.s1_743*work.s7_499;
  work.s7_646 = 0.3333333333333333*(s7_643 + work.s1_742*work.s7_492);
  work.s7_647 = 0.3333333333333333*(s7_644 - work.s1_743*work.s7_498);
  work.s7_648 = 0.3333333333333333*(s7_645 + work.s1_742*work.s7_494 - 0.6*work.s7_496);
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s7_649 = 0.24897456123052653*work.s7_17 - work.s7_1;
  const double s7_650 = work.a_chassis_y + 0.24897456123052653*work.s7_8;
  const double s7_651 = work.a_chassis_z - 0.24897456123052653*work.s7_18;
  work.s7_652 = 13522.666666666668*(s7_649 + 0.0027607966870439754*work.s7_6);
  work.s7_653 = 13522.666666666668*(s7_650 - 0.0027607966870439754*work.s7_13);
  work.s7_654 = 13522.666666666668*(s7_651 - 0.0027607966870439754*work.s7_14);
  work.s7_655 = 150070.8160441727*work.w_chassis_y;
  // lower_arm_left: lower_arm_left, revolute, chassis
  work.s7_656 = 3.6*work.s7_6;
  const double s7_657 = work.a_lower_arm_left_x - work.s7_656 + work.s1_77*work.s7_25;
  const double s7_658 = work.a_lower_arm_left_y + work.s1_79*work.s7_29 + 3.6*work.s7_23;
  const double s7_659 = work.a_lower_arm_left_z + work.s1_77*work.s7_27 + 3.6*work.s7_24;
  work.s7_660 = 25.0*(s7_657 + work.s1_79*work.s7_28);
  work.s7_661 = 25.0*(s7_658 - work.s1_77*work.s7_26);
  work.s7_662 = 25.0*(s7_659 - work.s1_79*work.s7_30);
  work.s7_663 = work.s1_83*work.w_chassis_y + work.s1_85*work.w_chassis_z;
  work.s7_664 = work.s1_85*work.w_chassis_y + work.s1_84*work.w_chassis_z;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_665 = work.a_carrier_left_x + work.s1_95*work.s7_95 + work.s1_99*work.s7_98;
  const double s7_666 = work.a_carrier_left_y + work.s1_99*work.s7_99 + work.s1_91*work.s7_93;
  const double s7_667 = work.a_carrier_left_z + work.s1_95*work.s7_97 + work.s1_91*work.s7_94;
  work.s7_668 = 113.0*(s7_665 - work.s1_91*work.s7_92);
  work.s7_669 = 113.0*(s7_666 - work.s1_95*work.s7_96);
  work.s7_670 = 113.0*(s7_667 - work.s1_99*work.s7_100);
  const double s7_671 = work.s1_133*work.w_carrier_left_y + work.s1_135*work.w_carrier_left_z;
  work.s7_672 = s7_671 + work.s1_127*work.w_carrier_left_x;
  const double s7_673 = work.s1_129*work.w_carrier_left_y + work.s1_137*work.w_carrier_left_z;
  work.s7_674 = s7_673 + work.s1_133*work.w_carrier_left_x;
  const double s7_675 = work.s1_137*work.w_carrier_left_y + work.s1_131*work.w_carrier_left_z;
  work.s7_676 = s7_675 + work.s1_135*work.w_carrier_left_x;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s7_677 = work.a_wheel_front_left_x + work.r_wheel_front_left_y*work.s7_119;
  const double s7_678 = s7_677 + work.r_wheel_front_left_z*work.s7_122;
  const double s7_679 = work.a_wheel_front_left_y + work.r_wheel_front_left_z*work.s7_123;
  const double s7_680 = s7_679 + work.r_wheel_front_left_x*work.s7_117;
  const double s7_681 = work.a_wheel_front_left_z + work.r_wheel_front_left_y*work.s7_121;
  const double s7_682 = s7_681 + work.r_wheel_front_left_x*work.s7_118;
  work.s7_683 = 105.0*(s7_678 - work.r_wheel_front_left_x*work.s7_116);
  work.s7_684 = 105.0*(s7_680 - work.r_wheel_front_left_y*work.s7_120);
  work.s7_685 = 105.0*(s7_682 - work.r_wheel_front_left_z*work.s7_124);
  const double s7_686 = work.s1_157*work.w_wheel_front_left_y;
  const double s7_687 = s7_686 + work.s1_159*work.w_wheel_front_left_z;
  const double s7_688 = s7_687 + work.s1_151*work.w_wheel_front_left_x;
  const double s7_689 = work.s1_153*work.w_wheel_front_left_y;
  const double s7_690 = s7_689 + work.s1_161*work.w_wheel_front_left_z;
  const double s7_691 = s7_690 + work.s1_157*work.w_wheel_front_left_x;
  const double s7_692 = work.s1_161*work.w_wheel_front_left_y;
  const double s7_693 = s7_692 + work.s1_155*work.w_wheel_front_left_z;
  const double s7_694 = s7_693 + work.s1_159*work.w_wheel_front_left_x;
  const double s7_695 = work.w_wheel_front_left_y*s7_694 - work.w_wheel_front_left_z*s7_691;
  const double s7_696 = s7_695 + work.s1_157*work.alpha_wheel_front_left_y;
  const double s7_697 = s7_696 + work.s1_159*work.alpha_wheel_front_left_z;
  const double s7_698 = s7_697 + work.s1_151*work.alpha_wheel_front_left_x;
  const double s7_699 = s7_698 + work.r_wheel_front_left_y*work.s7_685;
  work.s7_700 = s7_699 - work.r_wheel_front_left_z*work.s7_684;
  const double s7_701 = work.w_wheel_front_left_z*s7_688 - work.w_wheel_front_left_x*s7_694;
  const double s7_702 = s7_701 + work.s1_153*work.alpha_wheel_front_left_y;
  const double s7_703 = s7_702 + work.s1_161*work.alpha_wheel_front_left_z;
  const double s7_704 = s7_703 + work.s1_157*work.alpha_wheel_front_left_x;
  const double s7_705 = s7_704 + work.r_wheel_front_left_z*work.s7_683;
  work.s7_706 = s7_705 - work.r_wheel_front_left_x*work.s7_685;
  const double s7_707 = work.w_wheel_front_left_x*s7_691 - work.w_wheel_front_left_y*s7_688;
  const double s7_708 = s7_707 + work.s1_161*work.alpha_wheel_front_left_y;
  const double s7_709 = s7_708 + work.s1_155*work.alpha_wheel_front_left_z;
  const double s7_710 = s7_709 + work.s1_159*work.alpha_wheel_front_left_x;
  const double s7_711 = s7_710 + work.r_wheel_front_left_x*work.s7_684;
  work.s7_712 = s7_711 - work.r_wheel_front_left_y*work.s7_683;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double s7_713 = work.a_upper_arm_left_x - work.s7_656 + work.s1_175*work.s7_140;
  const double s7_714 = work.a_upper_arm_left_y + work.s1_177*work.s7_144 + 3.6*work.s7_138;
  const double s7_715 = work.a_upper_arm_left_z + work.s1_175*work.s7_142 + 3.6*work.s7_139;
  work.s7_716 = 15.0*(s7_713 + work.s1_177*work.s7_143);
  work.s7_717 = 15.0*(s7_714 - work.s1_175*work.s7_141);
  work.s7_718 = 15.0*(s7_715 - work.s1_177*work.s7_145);
  work.s7_719 = work.s1_181*work.w_chassis_y + work.s1_183*work.w_chassis_z;
  work.s7_720 = work.s1_183*work.w_chassis_y + work.s1_182*work.w_chassis_z;
  const double s7_721 = work.w_chassis_y*work.s7_720 - work.w_chassis_z*work.s7_719;
  const double s7_722 = s7_721 + 0.2*work.alpha_upper_arm_left_x + work.s1_175*work.s7_718;
  work.s7_723 = s7_722 - work.s1_177*work.s7_717;
  // arb_front_left: arb_front_left, revolute, chassis
  work.s7_724 = 0.5169230769230769*work.s7_16;
  const double s7_725 = work.a_arb_front_left_x + 0.5169230769230769*work.s7_157;
  work.s7_726 = s7_725 + work.s1_194*work.s7_159 - work.s1_192*work.s7_154;
  const double s7_727 = work.a_arb_front_left_y - work.s7_724 + work.s1_194*work.s7_160;
  work.s7_728 = s7_727 + work.s1_192*work.s7_155;
  const double s7_729 = work.a_arb_front_left_z + 0.5169230769230769*work.s7_158;
  work.s7_730 = s7_729 + work.s1_192*work.s7_156;
}

/// Part 5 of compute_chosen_accelerations: step 7: accelerations Zdot and accumulated forces QR -
/// PR (51), (52).
[[gnu::noinline]] void compute_chosen_accelerations_5(const State& state, const double* tau,
    ChosenAccelerationsWork& __restrict work) noexcept {
  // --- step 7: accelerations Zdot and accumulated forces QR - PR (51), (52), continued ---
  // arb_front_left: arb_front_left, revolute, chassis
  work.s7_731 = 8.666666666666666*work.s7_726;
  work.s7_732 = 8.666666666666666*work.s7_728;
  work.s7_733 = 8.666666666666666*(work.s7_730 - work.s1_194*work.s7_161);
  const double s7_734 = work.s1_197*work.w_arb_front_left_y + work.s1_207*work.w_chassis_z;
  work.s7_735 = s7_734 + work.s1_205*work.w_chassis_x;
  const double s7_736 = 0.1304*work.w_arb_front_left_y + work.s1_197*work.w_chassis_x;
  work.s7_737 = s7_736 - work.s1_201*work.w_chassis_z;
  const double s7_738 = work.s1_206*work.w_chassis_z + work.s1_207*work.w_chassis_x;
  work.s7_739 = s7_738 - work.s1_201*work.w_arb_front_left_y;
  work.s7_740 = work.s7_509 + work.s7_731;
  work.s7_741 = work.s7_511 + work.s7_733;
  const double s7_742 = work.s1_505*work.s7_511 - work.s1_507*work.s7_509;
  const double s7_743 = s7_742 - work.w_chassis_z*work.s7_735 + work.w_chassis_x*work.s7_739;
  const double s7_744 = s7_743 - 0.1304*work.alpha_arb_front_left_y;
  const double s7_745 = s7_744 + work.s1_201*work.alpha_arb_front_left_z;
  const double s7_746 = s7_745 + work.s1_197*work.s7_150 - work.s1_194*work.s7_731;
  work.s7_747 = s7_746 + work.s1_192*work.s7_733;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double s7_748 = work.s1_216*work.s7_172 - work.s7_656 - work.s7_179;
  const double s7_749 = work.a_lower_arm_right_y + 3.6*work.s7_170 - work.s1_218*work.s7_176;
  const double s7_750 = work.a_lower_arm_right_z + work.s1_216*work.s7_174;
  work.s7_751 = 25.0*(s7_748 - work.s1_218*work.s7_175);
  work.s7_752 = 25.0*(s7_749 - work.s1_216*work.s7_173);
  work.s7_753 = 25.0*(s7_750 + work.s1_218*work.s7_177 + 3.6*work.s7_171);
  work.s7_754 = work.s1_222*work.w_chassis_y + work.s1_224*work.w_chassis_z;
  work.s7_755 = work.s1_224*work.w_chassis_y + work.s1_223*work.w_chassis_z;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_756 = work.a_carrier_right_x + work.s1_234*work.s7_243;
  const double s7_757 = work.a_carrier_right_y + work.s1_237*work.s7_247;
  const double s7_758 = work.a_carrier_right_z + work.s1_234*work.s7_245;
  const double s7_759 = 113.0*(s7_756 + work.s1_237*work.s7_246 - work.s1_230*work.s7_240);
  const double s7_760 = 113.0*(s7_757 + work.s1_230*work.s7_241 - work.s1_234*work.s7_244);
  const double s7_761 = 113.0*(s7_758 + work.s1_230*work.s7_242 - work.s1_237*work.s7_248);
  const double s7_762 = work.s1_270*work.w_carrier_right_y + work.s1_272*work.w_carrier_right_z;
  const double s7_763 = s7_762 + work.s1_264*work.w_carrier_right_x;
  const double s7_764 = work.s1_266*work.w_carrier_right_y + work.s1_274*work.w_carrier_right_z;
  const double s7_765 = s7_764 + work.s1_270*work.w_carrier_right_x;
  const double s7_766 = work.s1_274*work.w_carrier_right_y + work.s1_268*work.w_carrier_right_z;
  const double s7_767 = s7_766 + work.s1_272*work.w_carrier_right_x;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s7_768 = work.a_wheel_front_right_x + work.r_wheel_front_right_y*work.s7_267;
  const double s7_769 = s7_768 + work.r_wheel_front_right_z*work.s7_270;
  const double s7_770 = work.a_wheel_front_right_y + work.r_wheel_front_right_z*work.s7_271;
  const double s7_771 = s7_770 + work.r_wheel_front_right_x*work.s7_265;
  const double s7_772 = work.a_wheel_front_right_z + work.r_wheel_front_right_y*work.s7_269;
  const double s7_773 = s7_772 + work.r_wheel_front_right_x*work.s7_266;
  const double s7_774 = 105.0*(s7_769 - work.r_wheel_front_right_x*work.s7_264);
  const double s7_775 = 105.0*(s7_771 - work.r_wheel_front_right_y*work.s7_268);
  const double s7_776 = 105.0*(s7_773 - work.r_wheel_front_right_z*work.s7_272);
  const double s7_777 = work.s1_294*work.w_wheel_front_right_y;
  const double s7_778 = s7_777 + work.s1_296*work.w_wheel_front_right_z;
  const double s7_779 = s7_778 + work.s1_288*work.w_wheel_front_right_x;
  const double s7_780 = work.s1_290*work.w_wheel_front_right_y;
  const double s7_781 = s7_780 + work.s1_298*work.w_wheel_front_right_z;
  const double s7_782 = s7_781 + work.s1_294*work.w_wheel_front_right_x;
  const double s7_783 = work.s1_298*work.w_wheel_front_right_y;
  const double s7_784 = s7_783 + work.s1_292*work.w_wheel_front_right_z;
  const double s7_785 = s7_784 + work.s1_296*work.w_wheel_front_right_x;
  const double s7_786 = work.w_wheel_front_right_y*s7_785 - work.w_wheel_front_right_z*s7_782;
  const double s7_787 = s7_786 + work.s1_294*work.alpha_wheel_front_right_y;
  const double s7_788 = s7_787 + work.s1_296*work.alpha_wheel_front_right_z;
  const double s7_789 = s7_788 + work.s1_288*work.alpha_wheel_front_right_x;
  const double s7_790 = s7_789 + work.r_wheel_front_right_y*s7_776;
  const double s7_791 = s7_790 - work.r_wheel_front_right_z*s7_775;
  const double s7_792 = work.w_wheel_front_right_z*s7_779 - work.w_wheel_front_right_x*s7_785;
  const double s7_793 = s7_792 + work.s1_290*work.alpha_wheel_front_right_y;
  const double s7_794 = s7_793 + work.s1_298*work.alpha_wheel_front_right_z;
  const double s7_795 = s7_794 + work.s1_294*work.alpha_wheel_front_right_x;
  const double s7_796 = s7_795 + work.r_wheel_front_right_z*s7_774;
  const double s7_797 = s7_796 - work.r_wheel_front_right_x*s7_776;
  const double s7_798 = work.w_wheel_front_right_x*s7_782 - work.w_wheel_front_right_y*s7_779;
  const double s7_799 = s7_798 + work.s1_298*work.alpha_wheel_front_right_y;
  const double s7_800 = s7_799 + work.s1_292*work.alpha_wheel_front_right_z;
  const double s7_801 = s7_800 + work.s1_296*work.alpha_wheel_front_right_x;
  const double s7_802 = s7_801 + work.r_wheel_front_right_x*s7_775;
  const double s7_803 = s7_802 - work.r_wheel_front_right_y*s7_774;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double s7_804 = work.s1_312*work.s7_288 - work.s7_656 - work.s7_1;
  const double s7_805 = work.a_upper_arm_right_y + 3.6*work.s7_286 - work.s1_314*work.s7_292;
  const double s7_806 = work.a_upper_arm_right_z + work.s1_312*work.s7_290;
  const double s7_807 = s7_804 - work.s1_314*work.s7_291 - 0.5*work.s7_294 - 0.28*work.s7_295;
  work.s7_808 = 15.0*s7_807;
  work.s7_809 = 15.0*(s7_805 - work.s1_312*work.s7_289);
  work.s7_810 = 15.0*(s7_806 + work.s1_314*work.s7_293 + 3.6*work.s7_287);
  work.s7_811 = work.s1_318*work.w_chassis_y + work.s1_320*work.w_chassis_z;
  work.s7_812 = work.s1_320*work.w_chassis_y + work.s1_319*work.w_chassis_z;
  const double s7_813 = work.w_chassis_y*work.s7_812 - work.w_chassis_z*work.s7_811;
  const double s7_814 = s7_813 + 0.2*work.alpha_upper_arm_right_x + work.s1_314*work.s7_809;
  work.s7_815 = s7_814 + work.s1_312*work.s7_810;
  // arb_front_right: arb_front_right, revolute, chassis
  const double s7_816 = work.a_arb_front_right_x + work.s1_331*work.s7_307;
  const double s7_817 = work.a_arb_front_right_y + work.s7_724 + work.s1_331*work.s7_308;
  const double s7_818 = work.a_arb_front_right_z + work.s1_329*work.s7_304;
  const double s7_819 = s7_816 - work.s1_329*work.s7_302 - 0.5169230769230769*work.s7_305;
  work.s7_820 = 8.666666666666666*s7_819;
  work.s7_821 = 8.666666666666666*(s7_817 + work.s1_329*work.s7_303);
  const double s7_822 = s7_818 - work.s1_331*work.s7_309 - 0.5169230769230769*work.s7_306;
  work.s7_823 = 8.666666666666666*s7_822;
  const double s7_824 = work.s1_334*work.w_arb_front_right_y + work.s1_344*work.w_chassis_z;
  work.s7_825 = s7_824 + work.s1_342*work.w_chassis_x;
  const double s7_826 = 0.1304*work.w_arb_front_right_y + work.s1_338*work.w_chassis_z;
  work.s7_827 = s7_826 + work.s1_334*work.w_chassis_x;
  const double s7_828 = work.s1_338*work.w_arb_front_right_y + work.s1_343*work.w_chassis_z;
  work.s7_829 = s7_828 + work.s1_344*work.w_chassis_x;
  work.s7_830 = work.s7_523 + work.s7_820;
  work.s7_831 = work.s7_527 + work.s7_823;
  const double s7_832 = work.s1_534*work.s7_527 - work.s1_536*work.s7_523;
  const double s7_833 = s7_832 - work.w_chassis_z*work.s7_825 + work.w_chassis_x*work.s7_829;
  const double s7_834 = s7_833 - 0.1304*work.alpha_arb_front_right_y;
  const double s7_835 = s7_834 - work.s1_338*work.alpha_arb_front_right_z;
  const double s7_836 = s7_835 + work.s1_334*work.s7_298 - work.s1_331*work.s7_820;
  work.s7_837 = s7_836 + work.s1_329*work.s7_823;
  // pitman_arm: pitman_arm, revolute, chassis
  const double s7_838 = 9.0*(work.s7_540 - work.s1_353*work.s7_323 - work.s1_352*work.s7_318);
  work.s7_839 = 9.0*(work.s7_541 + work.s1_352*work.s7_319 - work.s1_353*work.s7_324);
  const double s7_840 = 9.0*(work.s7_542 + work.s1_353*work.s7_325 + work.s1_352*work.s7_320);
  work.s7_841 = work.s1_359*work.w_chassis_z + work.s1_357*work.w_chassis_x;
  work.s7_842 = 0.0842*work.w_pitman_arm_y;
  work.s7_843 = work.s1_358*work.w_chassis_z + work.s1_359*work.w_chassis_x;
  work.s7_844 = work.s7_537 + s7_838;
  work.s7_845 = work.s7_539 + s7_840;
  const double s7_846 = work.s1_555*work.s7_539 + work.s1_556*work.s7_537;
  const double s7_847 = s7_846 - work.w_chassis_z*work.s7_841 + work.w_chassis_x*work.s7_843;
  const double s7_848 = s7_847 - 0.0842*work.alpha_pitman_arm_y + work.s1_352*s7_840;
  work.s7_849 = s7_848 + work.s1_353*s7_838;
  // bell_crank: bell_crank, revolute, chassis
  const double s7_850 = work.s7_534 + work.s1_368*work.s7_335 - work.s1_370*work.s7_332;
  work.s7_851 = 16.666666666666668*s7_850;
  const double s7_852 = work.s7_535 + work.s1_370*work.s7_333 - work.s1_368*work.s7_336;
  work.s7_853 = 16.666666666666668*s7_852;
  const double s7_854 = work.s7_536 + work.s1_368*work.s7_337 + work.s1_370*work.s7_334;
  work.s7_855 = 16.666666666666668*s7_854;
  work.s7_856 = work.s1_378*work.w_chassis_y + work.s1_376*work.w_chassis_x;
  work.s7_857 = work.s1_377*work.w_chassis_y + work.s1_378*work.w_chassis_x;
  work.s7_858 = work.s7_550 + (work.s7_544 + (work.s7_564 + work.s7_853));
  const double s7_859 = work.s1_553*work.s7_543 - work.s1_554*work.s7_544;
  const double s7_860 = s7_859 + work.s1_584*work.s7_549 - work.s1_585*work.s7_550;
  const double s7_861 = s7_860 - work.s1_610*work.s7_562 - work.s1_611*work.s7_564;
  const double s7_862 = s7_861 - work.w_chassis_x*work.s7_857 + work.w_chassis_y*work.s7_856;
  const double s7_863 = s7_862 - 0.40412866666666675*work.alpha_bell_crank_z;
  work.s7_864 = s7_863 - work.s1_370*work.s7_853 + work.s1_368*work.s7_851;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_865 = work.a_rear_axle_x + work.s1_388*work.s7_405 + work.s1_390*work.s7_408;
  const double s7_866 = work.a_rear_axle_y + work.s1_390*work.s7_409 + work.s1_386*work.s7_403;
  const double s7_867 = work.a_rear_axle_z + work.s1_388*work.s7_407 + work.s1_386*work.s7_404;
  const double s7_868 = 774.0*(s7_865 - work.s1_386*work.s7_402);
  const double s7_869 = 774.0*(s7_866 - work.s1_388*work.s7_406);
  const double s7_870 = 774.0*(s7_867 - work.s1_390*work.s7_410);
  const double s7_871 = work.s1_409*work.w_rear_axle_y + work.s1_411*work.w_rear_axle_z;
  const double s7_872 = s7_871 + work.s1_404*work.w_rear_axle_x;
  const double s7_873 = work.s1_406*work.w_rear_axle_y + work.s1_413*work.w_rear_axle_z;
  const double s7_874 = s7_873 + work.s1_409*work.w_rear_axle_x;
  const double s7_875 = work.s1_413*work.w_rear_axle_y + work.s1_407*work.w_rear_axle_z;
  const double s7_876 = s7_875 + work.s1_411*work.w_rear_axle_x;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s7_877 = work.a_wheel_rear_left_x + work.r_wheel_rear_left_y*work.s7_429;
  const double s7_878 = s7_877 + work.r_wheel_rear_left_z*work.s7_432;
  const double s7_879 = work.a_wheel_rear_left_y + work.r_wheel_rear_left_z*work.s7_433;
  const double s7_880 = s7_879 + work.r_wheel_rear_left_x*work.s7_427;
  const double s7_881 = work.a_wheel_rear_left_z + work.r_wheel_rear_left_y*work.s7_431;
  const double s7_882 = s7_881 + work.r_wheel_rear_left_x*work.s7_428;
  const double s7_883 = 200.0*(s7_878 - work.r_wheel_rear_left_x*work.s7_426);
  const double s7_884 = 200.0*(s7_880 - work.r_wheel_rear_left_y*work.s7_430);
  const double s7_885 = 200.0*(s7_882 - work.r_wheel_rear_left_z*work.s7_434);
  const double s7_886 = work.s1_432*work.w_wheel_rear_left_y;
  const double s7_887 = s7_886 + work.s1_434*work.w_wheel_rear_left_z;
  const double s7_888 = s7_887 + work.s1_427*work.w_wheel_rear_left_x;
  const double s7_889 = work.s1_429*work.w_wheel_rear_left_y;
  const double s7_890 = s7_889 + work.s1_436*work.w_wheel_rear_left_z;
  const double s7_891 = s7_890 + work.s1_432*work.w_wheel_rear_left_x;
  const double s7_892 = work.s1_436*work.w_wheel_rear_left_y;
  const double s7_893 = s7_892 + work.s1_430*work.w_wheel_rear_left_z;
  const double s7_894 = s7_893 + work.s1_434*work.w_wheel_rear_left_x;
  const double s7_895 = work.w_wheel_rear_left_y*s7_894 - work.w_wheel_rear_left_z*s7_891;
  const double s7_896 = s7_895 + work.s1_432*work.alpha_wheel_rear_left_y;
  const double s7_897 = s7_896 + work.s1_434*work.alpha_wheel_rear_left_z;
  const double s7_898 = s7_897 + work.s1_427*work.alpha_wheel_rear_left_x;
  const double s7_899 = s7_898 + work.r_wheel_rear_left_y*s7_885;
  const double s7_900 = s7_899 - work.r_wheel_rear_left_z*s7_884;
  const double s7_901 = work.w_wheel_rear_left_z*s7_888 - work.w_wheel_rear_left_x*s7_894;
  const double s7_902 = s7_901 + work.s1_429*work.alpha_wheel_rear_left_y;
  const double s7_903 = s7_902 + work.s1_436*work.alpha_wheel_rear_left_z;
  const double s7_904 = s7_903 + work.s1_432*work.alpha_wheel_rear_left_x;
  const double s7_905 = s7_904 + work.r_wheel_rear_left_z*s7_883;
  const double s7_906 = s7_905 - work.r_wheel_rear_left_x*s7_885;
  const double s7_907 = work.w_wheel_rear_left_x*s7_891 - work.w_wheel_rear_left_y*s7_888;
  const double s7_908 = s7_907 + work.s1_436*work.alpha_wheel_rear_left_y;
  const double s7_909 = s7_908 + work.s1_430*work.alpha_wheel_rear_left_z;
  const double s7_910 = s7_909 + work.s1_434*work.alpha_wheel_rear_left_x;
  const double s7_911 = s7_910 + work.r_wheel_rear_left_x*s7_884;
  const double s7_912 = s7_911 - work.r_wheel_rear_left_y*s7_883;
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s7_913 = 0.5076923076923077*work.s7_16;
  const double s7_914 = work.a_arb_rear_left_x + 0.5076923076923077*work.s7_451;
  const double s7_915 = work.a_arb_rear_left_y - s7_913 + work.s1_449*work.s7_449;
  const double s7_916 = work.a_arb_rear_left_z + 0.5076923076923077*work.s7_452;
  const double s7_917 = s7_914 - work.s1_450*work.s7_453 - work.s1_449*work.s7_448;
  work.s7_918 = 8.666666666666666*s7_917;
  work.s7_919 = 8.666666666666666*(s7_915 - work.s1_450*work.s7_454);
  const double s7_920 = s7_916 + work.s1_450*work.s7_455 + work.s1_449*work.s7_450;
  work.s7_921 = 8.666666666666666*s7_920;
  const double s7_922 = work.s1_458*work.w_chassis_z + work.s1_456*work.w_chassis_x;
  work.s7_923 = s7_922 - work.s1_451*work.w_arb_rear_left_y;
  const double s7_924 = 0.14461538461538465*work.w_arb_rear_left_y;
  work.s7_925 = s7_924 + work.s1_453*work.w_chassis_z - work.s1_451*work.w_chassis_x;
  const double s7_926 = work.s1_453*work.w_arb_rear_left_y + work.s1_457*work.w_chassis_z;
  work.s7_927 = s7_926 + work.s1_458*work.w_chassis_x;
  work.s7_928 = work.s7_608 + work.s7_918;
  work.s7_929 = work.s7_610 + work.s7_921;
  const double s7_930 = work.s1_688*work.s7_610 + work.s1_689*work.s7_608;
  const double s7_931 = s7_930 - work.w_chassis_z*work.s7_923 + work.w_chassis_x*work.s7_927;
  const double s7_932 = s7_931 - 0.14461538461538465*work.alpha_arb_rear_left_y;
  const double s7_933 = s7_932 - work.s1_453*work.alpha_arb_rear_left_z;
  const double s7_934 = s7_933 - work.s1_451*work.s7_444 + work.s1_449*work.s7_921;
  work.s7_935 = s7_934 + work.s1_450*work.s7_918;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s7_936 = work.a_wheel_rear_right_x + work.r_wheel_rear_right_y*work.s7_473;
  const double s7_937 = s7_936 + work.r_wheel_rear_right_z*work.s7_476;
  const double s7_938 = work.a_wheel_rear_right_y + work.r_wheel_rear_right_z*work.s7_477;
  const double s7_939 = s7_938 + work.r_wheel_rear_right_x*work.s7_471;
  const double s7_940 = work.a_wheel_rear_right_z + work.r_wheel_rear_right_y*work.s7_475;
  const double s7_941 = s7_940 + work.r_wheel_rear_right_x*work.s7_472;
  const double s7_942 = 200.0*(s7_937 - work.r_wheel_rear_right_x*work.s7_470);
  const double s7_943 = 200.0*(s7_939 - work.r_wheel_rear_right_y*work.s7_474);
  const double s7_944 = 200.0*(s7_941 - work.r_wheel_rear_right_z*work.s7_478);
  const double s7_945 = work.s1_432*work.w_wheel_rear_right_y;
  const double s7_946 = s7_945 + work.s1_434*work.w_wheel_rear_right_z;
  const double s7_947 = s7_946 + work.s1_427*work.w_wheel_rear_right_x;
  const double s7_948 = work.s1_429*work.w_wheel_rear_right_y;
  const double s7_949 = s7_948 + work.s1_436*work.w_wheel_rear_right_z;
  const double s7_950 = s7_949 + work.s1_432*work.w_wheel_rear_right_x;
  const double s7_951 = work.s1_436*work.w_wheel_rear_right_y;
  const double s7_952 = s7_951 + work.s1_430*work.w_wheel_rear_right_z;
  const double s7_953 = s7_952 + work.s1_434*work.w_wheel_rear_right_x;
  const double s7_954 = work.w_wheel_rear_right_y*s7_953 - work.w_wheel_rear_right_z*s7_950;
  const double s7_955 = s7_954 + work.s1_432*work.alpha_wheel_rear_right_y;
  const double s7_956 = s7_955 + work.s1_434*work.alpha_wheel_rear_right_z;
  const double s7_957 = s7_956 + work.s1_427*work.alpha_wheel_rear_right_x;
  const double s7_958 = s7_957 + work.r_wheel_rear_right_y*s7_944;
  const double s7_959 = s7_958 - work.r_wheel_rear_right_z*s7_943;
  const double s7_960 = work.w_wheel_rear_right_z*s7_947 - work.w_wheel_rear_right_x*s7_953;
  const double s7_961 = s7_960 + work.s1_429*work.alpha_wheel_rear_right_y;
  const double s7_962 = s7_961 + work.s1_436*work.alpha_wheel_rear_right_z;
  const double s7_963 = s7_962 + work.s1_432*work.alpha_wheel_rear_right_x;
  const double s7_964 = s7_963 + work.r_wheel_rear_right_z*s7_942;
  const double s7_965 = s7_964 - work.r_wheel_rear_right_x*s7_944;
  const double s7_966 = work.w_wheel_rear_right_x*s7_950 - work.w_wheel_rear_right_y*s7_947;
  const double s7_967 = s7_966 + work.s1_436*work.alpha_wheel_rear_right_y;
  const double s7_968 = s7_967 + work.s1_430*work.alpha_wheel_rear_right_z;
  const double s7_969 = s7_968 + work.s1_434*work.alpha_wheel_rear_right_x;
  const double s7_970 = s7_969 + work.r_wheel_rear_right_x*s7_943;
  const double s7_971 = s7_970 - work.r_wheel_rear_right_y*s7_942;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s7_972 = work.s7_502 + 0.5076923076923077*work.s7_495 + work.s1_479*work.s7_497;
  const double s7_973 = work.a_arb_rear_right_y + s7_913 + work.s1_478*work.s7_493;
  const double s7_974 = work.a_arb_rear_right_z + work.s1_479*work.s7_499;
  work.s7_975 = 8.666666666666666*(s7_972 + work.s1_478*work.s7_492);
  work.s7_976 = 8.666666666666666*(s7_973 - work.s1_479*work.s7_498);
  const double s7_977 = s7_974 + work.s1_478*work.s7_494 - 0.5076923076923077*work.s7_496;
  work.s7_978 = 8.666666666666666*s7_977;
  const double s7_979 = work.s1_480*work.w_arb_rear_right_y + work.s1_487*work.w_chassis_z;
  work.s7_980 = s7_979 + work.s1_485*work.w_chassis_x;
  const double s7_981 = 0.14461538461538465*work.w_arb_rear_right_y;
  work.s7_982 = s7_981 + work.s1_480*work.w_chassis_x - work.s1_482*work.w_chassis_z;
  const double s7_983 = work.s1_486*work.w_chassis_z + work.s1_487*work.w_chassis_x;
  work.s7_984 = s7_983 - work.s1_482*work.w_arb_rear_right_y;
  work.s7_985 = work.s7_975 - work.s7_640;
  work.s7_986 = work.s7_642 + work.s7_978;
  const double s7_987 = work.s1_742*work.s7_642 + work.s1_743*work.s7_640;
  const double s7_988 = s7_987 - work.w_chassis_z*work.s7_980 + work.w_chassis_x*work.s7_984;
  const double s7_989 = s7_988 - 0.14461538461538465*work.alpha_arb_rear_right_y;
  const double s7_990 = s7_989 + work.s1_482*work.alpha_arb_rear_right_z;
  const double s7_991 = s7_990 + work.s1_480*work.s7_488 - work.s1_479*work.s7_975;
  work.s7_992 = s7_991 + work.s1_478*work.s7_978;
  const double s7_993 = tau[Coordinate::arb_rear_right] + work.s7_992;
  const double s7_994 = s7_993 + 3.3000000000000003*work.s7_986;
  work.Q_arb_rear_right = s7_994 + 0.44999999999999996*work.s7_985;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s7_995 = tau[Coordinate::wheel_rear_right] - work.R_rear_axle_y_y*s7_965;
  const double s7_996 = s7_995 - work.R_rear_axle_z_y*s7_971 - work.R_rear_axle_x_y*s7_959;
  const double s7_997 = s7_996 - work.b_wheel_rear_right_y*s7_943;
  const double s7_998 = s7_997 - work.b_wheel_rear_right_z*s7_944;
  work.Q_wheel_rear_right = s7_998 - work.b_wheel_rear_right_x*s7_942;
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s7_999 = tau[Coordinate::arb_rear_left] + work.s7_935;
  const double s7_1000 = s7_999 + 3.3000000000000003*work.s7_929;
  work.Q_arb_rear_left = s7_1000 - 0.44999999999999996*work.s7_928;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s7_1001 = tau[Coordinate::wheel_rear_left] - work.R_rear_axle_y_y*s7_906;
  const double s7_1002 = s7_1001 - work.R_rear_axle_z_y*s7_912 - work.R_rear_axle_x_y*s7_900;
  const double s7_1003 = s7_1002 - work.b_wheel_rear_left_y*s7_884;
  const double s7_1004 = s7_1003 - work.b_wheel_rear_left_z*s7_885;
  work.Q_wheel_rear_left = s7_1004 - work.b_wheel_rear_left_x*s7_883;
  const double s7_1005 = work.s7_646 - work.s7_586 - work.s7_602 - work.s7_615 - work.s7_625;
  work.s7_1006 = s7_1005 - work.s7_634 - s7_868 - s7_942 - s7_883;
  const double s7_1007 = work.s7_626 + (work.s7_635 + (work.s7_647 + (s7_869 + s7_943)));
  work.s7_1008 = s7_884 + (work.s7_587 + (work.s7_603 + (work.s7_616 + s7_1007)));
  const double s7_1009 = work.s7_627 + (work.s7_636 + (work.s7_648 + (s7_870 + s7_944)));
  work.s7_1010 = s7_885 + (work.s7_588 + (work.s7_604 + (work.s7_617 + s7_1009)));
  const double s7_1011 = work.s1_640*work.s7_587 - s7_959 - s7_900 - work.s1_639*work.s7_588;
  const double s7_1012 = s7_1011 + work.s1_662*work.s7_603 - work.s1_660*work.s7_604;
  const double s7_1013 = s7_1012 + work.s1_687*work.s7_616 - work.s1_684*work.s7_617;
  const double s7_1014 = s7_1013 + work.s1_709*work.s7_626 - work.s1_708*work.s7_627;
  const double s7_1015 = s7_1014 + work.s1_725*work.s7_635 - work.s1_724*work.s7_636;
  const double s7_1016 = s7_1015 + work.s1_741*work.s7_647 - work.s1_740*work.s7_648;
  const double s7_1017 = s7_1016 - work.w_rear_axle_y*s7_876 + work.w_rear_axle_z*s7_874;
  const double s7_1018 = s7_1017 - work.s1_409*work.alpha_rear_axle_y;
  const double s7_1019 = s7_1018 - work.s1_411*work.alpha_rear_axle_z;
  const double s7_1020 = s7_1019 - work.s1_404*work.alpha_rear_axle_x - work.s1_388*s7_870;
  work.s7_1021 = s7_1020 + work.s1_390*s7_869;
  const double s7_1022 = work.s1_637*work.s7_588 - s7_965 - s7_906 - work.s1_640*work.s7_586;
  const double s7_1023 = s7_1022 + work.s1_658*work.s7_604 - work.s1_662*work.s7_602;
  const double s7_1024 = s7_1023 + work.s1_683*work.s7_617 - work.s1_687*work.s7_615;
  const double s7_1025 = s7_1024 + work.s1_707*work.s7_627 - work.s1_709*work.s7_625;
  const double s7_1026 = s7_1025 + work.s1_723*work.s7_636 - work.s1_725*work.s7_634;
  const double s7_1027 = s7_1026 + work.s1_739*work.s7_648 + work.s1_741*work.s7_646;
  const double s7_1028 = s7_1027 - work.w_rear_axle_z*s7_872 + work.w_rear_axle_x*s7_876;
  const double s7_1029 = s7_1028 - work.s1_406*work.alpha_rear_axle_y;
  const double s7_1030 = s7_1029 - work.s1_413*work.alpha_rear_axle_z;
  const double s7_1031 = s7_1030 - work.s1_409*work.alpha_rear_axle_x - work.s1_390*s7_868;
  work.s7_1032 = s7_1031 + work.s1_386*s7_870;
  const double s7_1033 = work.s1_639*work.s7_586 - s7_971 - s7_912 - work.s1_637*work.s7_587;
  const double s7_1034 = s7_1033 + work.s1_660*work.s7_602 - work.s1_658*work.s7_603;
  const double s7_1035 = s7_1034 + work.s1_684*work.s7_615 - work.s1_683*work.s7_616;
  const double s7_1036 = s7_1035 + work.s1_708*work.s7_625 - work.s1_707*work.s7_626;
  const double s7_1037 = s7_1036 + work.s1_724*work.s7_634 - work.s1_723*work.s7_635;
  const double s7_1038 = s7_1037 - work.s1_740*work.s7_646 - work.s1_739*work.s7_647;
  const double s7_1039 = s7_1038 - work.w_rear_axle_x*s7_874 + work.w_rear_axle_y*s7_872;
  const double s7_1040 = s7_1039 - work.s1_413*work.alpha_rear_axle_y;
  const double s7_1041 = s7_1040 - work.s1_407*work.alpha_rear_axle_z;
  const double s7_1042 = s7_1041 - work.s1_411*work.alpha_rear_axle_x - work.s1_386*s7_869;
  work.s7_1043 = s7_1042 + work.s1_388*s7_868;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_1044 = tau[Coordinate::rear_axle_rx] + work.R_rear_axle_aux5_y_x*work.s7_1032;
  const double s7_1045 = s7_1044 + work.R_rear_axle_aux5_x_x*work.s7_1021;
  const double s7_1046 = s7_1045 - work.sines[18]*work.s7_1043;
  const double s7_1047 = s7_1046 - work.b_rear_axle_rx_y*work.s7_1008;
  work.Q_rear_axle_rx = s7_1047 - work.b_rear_axle_rx_z*work.s7_1010 - work.s1_64*work.s7_1006;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double s7_1048 = tau[Coordinate::rear_axle_ry] + work.cosines[17]*work.s7_1032;
  const double s7_1049 = s7_1048 - work.sines[17]*work.s7_1021 + work.s1_60*work.s7_1008;
  work.Q_rear_axle_ry = s7_1049 - work.b_rear_axle_ry_z*work.s7_1010 - work.s1_59*work.s7_1006;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double s7_1050 = tau[Coordinate::rear_axle_rz] + work.s7_1043;
  const double s7_1051 = s7_1050 + work.r_rear_axle_aux1_x*work.s7_1008;
  work.Q_rear_axle_rz = s7_1051 + state.z[Coordinate::rear_axle_ty]*work.s7_1006;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  work.Q_rear_axle_tz = tau[Coordinate::rear_axle_tz] - work.s7_1010;
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  work.Q_rear_axle_ty = tau[Coordinate::rear_axle_ty] - work.s7_1008;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.Q_rear_axle_tx = tau[Coordinate::rear_axle_tx] + work.s7_1006;
  // bell_crank: bell_crank, revolute, chassis
  work.Q_bell_crank = tau[Coordinate::bell_crank] + work.s7_864 + 3.25*work.s7_858;
  // pitman_arm: pitman_arm, revolute, chassis
  const double s7_1052 = tau[Coordinate::pitman_arm] + work.s7_849 - 4.4*work.s7_845;
  work.Q_pitman_arm = s7_1052 - 0.4*work.s7_844;
  // arb_front_right: arb_front_right, revolute, chassis
  const double s7_1053 = tau[Coordinate::arb_front_right] + work.s7_837 - 3.95*work.s7_831;
  work.Q_arb_front_right = s7_1053 - 0.5*work.s7_830;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double s7_1054 = tau[Coordinate::upper_arm_right] - work.s7_815 + 0.28*work.s7_809;
  work.Q_upper_arm_right = s7_1054 - 0.5*work.s7_810;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s7_1055 = tau[Coordinate::wheel_front_right] + work.s1_40*s7_791;
  const double s7_1056 = s7_1055 - work.R_carrier_right_aux2_z_y*s7_803;
  const double s7_1057 = s7_1056 - work.R_carrier_right_aux2_y_y*s7_797 + work.s1_56*s7_775;
  const double s7_1058 = s7_1057 - work.b_wheel_front_right_z*s7_776;
  work.Q_wheel_front_right = s7_1058 - work.b_wheel_front_right_x*s7_774;
  work.s7_1059 = work.s7_568 + (work.s7_531 + (s7_759 + s7_774));
  const double s7_1060 = work.s7_570 + (work.s7_532 + (s7_760 + s7_775));
  const double s7_1061 = work.s7_572 + (work.s7_533 + (s7_761 + s7_776));
  const double s7_1062 = work.s1_532*work.s7_532 - s7_791 - work.s1_529*work.s7_533;
  const double s7_1063 = s7_1062 + work.s1_609*work.s7_570 - work.s1_607*work.s7_572;
  const double s7_1064 = s7_1063 - work.w_carrier_right_y*s7_767 + work.w_carrier_right_z*s7_765;
  const double s7_1065 = s7_1064 - work.s1_270*work.alpha_carrier_right_y;
  const double s7_1066 = s7_1065 - work.s1_272*work.alpha_carrier_right_z;
  const double s7_1067 = s7_1066 - work.s1_264*work.alpha_carrier_right_x - work.s1_234*s7_761;
  const double s7_1068 = s7_1067 + work.s1_237*s7_760;
  const double s7_1069 = work.s1_525*work.s7_533 - s7_797 - work.s1_532*work.s7_531;
  const double s7_1070 = s7_1069 + work.s1_604*work.s7_572 - work.s1_609*work.s7_568;
  const double s7_1071 = s7_1070 - work.w_carrier_right_z*s7_763 + work.w_carrier_right_x*s7_767;
  const double s7_1072 = s7_1071 - work.s1_266*work.alpha_carrier_right_y;
  const double s7_1073 = s7_1072 - work.s1_274*work.alpha_carrier_right_z;
  const double s7_1074 = s7_1073 - work.s1_270*work.alpha_carrier_right_x - work.s1_237*s7_759;
  work.s7_1075 = s7_1074 + work.s1_230*s7_761;
  const double s7_1076 = work.s1_529*work.s7_531 - s7_803 - work.s1_525*work.s7_532;
  const double s7_1077 = s7_1076 + work.s1_607*work.s7_568 - work.s1_604*work.s7_570;
  const double s7_1078 = s7_1077 - work.w_carrier_right_x*s7_765 + work.w_carrier_right_y*s7_763;
  const double s7_1079 = s7_1078 - work.s1_274*work.alpha_carrier_right_y;
  const double s7_1080 = s7_1079 - work.s1_268*work.alpha_carrier_right_z;
  const double s7_1081 = s7_1080 - work.s1_272*work.alpha_carrier_right_x - work.s1_230*s7_760;
  work.s7_1082 = s7_1081 + work.s1_234*s7_759;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_1083 = work.R_carrier_right_aux2_y_y*work.s7_1075;
  const double s7_1084 = tau[Coordinate::carrier_right_ry] + s7_1083;
  const double s7_1085 = s7_1084 + work.R_carrier_right_aux2_z_y*work.s7_1082;
  const double s7_1086 = s7_1085 - work.s1_40*s7_1068 - work.b_carrier_right_ry_y*s7_1060;
  const double s7_1087 = s7_1086 - work.b_carrier_right_ry_z*s7_1061;
  work.Q_carrier_right_ry = s7_1087 - work.b_carrier_right_ry_x*work.s7_1059;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s7_1088 = work.R_carrier_right_aux1_y_x*work.s7_1075;
  const double s7_1089 = tau[Coordinate::carrier_right_rx] + s7_1088;
  const double s7_1090 = s7_1089 + work.R_carrier_right_aux1_z_x*work.s7_1082;
  const double s7_1091 = s7_1090 + work.cosines[10]*s7_1068 + work.s1_44*s7_1060;
  const double s7_1092 = s7_1091 - work.b_carrier_right_rx_z*s7_1061;
  work.Q_carrier_right_rx = s7_1092 - work.b_carrier_right_rx_x*work.s7_1059;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s7_1093 = tau[Coordinate::carrier_right_rz] + work.cosines[9]*work.s7_1082;
  const double s7_1094 = s7_1093 - work.sines[9]*work.s7_1075 + work.s1_37*s7_1060;
  work.Q_carrier_right_rz = s7_1094 + work.s1_38*s7_1061 - work.b_carrier_right_rz_x*work.s7_1059;
  work.s7_1095 = work.s7_752 + s7_1060;
  work.s7_1096 = work.s7_753 + s7_1061;
  const double s7_1097 = s7_1068 - work.w_chassis_y*work.s7_755 + work.w_chassis_z*work.s7_754;
  work.s7_1098 = s7_1097 - 0.6*work.alpha_lower_arm_right_x - work.s1_218*work.s7_752;
}

/// Part 6 of compute_chosen_accelerations: step 7: accelerations Zdot and accumulated forces QR -
/// PR (51), (52); step 8: Rz' M Rz and right-hand side (63).
[[gnu::noinline]] void compute_chosen_accelerations_6(const double* tau,
    ChosenAccelerationsWork& __restrict work) noexcept {
  // --- step 7: accelerations Zdot and accumulated forces QR - PR (51), (52), continued ---
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s7_1099 = work.s7_1098 - work.s1_216*work.s7_753;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double s7_1100 = tau[Coordinate::lower_arm_right] + s7_1099 + 0.62*work.s7_1095;
  work.Q_lower_arm_right = s7_1100 - 0.4*work.s7_1096;
  // arb_front_left: arb_front_left, revolute, chassis
  const double s7_1101 = tau[Coordinate::arb_front_left] + work.s7_747 - 3.95*work.s7_741;
  work.Q_arb_front_left = s7_1101 - 0.5*work.s7_740;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double s7_1102 = tau[Coordinate::upper_arm_left] - work.s7_723 + 0.28*work.s7_717;
  work.Q_upper_arm_left = s7_1102 + 0.5*work.s7_718;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s7_1103 = tau[Coordinate::wheel_front_left] + work.s1_13*work.s7_700;
  const double s7_1104 = s7_1103 - work.R_carrier_left_aux2_z_y*work.s7_712;
  const double s7_1105 = s7_1104 - work.R_carrier_left_aux2_y_y*work.s7_706;
  const double s7_1106 = s7_1105 + work.s1_30*work.s7_684 - work.b_wheel_front_left_z*work.s7_685;
  work.Q_wheel_front_left = s7_1106 - work.b_wheel_front_left_x*work.s7_683;
  const double s7_1107 = work.s7_553 + (work.s7_516 + (work.s7_668 + work.s7_683));
  const double s7_1108 = work.s7_555 + (work.s7_517 + (work.s7_669 + work.s7_684));
  const double s7_1109 = work.s7_557 + (work.s7_518 + (work.s7_670 + work.s7_685));
  const double s7_1110 = work.s1_503*work.s7_517 - work.s7_700 - work.s1_500*work.s7_518;
  const double s7_1111 = s7_1110 + work.s1_579*work.s7_555 - work.s1_576*work.s7_557;
  const double s7_1112 = s7_1111 - work.w_carrier_left_y*work.s7_676;
  const double s7_1113 = s7_1112 + work.w_carrier_left_z*work.s7_674;
  const double s7_1114 = s7_1113 - work.s1_133*work.alpha_carrier_left_y;
  const double s7_1115 = s7_1114 - work.s1_135*work.alpha_carrier_left_z;
  const double s7_1116 = s7_1115 - work.s1_127*work.alpha_carrier_left_x - work.s1_95*work.s7_670;
  const double s7_1117 = s7_1116 + work.s1_99*work.s7_669;
  const double s7_1118 = work.s1_497*work.s7_518 - work.s7_706 - work.s1_503*work.s7_516;
  const double s7_1119 = s7_1118 + work.s1_573*work.s7_557 - work.s1_579*work.s7_553;
  const double s7_1120 = s7_1119 - work.w_carrier_left_z*work.s7_672;
  const double s7_1121 = s7_1120 + work.w_carrier_left_x*work.s7_676;
  const double s7_1122 = s7_1121 - work.s1_129*work.alpha_carrier_left_y;
  const double s7_1123 = s7_1122 - work.s1_137*work.alpha_carrier_left_z;
  const double s7_1124 = s7_1123 - work.s1_133*work.alpha_carrier_left_x - work.s1_99*work.s7_668;
  const double s7_1125 = s7_1124 + work.s1_91*work.s7_670;
  const double s7_1126 = work.s1_500*work.s7_516 - work.s7_712 - work.s1_497*work.s7_517;
  const double s7_1127 = s7_1126 + work.s1_576*work.s7_553 - work.s1_573*work.s7_555;
  const double s7_1128 = s7_1127 - work.w_carrier_left_x*work.s7_674;
  const double s7_1129 = s7_1128 + work.w_carrier_left_y*work.s7_672;
  const double s7_1130 = s7_1129 - work.s1_137*work.alpha_carrier_left_y;
  const double s7_1131 = s7_1130 - work.s1_131*work.alpha_carrier_left_z;
  const double s7_1132 = s7_1131 - work.s1_135*work.alpha_carrier_left_x - work.s1_91*work.s7_669;
  const double s7_1133 = s7_1132 + work.s1_95*work.s7_668;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_1134 = tau[Coordinate::carrier_left_ry] + work.R_carrier_left_aux2_y_y*s7_1125;
  const double s7_1135 = s7_1134 + work.R_carrier_left_aux2_z_y*s7_1133 - work.s1_13*s7_1117;
  const double s7_1136 = s7_1135 + work.s1_22*s7_1108 - work.b_carrier_left_ry_z*s7_1109;
  work.Q_carrier_left_ry = s7_1136 - work.b_carrier_left_ry_x*s7_1107;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s7_1137 = tau[Coordinate::carrier_left_rx] + work.R_carrier_left_aux1_y_x*s7_1125;
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double s7_1138 = s7_1137 + work.R_carrier_left_aux1_z_x*s7_1133;
  const double s7_1139 = s7_1138 + R_carrier_left_aux1_x_x*s7_1117;
  const double s7_1140 = s7_1139 - work.b_carrier_left_rx_y*s7_1108;
  const double s7_1141 = s7_1140 - work.b_carrier_left_rx_z*s7_1109;
  work.Q_carrier_left_rx = s7_1141 - work.b_carrier_left_rx_x*s7_1107;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s7_1142 = tau[Coordinate::carrier_left_rz] + R_lower_arm_left_y_y*s7_1133;
  const double s7_1143 = s7_1142 - R_lower_arm_left_z_y*s7_1125 + work.s1_10*s7_1108;
  work.Q_carrier_left_rz = s7_1143 + work.s1_11*s7_1109 - work.b_carrier_left_rz_x*s7_1107;
  const double s7_1144 = work.s7_661 + s7_1108;
  const double s7_1145 = work.s7_662 + s7_1109;
  const double s7_1146 = s7_1117 - work.w_chassis_y*work.s7_664 + work.w_chassis_z*work.s7_663;
  const double s7_1147 = s7_1146 - 0.6*work.alpha_lower_arm_left_x - work.s1_77*work.s7_662;
  const double s7_1148 = s7_1147 + work.s1_79*work.s7_661;
  // lower_arm_left: lower_arm_left, revolute, chassis
  work.Q_lower_arm_left = tau[Coordinate::lower_arm_left] + s7_1148 + 0.62*s7_1144 + 0.4*s7_1145;
  const double s7_1149 = work.s7_985 + work.s7_1006 - work.s7_576 - work.s7_592 - work.s7_621;
  const double s7_1150 = s7_1149 - work.s7_631 - work.s7_652 - work.s7_928 - work.s7_543;
  const double s7_1151 = s7_1150 - work.s7_549 - work.s7_562 - work.s7_851 - work.s7_844;
  const double s7_1152 = s7_1151 - work.s7_830 - work.s7_808 - work.s7_751 - work.s7_1059;
  const double s7_1153 = s7_1152 - work.s7_740 - work.s7_716 - work.s7_660 - s7_1107;
  const double s7_1154 = work.s7_641 + (work.s7_976 + (work.s7_1008 + (work.s7_1095 + s7_1144)));
  const double s7_1155 = work.s7_593 + (work.s7_622 + (work.s7_632 + (work.s7_653 + s7_1154)));
  const double s7_1156 = work.s7_858 + (work.s7_609 + (work.s7_919 + (work.s7_577 + s7_1155)));
  const double s7_1157 = work.s7_525 + (work.s7_821 + (work.s7_538 + (work.s7_839 + s7_1156)));
  const double s7_1158 = work.s7_717 + (work.s7_510 + (work.s7_732 + (work.s7_809 + s7_1157)));
  const double s7_1159 = work.s7_654 + (work.s7_986 + (work.s7_1010 + (work.s7_1096 + s7_1145)));
  const double s7_1160 = work.s7_578 + (work.s7_594 + (work.s7_623 + (work.s7_633 + s7_1159)));
  const double s7_1161 = work.s7_551 + (work.s7_566 + (work.s7_855 + (work.s7_929 + s7_1160)));
  const double s7_1162 = work.s7_810 + (work.s7_831 + (work.s7_845 + (work.s7_545 + s7_1161)));
  const double s7_1163 = work.s7_741 + (work.s7_718 + s7_1162);
  const double s7_1164 = work.s7_642 - work.s7_564 - work.s7_544 - work.s7_550 - work.s7_853;
  const double s7_1165 = work.s7_655 + (work.s7_982 + (work.s7_842 + work.s7_925));
  const double s7_1166 = work.s7_593 + work.s7_632;
  const double s7_1167 = 145066.78026359034*work.w_chassis_z;
  const double s7_1168 = s7_1167 - 22.575050285939653*work.w_chassis_x;
  const double s7_1169 = s7_1168 + 0.40412866666666675*work.w_bell_crank_z;
  const double s7_1170 = work.s7_1021 + (s7_1099 + s7_1148) - work.s7_815 - work.s7_723;
  const double s7_1171 = s7_1170 + work.s1_507*work.s7_510 - work.w_arb_front_left_y*work.s7_739;
  const double s7_1172 = s7_1171 - work.s1_197*work.alpha_arb_front_left_y;
  const double s7_1173 = s7_1172 - work.s1_207*work.alpha_arb_front_left_z;
  const double s7_1174 = s7_1173 + work.s1_205*work.s7_150 + work.s1_194*work.s7_732;
  const double s7_1175 = s7_1174 + work.s1_536*work.s7_525 - work.w_arb_front_right_y*work.s7_829;
  const double s7_1176 = s7_1175 - work.s1_334*work.alpha_arb_front_right_y;
  const double s7_1177 = s7_1176 - work.s1_344*work.alpha_arb_front_right_z;
  const double s7_1178 = s7_1177 + work.s1_342*work.s7_298 + work.s1_331*work.s7_821;
  const double s7_1179 = s7_1178 + work.s1_610*work.s7_566 - work.s1_553*work.s7_545;
  const double s7_1180 = s7_1179 - work.s1_584*work.s7_551 + work.w_bell_crank_z*work.s7_857;
  const double s7_1181 = s7_1180 - work.s1_378*work.alpha_bell_crank_y;
  const double s7_1182 = s7_1181 - work.s1_376*work.alpha_bell_crank_x - work.s1_368*work.s7_855;
  const double s7_1183 = s7_1182 - 22.575050285939653*work.s7_9 + 15014.70911391573*work.s7_2;
  const double s7_1184 = s7_1183 + 0.24897456123052653*work.s7_653 - work.s1_743*work.s7_641;
  const double s7_1185 = s7_1184 - work.w_arb_rear_right_y*work.s7_984;
  const double s7_1186 = s7_1185 - work.s1_480*work.alpha_arb_rear_right_y;
  const double s7_1187 = s7_1186 - work.s1_487*work.alpha_arb_rear_right_z;
  const double s7_1188 = s7_1187 + work.s1_485*work.s7_488 - work.s1_479*work.s7_976;
  const double s7_1189 = s7_1188 - work.s1_689*work.s7_609 - work.w_arb_rear_left_y*work.s7_927;
  const double s7_1190 = s7_1189 - work.s1_458*work.alpha_arb_rear_left_z;
  const double s7_1191 = work.s1_451*work.alpha_arb_rear_left_y;
  const double s7_1192 = s7_1190 + work.s1_456*work.s7_444 + s7_1191 - work.s1_450*work.s7_919;
  const double s7_1193 = s7_1192 - work.s1_556*work.s7_538 - work.w_pitman_arm_y*work.s7_843;
  const double s7_1194 = s7_1193 - work.s1_359*work.alpha_pitman_arm_z + work.s1_357*work.s7_314;
  const double s7_1195 = s7_1194 - work.s1_353*work.s7_839 + 0.6*(s7_1164 - work.s7_610);
  const double s7_1196 = s7_1195 + work.w_chassis_z*(work.s7_827 + (work.s7_737 + s7_1165));
  const double s7_1197 = s7_1196 + 0.55*(work.s7_623 - work.s7_622 - work.s7_577 - work.s7_578);
  const double s7_1198 = s7_1197 + 0.4*(work.s7_633 - work.s7_594) - 0.5*work.s7_845;
  const double s7_1199 = 0.5169230769230769*(work.s7_823 - work.s7_733);
  const double s7_1200 = s7_1198 - 0.15000000000000002*s7_1166 + s7_1199;
  const double s7_1201 = s7_1200 + 0.5076923076923077*(work.s7_978 - work.s7_921);
  const double s7_1202 = s7_1201 + 0.72*(work.s7_527 - work.s7_511) - work.w_chassis_y*s7_1169;
  const double s7_1203 = 15014.70911391573*work.w_chassis_x - 22.575050285939653*work.w_chassis_z;
  const double s7_1204 = s7_1203 + 0.6*(work.w_lower_arm_left_x + work.w_lower_arm_right_x);
  const double s7_1205 = s7_1204 + 0.2*(work.w_upper_arm_left_x + work.w_upper_arm_right_x);
  const double s7_1206 = work.s7_624 + (work.s7_992 + (work.s7_1032 + (work.s7_1075 + s7_1125)));
  const double s7_1207 = work.s7_747 + (work.s7_849 + (work.s7_935 + (work.s7_579 + s7_1206)));
  const double s7_1208 = work.s7_837 + s7_1207 + work.s1_554*work.s7_545;
  const double s7_1209 = s7_1208 + work.s1_585*work.s7_551 + work.s1_611*work.s7_566;
  const double s7_1210 = s7_1209 - work.w_bell_crank_z*work.s7_856;
  const double s7_1211 = s7_1210 - work.s1_377*work.alpha_bell_crank_y;
  const double s7_1212 = s7_1211 - work.s1_378*work.alpha_bell_crank_x + work.s1_370*work.s7_855;
  const double s7_1213 = s7_1212 - 150070.8160441727*work.alpha_chassis_y;
  const double s7_1214 = s7_1213 - 0.0027607966870439754*work.s7_654;
  const double s7_1215 = s7_1214 - 0.24897456123052653*work.s7_652;
  const double s7_1216 = s7_1215 + work.w_upper_arm_right_x*work.s7_812;
  const double s7_1217 = s7_1216 - work.s1_318*work.alpha_upper_arm_right_y;
  const double s7_1218 = s7_1217 + work.s1_320*work.s7_282 + work.s1_314*work.s7_808;
  const double s7_1219 = s7_1218 + work.w_lower_arm_right_x*work.s7_755;
  const double s7_1220 = s7_1219 - work.s1_222*work.alpha_lower_arm_right_y;
  const double s7_1221 = s7_1220 + work.s1_224*work.s7_166 + work.s1_218*work.s7_751;
  const double s7_1222 = s7_1221 + work.w_upper_arm_left_x*work.s7_720;
  const double s7_1223 = s7_1222 - work.s1_181*work.alpha_upper_arm_left_y;
  const double s7_1224 = s7_1223 + work.s1_183*work.s7_134 - work.s1_177*work.s7_716;
  const double s7_1225 = s7_1224 + work.w_lower_arm_left_x*work.s7_664;
  const double s7_1226 = s7_1225 - work.s1_83*work.alpha_lower_arm_left_y + work.s1_85*work.s7_19;
  const double s7_1227 = 3.6*(work.s7_810 + (work.s7_753 + (work.s7_662 + work.s7_718)));
  const double s7_1228 = s7_1226 - work.s1_79*work.s7_660 - work.w_chassis_z*s7_1205 + s7_1227;
  const double s7_1229 = 0.6*(work.s7_549 + (work.s7_543 + (work.s7_562 + work.s7_851)));
  const double s7_1230 = s7_1228 + s7_1229 + 0.15000000000000002*(work.s7_592 + work.s7_631);
  const double s7_1231 = 1.6999999999999997*(work.s7_594 + work.s7_633);
  const double s7_1232 = s7_1230 - 1.6*(work.s7_578 + work.s7_623) - s7_1231;
  const double s7_1233 = s7_1232 + work.w_chassis_x*s7_1169;
  const double s7_1234 = work.s7_925 + (work.s7_655 + (work.s7_827 + work.s7_982));
  const double s7_1235 = work.s7_864 + (work.s7_579 + (work.s7_1043 + (work.s7_1082 + s7_1133)));
  const double s7_1236 = s7_1235 - work.s7_624 - work.s1_505*work.s7_510;
  const double s7_1237 = s7_1236 + work.w_arb_front_left_y*work.s7_735;
  const double s7_1238 = s7_1237 - work.s1_206*work.alpha_arb_front_left_z;
  const double s7_1239 = work.s1_201*work.alpha_arb_front_left_y;
  const double s7_1240 = s7_1238 + work.s1_207*work.s7_150 + s7_1239 - work.s1_192*work.s7_732;
  const double s7_1241 = s7_1240 - work.s1_555*work.s7_538 + work.w_pitman_arm_y*work.s7_841;
  const double s7_1242 = s7_1241 - work.s1_358*work.alpha_pitman_arm_z + work.s1_359*work.s7_314;
  const double s7_1243 = s7_1242 - work.s1_352*work.s7_839 - work.s1_688*work.s7_609;
  const double s7_1244 = s7_1243 + work.w_arb_rear_left_y*work.s7_923;
  const double s7_1245 = s7_1244 - work.s1_453*work.alpha_arb_rear_left_y;
  const double s7_1246 = s7_1245 - work.s1_457*work.alpha_arb_rear_left_z;
  const double s7_1247 = s7_1246 + work.s1_458*work.s7_444 - work.s1_449*work.s7_919;
  const double s7_1248 = s7_1247 - 22.575050285939653*work.s7_2 + 145066.78026359034*work.s7_9;
  const double s7_1249 = s7_1248 + 0.0027607966870439754*work.s7_653 - work.s1_742*work.s7_641;
  const double s7_1250 = s7_1249 + work.w_arb_rear_right_y*work.s7_980;
  const double s7_1251 = s7_1250 - work.s1_486*work.alpha_arb_rear_right_z;
  const double s7_1252 = work.s1_482*work.alpha_arb_rear_right_y;
  const double s7_1253 = s7_1251 + work.s1_487*work.s7_488 + s7_1252 - work.s1_478*work.s7_976;
  const double s7_1254 = s7_1253 - work.s1_534*work.s7_525 + work.w_arb_front_right_y*work.s7_825;
  const double s7_1255 = s7_1254 - work.s1_338*work.alpha_arb_front_right_y;
  const double s7_1256 = s7_1255 - work.s1_343*work.alpha_arb_front_right_z;
  const double s7_1257 = s7_1256 + work.s1_344*work.s7_298 - work.s1_329*work.s7_821;
  const double s7_1258 = s7_1257 - work.w_upper_arm_right_x*work.s7_811;
  const double s7_1259 = s7_1258 - work.s1_320*work.alpha_upper_arm_right_y;
  const double s7_1260 = s7_1259 + work.s1_319*work.s7_282 + work.s1_312*work.s7_808;
  const double s7_1261 = s7_1260 - work.w_lower_arm_right_x*work.s7_754;
  const double s7_1262 = s7_1261 - work.s1_224*work.alpha_lower_arm_right_y;
  const double s7_1263 = s7_1262 + work.s1_223*work.s7_166 + work.s1_216*work.s7_751;
  const double s7_1264 = s7_1263 - work.w_upper_arm_left_x*work.s7_719;
  const double s7_1265 = s7_1264 - work.s1_183*work.alpha_upper_arm_left_y;
  const double s7_1266 = s7_1265 + work.s1_182*work.s7_134 + work.s1_175*work.s7_716;
  const double s7_1267 = s7_1266 - work.w_lower_arm_left_x*work.s7_663;
  const double s7_1268 = s7_1267 - work.s1_85*work.alpha_lower_arm_left_y + work.s1_84*work.s7_19;
  const double s7_1269 = work.w_chassis_x*(work.s7_842 + (work.s7_737 + s7_1234));
  const double s7_1270 = s7_1268 + work.s1_77*work.s7_660 - s7_1269 + work.w_chassis_y*s7_1205;
  const double s7_1271 = 3.6*(work.s7_809 + (work.s7_752 + (work.s7_661 + work.s7_717)));
  const double s7_1272 = s7_1270 - s7_1271 + 0.4*(work.s7_592 - work.s7_631) + 0.5*work.s7_844;
  const double s7_1273 = 0.5169230769230769*(work.s7_731 - work.s7_820);
  const double s7_1274 = s7_1272 + 0.6*(work.s7_608 - work.s7_640) + s7_1273;
  const double s7_1275 = s7_1274 + 0.5076923076923077*(work.s7_918 + work.s7_975);
  const double s7_1276 = s7_1275 + 0.72*(work.s7_509 - work.s7_523);
  const double s7_1277 = s7_1276 + 1.6*(work.s7_577 + work.s7_622) + 1.6999999999999997*s7_1166;
  // chassis: chassis_rx, revolute, chassis_aux5
  work.Q_chassis_rx = tau[Coordinate::chassis_rx] + s7_1202;
  // chassis_aux5: chassis_ry, revolute, chassis_aux4
  const double s1_2 = work.cosines[2];
  const double s1_1 = work.sines[2];
  work.Q_chassis_ry = tau[Coordinate::chassis_ry] + s1_2*s7_1233 - s1_1*s7_1277;
  // chassis_aux4: chassis_rz, revolute, chassis_aux3
  const double s7_1278 = tau[Coordinate::chassis_rz] + work.R_chassis_z_y*s7_1233;
  const double s1_3 = work.sines[1];
  work.Q_chassis_rz = s7_1278 + work.R_chassis_z_z*s7_1277 - s1_3*s7_1202;
  // chassis_aux3: chassis_tz, prismatic, chassis_aux2
  const double s7_1279 = tau[Coordinate::chassis_tz] - work.R_chassis_z_y*s7_1158;
  work.Q_chassis_tz = s7_1279 - work.R_chassis_z_z*s7_1163 - s1_3*s7_1153;
  // chassis_aux2: chassis_ty, prismatic, chassis_aux1
  const double s7_1280 = tau[Coordinate::chassis_ty] + work.R_chassis_aux5_y_x*s7_1153;
  work.Q_chassis_ty = s7_1280 - work.R_chassis_y_z*s7_1163 - work.R_chassis_y_y*s7_1158;
  // chassis_aux1: chassis_tx, prismatic, ground
  const double s7_1281 = tau[Coordinate::chassis_tx] + work.R_chassis_aux5_x_x*s7_1153;
  work.Q_chassis_tx = s7_1281 - work.R_chassis_x_z*s7_1163 - work.R_chassis_x_y*s7_1158;
  // operations: 1851 add, 1525 multiply

  // --- step 8: Rz' M Rz and right-hand side (63) ---
  // chassis_aux1: chassis_tx, prismatic, ground
  const double F_chassis_tx_x = 15305.999999999998*work.R_chassis_aux5_x_x;
  const double F_chassis_tx_y = 15305.999999999998*work.R_chassis_x_y;
  const double F_chassis_tx_z = 15305.999999999998*work.R_chassis_x_z;
  work.N_chassis_tx_x = work.R_chassis_x_z*work.F_chassis_rx_z - work.R_chassis_x_y*work.s1_817;
  const double s8_1 = work.R_chassis_x_y*F_chassis_tx_y + work.R_chassis_x_z*F_chassis_tx_z;
  work.s8_2 = s8_1 + work.R_chassis_aux5_x_x*F_chassis_tx_x;
  // chassis_aux2: chassis_ty, prismatic, chassis_aux1
  const double F_chassis_ty_x = 15305.999999999998*work.R_chassis_aux5_y_x;
  const double F_chassis_ty_y = 15305.999999999998*work.R_chassis_y_y;
  const double F_chassis_ty_z = 15305.999999999998*work.R_chassis_y_z;
  work.N_chassis_ty_x = work.R_chassis_y_z*work.F_chassis_rx_z - work.R_chassis_y_y*work.s1_817;
  const double s8_3 = work.R_chassis_y_y*F_chassis_ty_y + work.R_chassis_y_z*F_chassis_ty_z;
  work.s8_4 = s8_3 + work.R_chassis_aux5_y_x*F_chassis_ty_x;
  const double s8_5 = work.R_chassis_x_y*F_chassis_ty_y + work.R_chassis_x_z*F_chassis_ty_z;
  work.s8_6 = s8_5 + work.R_chassis_aux5_x_x*F_chassis_ty_x;
  // chassis_aux3: chassis_tz, prismatic, chassis_aux2
  const double s8_7 = 15305.999999999998*s1_3;
  const double F_chassis_tz_y = 15305.999999999998*work.R_chassis_z_y;
  const double F_chassis_tz_z = 15305.999999999998*work.R_chassis_z_z;
  const double s8_8 = work.R_chassis_z_y*work.s1_817;
  const double s8_9 = work.R_chassis_z_z*work.F_chassis_rx_z;
  work.N_chassis_tz_x = s8_9 - s8_8;
  const double F_chassis_rz_y = work.R_chassis_z_z*work.s1_805 + s1_3*work.s1_817;
  const double N_chassis_tz_z = s1_3*work.F_chassis_rx_z + work.R_chassis_z_y*work.s1_805;
  const double s8_10 = work.R_chassis_z_y*F_chassis_tz_y + work.R_chassis_z_z*F_chassis_tz_z;
  work.s8_11 = s8_10 + s1_3*s8_7;
  const double s8_12 = work.R_chassis_y_y*F_chassis_tz_y + work.R_chassis_y_z*F_chassis_tz_z;
  work.s8_13 = s8_12 - work.R_chassis_aux5_y_x*s8_7;
  const double s8_14 = work.R_chassis_x_y*F_chassis_tz_y + work.R_chassis_x_z*F_chassis_tz_z;
  work.s8_15 = s8_14 - work.R_chassis_aux5_x_x*s8_7;
  // chassis_aux4: chassis_rz, revolute, chassis_aux3
  const double F_chassis_rz_x = s8_8 - s8_9;
  const double s8_16 = work.R_chassis_z_y*F_chassis_rz_y - work.R_chassis_z_z*N_chassis_tz_z;
  work.s8_17 = s8_16 - s1_3*F_chassis_rz_x;
  const double s8_18 = work.R_chassis_aux5_y_x*F_chassis_rz_x;
  const double s8_19 = work.R_chassis_y_y*F_chassis_rz_y + s8_18;
  work.s8_20 = s8_19 - work.R_chassis_y_z*N_chassis_tz_z;
  const double s8_21 = work.R_chassis_aux5_x_x*F_chassis_rz_x;
  const double s8_22 = work.R_chassis_x_y*F_chassis_rz_y + s8_21;
  work.s8_23 = s8_22 - work.R_chassis_x_z*N_chassis_tz_z;
  // chassis_aux5: chassis_ry, revolute, chassis_aux4
  const double F_chassis_ry_x = s1_1*work.F_chassis_rx_z + s1_2*work.s1_817;
  const double s8_24 = s1_1*work.s1_805;
  const double s8_25 = s1_2*work.s1_805;
  work.N_chassis_ry_x = s1_2*work.N_chassis_rx_y - s1_1*work.N_chassis_rx_z;
  const double N_chassis_ry_y = s1_2*work.s1_843 - s1_1*work.s1_910;
  const double N_chassis_ry_z = s1_2*work.s1_910 - s1_1*work.s1_857;
  work.s8_26 = s1_2*N_chassis_ry_y - s1_1*N_chassis_ry_z;
  const double s8_27 = work.R_chassis_z_y*N_chassis_ry_y + work.R_chassis_z_z*N_chassis_ry_z;
  work.s8_28 = s8_27 - s1_3*work.N_chassis_ry_x;
  const double s8_29 = work.R_chassis_z_y*s8_24 + work.R_chassis_z_z*s8_25;
  work.s8_30 = s8_29 + s1_3*F_chassis_ry_x;
  const double s8_31 = work.R_chassis_aux5_y_x*F_chassis_ry_x - work.R_chassis_y_z*s8_25;
  work.s8_32 = s8_31 - work.R_chassis_y_y*s8_24;
  const double s8_33 = work.R_chassis_aux5_x_x*F_chassis_ry_x - work.R_chassis_x_z*s8_25;
  work.s8_34 = s8_33 - work.R_chassis_x_y*s8_24;
  // lower_arm_left: lower_arm_left, revolute, chassis
  work.s8_35 = 150.66 + work.s1_796;
  work.F_lower_arm_left_z = work.s1_795 - 97.2;
  work.N_lower_arm_left_x = work.s1_797 + 0.62*work.s1_796 - 0.4*work.s1_795;
  work.N_lower_arm_left_y = work.s1_798 + 0.4*work.s1_794;
  work.N_lower_arm_left_z = work.s1_799 - 0.62*work.s1_794;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s8_36 = 218.0*work.b_carrier_left_rz_x - R_lower_arm_left_y_y*work.s1_786;
  work.F_carrier_left_rz_x = s8_36 - R_lower_arm_left_z_y*work.s1_787;
  work.F_carrier_left_rz_y = R_lower_arm_left_y_y*work.s1_785 - 218.0*work.s1_10;
  work.F_carrier_left_rz_z = R_lower_arm_left_z_y*work.s1_785 - 218.0*work.s1_11;
  const double s8_37 = R_lower_arm_left_y_y*work.s1_792 - R_lower_arm_left_z_y*work.s1_791;
  work.N_carrier_left_rz_x = s8_37 + work.s1_10*work.s1_787 - work.s1_11*work.s1_786;
  const double s8_38 = R_lower_arm_left_y_y*work.s1_793 - R_lower_arm_left_z_y*work.s1_789;
  work.N_carrier_left_rz_y = s8_38 + work.s1_11*work.s1_785 + work.b_carrier_left_rz_x*work.s1_787;
  const double s8_39 = R_lower_arm_left_y_y*work.s1_790 - R_lower_arm_left_z_y*work.s1_793;
  work.N_carrier_left_rz_z = s8_39 - work.b_carrier_left_rz_x*work.s1_786 - work.s1_10*work.s1_785;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s8_40 = work.R_carrier_left_aux1_y_x*work.s1_787;
  const double s8_41 = s8_40 - work.R_carrier_left_aux1_z_x*work.s1_786;
  work.F_carrier_left_rx_x = s8_41 + 218.0*work.b_carrier_left_rx_x;
  const double s8_42 = work.R_carrier_left_aux1_z_x*work.s1_785;
  const double s8_43 = s8_42 - R_carrier_left_aux1_x_x*work.s1_787;
  work.F_carrier_left_rx_y = s8_43 + 218.0*work.b_carrier_left_rx_y;
  const double s8_44 = work.R_carrier_left_aux1_y_x*work.s1_785;
  const double s8_45 = R_carrier_left_aux1_x_x*work.s1_786 - s8_44;
  work.F_carrier_left_rx_z = s8_45 + 218.0*work.b_carrier_left_rx_z;
  const double s8_46 = work.R_carrier_left_aux1_y_x*work.s1_791;
  const double s8_47 = s8_46 + work.R_carrier_left_aux1_z_x*work.s1_792;
  const double s8_48 = s8_47 + R_carrier_left_aux1_x_x*work.s1_788;
  const double s8_49 = s8_48 + work.b_carrier_left_rx_z*work.s1_786;
  work.N_carrier_left_rx_x = s8_49 - work.b_carrier_left_rx_y*work.s1_787;
  const double s8_50 = work.R_carrier_left_aux1_y_x*work.s1_789;
  const double s8_51 = s8_50 + work.R_carrier_left_aux1_z_x*work.s1_793;
  const double s8_52 = s8_51 + R_carrier_left_aux1_x_x*work.s1_791;
  const double s8_53 = s8_52 + work.b_carrier_left_rx_x*work.s1_787;
  work.N_carrier_left_rx_y = s8_53 - work.b_carrier_left_rx_z*work.s1_785;
  const double s8_54 = work.R_carrier_left_aux1_y_x*work.s1_793;
  const double s8_55 = s8_54 + work.R_carrier_left_aux1_z_x*work.s1_790;
  const double s8_56 = s8_55 + R_carrier_left_aux1_x_x*work.s1_792;
  const double s8_57 = s8_56 + work.b_carrier_left_rx_y*work.s1_785;
  work.N_carrier_left_rx_z = s8_57 - work.b_carrier_left_rx_x*work.s1_786;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s8_58 = work.R_carrier_left_aux2_y_y*work.s1_787;
  const double s8_59 = s8_58 - work.R_carrier_left_aux2_z_y*work.s1_786;
  work.F_carrier_left_ry_x = s8_59 + 218.0*work.b_carrier_left_ry_x;
  const double s8_60 = work.s1_13*work.s1_787 + work.R_carrier_left_aux2_z_y*work.s1_785;
  work.F_carrier_left_ry_y = s8_60 - 218.0*work.s1_22;
  const double s8_61 = work.R_carrier_left_aux2_y_y*work.s1_785;
  work.F_carrier_left_ry_z = 218.0*work.b_carrier_left_ry_z - s8_61 - work.s1_13*work.s1_786;
  const double s8_62 = work.R_carrier_left_aux2_y_y*work.s1_791;
  const double s8_63 = s8_62 + work.R_carrier_left_aux2_z_y*work.s1_792;
  const double s8_64 = s8_63 - work.s1_13*work.s1_788 + work.s1_22*work.s1_787;
  work.N_carrier_left_ry_x = s8_64 + work.b_carrier_left_ry_z*work.s1_786;
  const double s8_65 = work.R_carrier_left_aux2_y_y*work.s1_789;
  const double s8_66 = s8_65 + work.R_carrier_left_aux2_z_y*work.s1_793;
  const double s8_67 = s8_66 - work.s1_13*work.s1_791 + work.b_carrier_left_ry_x*work.s1_787;
  work.N_carrier_left_ry_y = s8_67 - work.b_carrier_left_ry_z*work.s1_785;
  const double s8_68 = work.R_carrier_left_aux2_y_y*work.s1_793;
  const double s8_69 = s8_68 + work.R_carrier_left_aux2_z_y*work.s1_790;
  const double s8_70 = s8_69 - work.s1_13*work.s1_792 - work.b_carrier_left_ry_x*work.s1_786;
  work.N_carrier_left_ry_z = s8_70 - work.s1_22*work.s1_785;
  // upper_arm_left: upper_arm_left, revolute, chassis
  work.s8_71 = 4.2 + work.s1_185;
  work.F_upper_arm_left_z = work.s1_184 - 7.5;
  work.N_upper_arm_left_x = work.s1_190 + 0.28*work.s1_185 - 0.5*work.s1_184;
  work.N_upper_arm_left_y = 27.0 - work.s1_188;
  work.s8_72 = 15.120000000000001 + work.s1_189;
  // arb_front_left: arb_front_left, revolute, chassis
  work.F_arb_front_left_x = 4.333333333333333 + work.s1_209;
  work.F_arb_front_left_z = 34.233333333333334 - work.s1_208;
  work.N_arb_front_left_x = 17.695999999999998 + work.s1_213;
  work.N_arb_front_left_y = work.s1_212 + 0.5*work.s1_209 - 3.95*work.s1_208;
  // lower_arm_right: lower_arm_right, revolute, chassis
  work.s8_73 = 150.66 + work.s1_781;
  work.F_lower_arm_right_z = 97.2 + work.s1_780;
  work.N_lower_arm_right_x = work.s1_782 + 0.62*work.s1_781 + 0.4*work.s1_780;
  work.N_lower_arm_right_y = work.s1_783 - 0.4*work.s1_779;
  work.N_lower_arm_right_z = work.s1_784 - 0.62*work.s1_779;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double R_lower_arm_right_z_y = work.sines[9];
  const double s8_74 = 218.0*work.b_carrier_right_rz_x - R_lower_arm_right_y_y*work.s1_771;
  work.F_carrier_right_rz_x = s8_74 - R_lower_arm_right_z_y*work.s1_772;
  work.F_carrier_right_rz_y = R_lower_arm_right_y_y*work.s1_770 - 218.0*work.s1_37;
  work.F_carrier_right_rz_z = R_lower_arm_right_z_y*work.s1_770 - 218.0*work.s1_38;
  const double s8_75 = R_lower_arm_right_y_y*work.s1_777 - R_lower_arm_right_z_y*work.s1_776;
  work.N_carrier_right_rz_x = s8_75 + work.s1_37*work.s1_772 - work.s1_38*work.s1_771;
  const double s8_76 = R_lower_arm_right_y_y*work.s1_778 - R_lower_arm_right_z_y*work.s1_774;
  work.N_carrier_right_rz_y = s8_76 + work.s1_38*work.s1_770 +
      work.b_carrier_right_rz_x*work.s1_772;
  const double s8_77 = R_lower_arm_right_y_y*work.s1_775 - R_lower_arm_right_z_y*work.s1_778;
  work.N_carrier_right_rz_z = s8_77 - work.b_carrier_right_rz_x*work.s1_771 -
      work.s1_37*work.s1_770;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s8_78 = work.R_carrier_right_aux1_y_x*work.s1_772;
  const double s8_79 = s8_78 - work.R_carrier_right_aux1_z_x*work.s1_771;
  work.F_carrier_right_rx_x = s8_79 + 218.0*work.b_carrier_right_rx_x;
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double s8_80 = work.R_carrier_right_aux1_z_x*work.s1_770;
  work.F_carrier_right_rx_y = s8_80 - R_carrier_right_aux1_x_x*work.s1_772 - 218.0*work.s1_44;
  const double s8_81 = work.R_carrier_right_aux1_y_x*work.s1_770;
  const double s8_82 = R_carrier_right_aux1_x_x*work.s1_771 - s8_81;
  work.F_carrier_right_rx_z = s8_82 + 218.0*work.b_carrier_right_rx_z;
  const double s8_83 = work.R_carrier_right_aux1_y_x*work.s1_776;
  const double s8_84 = s8_83 + work.R_carrier_right_aux1_z_x*work.s1_777;
  const double s8_85 = s8_84 + R_carrier_right_aux1_x_x*work.s1_773 + work.s1_44*work.s1_772;
  work.N_carrier_right_rx_x = s8_85 + work.b_carrier_right_rx_z*work.s1_771;
  const double s8_86 = work.R_carrier_right_aux1_y_x*work.s1_774;
  const double s8_87 = s8_86 + work.R_carrier_right_aux1_z_x*work.s1_778;
  const double s8_88 = s8_87 + R_carrier_right_aux1_x_x*work.s1_776;
  const double s8_89 = s8_88 + work.b_carrier_right_rx_x*work.s1_772;
  work.N_carrier_right_rx_y = s8_89 - work.b_carrier_right_rx_z*work.s1_770;
  const double s8_90 = work.R_carrier_right_aux1_y_x*work.s1_778;
  const double s8_91 = s8_90 + work.R_carrier_right_aux1_z_x*work.s1_775;
  const double s8_92 = s8_91 + R_carrier_right_aux1_x_x*work.s1_777;
  work.N_carrier_right_rx_z = s8_92 - work.b_carrier_right_rx_x*work.s1_771 -
      work.s1_44*work.s1_770;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s8_93 = work.R_carrier_right_aux2_y_y*work.s1_772;
  const double s8_94 = s8_93 - work.R_carrier_right_aux2_z_y*work.s1_771;
  work.F_carrier_right_ry_x = s8_94 + 218.0*work.b_carrier_right_ry_x;
  const double s8_95 = work.s1_40*work.s1_772 + work.R_carrier_right_aux2_z_y*work.s1_770;
  work.F_carrier_right_ry_y = s8_95 + 218.0*work.b_carrier_right_ry_y;
  const double s8_96 = work.R_carrier_right_aux2_y_y*work.s1_770;
  work.F_carrier_right_ry_z = 218.0*work.b_carrier_right_ry_z - s8_96 - work.s1_40*work.s1_771;
  const double s8_97 = work.R_carrier_right_aux2_y_y*work.s1_776;
  const double s8_98 = s8_97 + work.R_carrier_right_aux2_z_y*work.s1_777;
  const double s8_99 = s8_98 - work.s1_40*work.s1_773 + work.b_carrier_right_ry_z*work.s1_771;
  work.N_carrier_right_ry_x = s8_99 - work.b_carrier_right_ry_y*work.s1_772;
  const double s8_100 = work.R_carrier_right_aux2_y_y*work.s1_774;
  const double s8_101 = s8_100 + work.R_carrier_right_aux2_z_y*work.s1_778;
  const double s8_102 = s8_101 - work.s1_40*work.s1_776 + work.b_carrier_right_ry_x*work.s1_772;
  work.N_carrier_right_ry_y = s8_102 - work.b_carrier_right_ry_z*work.s1_770;
  const double s8_103 = work.R_carrier_right_aux2_y_y*work.s1_778;
  const double s8_104 = s8_103 + work.R_carrier_right_aux2_z_y*work.s1_775;
  const double s8_105 = s8_104 - work.s1_40*work.s1_777 + work.b_carrier_right_ry_y*work.s1_770;
  work.N_carrier_right_ry_z = s8_105 - work.b_carrier_right_ry_x*work.s1_771;
  // upper_arm_right: upper_arm_right, revolute, chassis
  work.F_upper_arm_right_y = work.s1_322 - 4.2;
  work.F_upper_arm_right_z = 7.5 + work.s1_321;
  work.N_upper_arm_right_x = work.s1_327 + 0.5*work.s1_321 - 0.28*work.s1_322;
  work.s8_106 = 27.0 + work.s1_325;
  work.N_upper_arm_right_z = work.s1_326 - 15.120000000000001;
  // arb_front_right: arb_front_right, revolute, chassis
  work.F_arb_front_right_x = 4.333333333333333 + work.s1_346;
  work.F_arb_front_right_z = 34.233333333333334 - work.s1_345;
  work.N_arb_front_right_x = work.s1_350 - 17.695999999999998;
  work.N_arb_front_right_y = work.s1_349 + 0.5*work.s1_346 - 3.95*work.s1_345;
  work.N_arb_front_right_z = 2.2399999999999998 + work.s1_351;
  // pitman_arm: pitman_arm, revolute, chassis
  work.F_pitman_arm_x = 3.6 - work.s1_361;
  work.F_pitman_arm_z = 39.6 - work.s1_360;
  work.N_pitman_arm_x = 19.8 - work.s1_364;
  work.N_pitman_arm_y = work.s1_366 - 4.4*work.s1_360 - 0.4*work.s1_361;
  work.N_pitman_arm_z = work.s1_365 - 1.8;
  // bell_crank: bell_crank, revolute, chassis
  work.F_bell_crank_y = work.s1_379 - 54.16666666666667;
  work.N_bell_crank_x = work.s1_383 - 32.5;
  work.N_bell_crank_z = work.s1_384 - 3.25*work.s1_379;
}

/// Part 7 of compute_chosen_accelerations: step 8: Rz' M Rz and right-hand side (63).
[[gnu::noinline]] void compute_chosen_accelerations_7(const Projection& projection,
    ChosenAccelerationsWork& __restrict work) noexcept {
  // --- step 8: Rz' M Rz and right-hand side (63), continued ---
  // bell_crank: bell_crank, revolute, chassis
  work.s8_107 = work.N_lower_arm_left_x + 0.62*work.s8_35 - 0.4*work.F_lower_arm_left_z;
  const double s8_108 = work.N_carrier_left_rz_x - 0.62*work.F_carrier_left_rz_y;
  work.s8_109 = s8_108 - 0.4*work.F_carrier_left_rz_z;
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s8_110 = R_lower_arm_left_y_y*work.N_carrier_left_rz_z;
  const double s8_111 = s8_110 - R_lower_arm_left_z_y*work.N_carrier_left_rz_y;
  const double s8_112 = s8_111 + work.b_carrier_left_rz_x*work.F_carrier_left_rz_x;
  const double s8_113 = s8_112 - work.s1_11*work.F_carrier_left_rz_z;
  work.s8_114 = s8_113 - work.s1_10*work.F_carrier_left_rz_y;
  const double s8_115 = work.N_carrier_left_rx_x - 0.62*work.F_carrier_left_rx_y;
  work.s8_116 = s8_115 - 0.4*work.F_carrier_left_rx_z;
  const double s8_117 = R_lower_arm_left_y_y*work.N_carrier_left_rx_z;
  const double s8_118 = s8_117 - R_lower_arm_left_z_y*work.N_carrier_left_rx_y;
  const double s8_119 = s8_118 + work.b_carrier_left_rz_x*work.F_carrier_left_rx_x;
  const double s8_120 = s8_119 - work.s1_11*work.F_carrier_left_rx_z;
  work.s8_121 = s8_120 - work.s1_10*work.F_carrier_left_rx_y;
  const double s8_122 = work.R_carrier_left_aux1_y_x*work.N_carrier_left_rx_y;
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double s8_123 = s8_122 + work.R_carrier_left_aux1_z_x*work.N_carrier_left_rx_z;
  const double s8_124 = s8_123 + R_carrier_left_aux1_x_x*work.N_carrier_left_rx_x;
  const double s8_125 = s8_124 + work.b_carrier_left_rx_y*work.F_carrier_left_rx_y;
  const double s8_126 = s8_125 + work.b_carrier_left_rx_z*work.F_carrier_left_rx_z;
  work.s8_127 = s8_126 + work.b_carrier_left_rx_x*work.F_carrier_left_rx_x;
  const double s8_128 = work.N_carrier_left_ry_x - 0.62*work.F_carrier_left_ry_y;
  work.s8_129 = s8_128 - 0.4*work.F_carrier_left_ry_z;
  const double s8_130 = R_lower_arm_left_y_y*work.N_carrier_left_ry_z;
  const double s8_131 = s8_130 - R_lower_arm_left_z_y*work.N_carrier_left_ry_y;
  const double s8_132 = s8_131 + work.b_carrier_left_rz_x*work.F_carrier_left_ry_x;
  const double s8_133 = s8_132 - work.s1_11*work.F_carrier_left_ry_z;
  work.s8_134 = s8_133 - work.s1_10*work.F_carrier_left_ry_y;
  const double s8_135 = work.R_carrier_left_aux1_y_x*work.N_carrier_left_ry_y;
  const double s8_136 = s8_135 + work.R_carrier_left_aux1_z_x*work.N_carrier_left_ry_z;
  const double s8_137 = s8_136 + R_carrier_left_aux1_x_x*work.N_carrier_left_ry_x;
  const double s8_138 = s8_137 + work.b_carrier_left_rx_y*work.F_carrier_left_ry_y;
  const double s8_139 = s8_138 + work.b_carrier_left_rx_z*work.F_carrier_left_ry_z;
  work.s8_140 = s8_139 + work.b_carrier_left_rx_x*work.F_carrier_left_ry_x;
  const double s8_141 = work.R_carrier_left_aux2_y_y*work.N_carrier_left_ry_y;
  const double s8_142 = s8_141 + work.R_carrier_left_aux2_z_y*work.N_carrier_left_ry_z;
  const double s8_143 = work.b_carrier_left_ry_z*work.F_carrier_left_ry_z;
  const double s8_144 = s8_142 - work.s1_13*work.N_carrier_left_ry_x + s8_143;
  const double s8_145 = s8_144 + work.b_carrier_left_ry_x*work.F_carrier_left_ry_x;
  work.s8_146 = s8_145 - work.s1_22*work.F_carrier_left_ry_y;
  work.s8_147 = work.N_upper_arm_left_x + 0.28*work.s8_71 - 0.5*work.F_upper_arm_left_z;
  const double s8_148 = work.N_arb_front_left_y + 3.95*work.F_arb_front_left_z;
  work.s8_149 = s8_148 + 0.5*work.F_arb_front_left_x;
  const double s8_150 = work.N_lower_arm_right_x + 0.62*work.s8_73;
  work.s8_151 = s8_150 + 0.4*work.F_lower_arm_right_z;
  const double s8_152 = work.N_carrier_right_rz_x + 0.4*work.F_carrier_right_rz_z;
  work.s8_153 = s8_152 - 0.62*work.F_carrier_right_rz_y;
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double R_lower_arm_right_z_y = work.sines[9];
  const double s8_154 = R_lower_arm_right_y_y*work.N_carrier_right_rz_z;
  const double s8_155 = s8_154 - R_lower_arm_right_z_y*work.N_carrier_right_rz_y;
  const double s8_156 = s8_155 + work.b_carrier_right_rz_x*work.F_carrier_right_rz_x;
  const double s8_157 = s8_156 - work.s1_38*work.F_carrier_right_rz_z;
  work.s8_158 = s8_157 - work.s1_37*work.F_carrier_right_rz_y;
  const double s8_159 = work.N_carrier_right_rx_x + 0.4*work.F_carrier_right_rx_z;
  work.s8_160 = s8_159 - 0.62*work.F_carrier_right_rx_y;
  const double s8_161 = R_lower_arm_right_y_y*work.N_carrier_right_rx_z;
  const double s8_162 = s8_161 - R_lower_arm_right_z_y*work.N_carrier_right_rx_y;
  const double s8_163 = s8_162 + work.b_carrier_right_rz_x*work.F_carrier_right_rx_x;
  const double s8_164 = s8_163 - work.s1_38*work.F_carrier_right_rx_z;
  work.s8_165 = s8_164 - work.s1_37*work.F_carrier_right_rx_y;
  const double s8_166 = work.R_carrier_right_aux1_y_x*work.N_carrier_right_rx_y;
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double s8_167 = s8_166 + work.R_carrier_right_aux1_z_x*work.N_carrier_right_rx_z;
  const double s8_168 = s8_167 + R_carrier_right_aux1_x_x*work.N_carrier_right_rx_x;
  const double s8_169 = s8_168 + work.b_carrier_right_rx_z*work.F_carrier_right_rx_z;
  const double s8_170 = s8_169 + work.b_carrier_right_rx_x*work.F_carrier_right_rx_x;
  work.s8_171 = s8_170 - work.s1_44*work.F_carrier_right_rx_y;
  const double s8_172 = work.N_carrier_right_ry_x + 0.4*work.F_carrier_right_ry_z;
  work.s8_173 = s8_172 - 0.62*work.F_carrier_right_ry_y;
  const double s8_174 = R_lower_arm_right_y_y*work.N_carrier_right_ry_z;
  const double s8_175 = s8_174 - R_lower_arm_right_z_y*work.N_carrier_right_ry_y;
  const double s8_176 = s8_175 + work.b_carrier_right_rz_x*work.F_carrier_right_ry_x;
  const double s8_177 = s8_176 - work.s1_38*work.F_carrier_right_ry_z;
  work.s8_178 = s8_177 - work.s1_37*work.F_carrier_right_ry_y;
  const double s8_179 = work.R_carrier_right_aux1_y_x*work.N_carrier_right_ry_y;
  const double s8_180 = s8_179 + work.R_carrier_right_aux1_z_x*work.N_carrier_right_ry_z;
  const double s8_181 = s8_180 + R_carrier_right_aux1_x_x*work.N_carrier_right_ry_x;
  const double s8_182 = s8_181 + work.b_carrier_right_rx_z*work.F_carrier_right_ry_z;
  const double s8_183 = s8_182 + work.b_carrier_right_rx_x*work.F_carrier_right_ry_x;
  work.s8_184 = s8_183 - work.s1_44*work.F_carrier_right_ry_y;
  const double s8_185 = work.R_carrier_right_aux2_y_y*work.N_carrier_right_ry_y;
  const double s8_186 = s8_185 + work.R_carrier_right_aux2_z_y*work.N_carrier_right_ry_z;
  const double s8_187 = work.b_carrier_right_ry_y*work.F_carrier_right_ry_y;
  const double s8_188 = s8_186 - work.s1_40*work.N_carrier_right_ry_x + s8_187;
  const double s8_189 = s8_188 + work.b_carrier_right_ry_z*work.F_carrier_right_ry_z;
  work.s8_190 = s8_189 + work.b_carrier_right_ry_x*work.F_carrier_right_ry_x;
  const double s8_191 = work.N_upper_arm_right_x + 0.5*work.F_upper_arm_right_z;
  work.s8_192 = s8_191 - 0.28*work.F_upper_arm_right_y;
  const double s8_193 = work.N_arb_front_right_y + 3.95*work.F_arb_front_right_z;
  work.s8_194 = s8_193 + 0.5*work.F_arb_front_right_x;
  work.s8_195 = work.N_pitman_arm_y + 4.4*work.F_pitman_arm_z + 0.4*work.F_pitman_arm_x;
  work.s8_196 = work.N_bell_crank_z - 3.25*work.F_bell_crank_y;
  // arb_link_front_left
  const double s8_197 = work.s1_500 - 0.4;
  const double s8_198 = work.b_carrier_left_rz_x - R_lower_arm_left_y_y*work.s1_500;
  const double s8_199 = s8_198 - R_lower_arm_left_z_y*work.s1_503;
  const double s8_200 = R_lower_arm_left_z_y*work.s1_497 - work.s1_11;
  const double s8_201 = work.b_carrier_left_rx_x + work.R_carrier_left_aux1_y_x*work.s1_503;
  const double s8_202 = s8_201 - work.R_carrier_left_aux1_z_x*work.s1_500;
  const double s8_203 = work.b_carrier_left_rx_y + work.R_carrier_left_aux1_z_x*work.s1_497;
  const double s8_204 = work.b_carrier_left_rx_z + R_carrier_left_aux1_x_x*work.s1_500;
  const double s8_205 = s8_204 - work.R_carrier_left_aux1_y_x*work.s1_497;
  const double s8_206 = work.b_carrier_left_ry_x + work.R_carrier_left_aux2_y_y*work.s1_503;
  const double s8_207 = s8_206 - work.R_carrier_left_aux2_z_y*work.s1_500;
  const double s8_208 = work.R_carrier_left_aux2_z_y*work.s1_497;
  const double s8_209 = work.b_carrier_left_ry_z - work.R_carrier_left_aux2_y_y*work.s1_497;
  const double s8_210 = s8_209 - work.s1_13*work.s1_500;
  const double s8_211 = 0.3333333333333333*(0.5 + work.s1_507);
  const double s8_212 = 0.3333333333333333*(3.95 - work.s1_505);
  const double s8_213 = 0.3333333333333333*(0.62 + work.s1_503);
  const double s8_214 = 0.3333333333333333*s8_197;
  work.s8_215 = s8_197*s8_212;
  const double s8_216 = 0.3333333333333333*s8_199;
  const double s8_217 = 0.3333333333333333*(R_lower_arm_left_y_y*work.s1_497 - work.s1_10);
  const double s8_218 = 0.3333333333333333*s8_200;
  work.s8_219 = s8_200*s8_212 + s8_199*s8_211;
  const double s8_220 = 0.3333333333333333*s8_202;
  const double s8_221 = 0.3333333333333333*(s8_203 - R_carrier_left_aux1_x_x*work.s1_503);
  const double s8_222 = 0.3333333333333333*s8_205;
  work.s8_223 = s8_205*s8_212 + s8_202*s8_211;
  const double s8_224 = 0.3333333333333333*s8_207;
  const double s8_225 = 0.3333333333333333*(work.s1_13*work.s1_503 - work.s1_22 + s8_208);
  const double s8_226 = 0.3333333333333333*s8_210;
  work.s8_227 = s8_210*s8_212 + s8_207*s8_211;
  work.s8_228 = work.F_arb_front_left_x + s8_211;
  work.s8_229 = work.F_arb_front_left_z + s8_212;
  work.s8_230 = work.N_arb_front_left_x + work.s1_500*s8_212;
  work.s8_231 = work.N_arb_front_left_y + work.s1_503*s8_211 - work.s1_497*s8_212;
  work.s8_232 = 2.2399999999999998 + work.s1_214 + work.s1_500*s8_211;
  // arb_link_front_right
  const double s8_233 = 0.4 + work.s1_529;
  const double s8_234 = work.b_carrier_right_rz_x - R_lower_arm_right_y_y*work.s1_529;
  const double s8_235 = s8_234 - R_lower_arm_right_z_y*work.s1_532;
  const double s8_236 = R_lower_arm_right_z_y*work.s1_525 - work.s1_38;
  const double s8_237 = work.b_carrier_right_rx_x + work.R_carrier_right_aux1_y_x*work.s1_532;
  const double s8_238 = s8_237 - work.R_carrier_right_aux1_z_x*work.s1_529;
  const double s8_239 = work.R_carrier_right_aux1_z_x*work.s1_525 - work.s1_44;
  const double s8_240 = work.b_carrier_right_rx_z + R_carrier_right_aux1_x_x*work.s1_529;
  const double s8_241 = s8_240 - work.R_carrier_right_aux1_y_x*work.s1_525;
  const double s8_242 = work.b_carrier_right_ry_x + work.R_carrier_right_aux2_y_y*work.s1_532;
  const double s8_243 = s8_242 - work.R_carrier_right_aux2_z_y*work.s1_529;
  const double s8_244 = work.b_carrier_right_ry_y + work.s1_40*work.s1_532;
  const double s8_245 = work.b_carrier_right_ry_z - work.R_carrier_right_aux2_y_y*work.s1_525;
  const double s8_246 = s8_245 - work.s1_40*work.s1_529;
  const double s8_247 = 0.3333333333333333*(0.5 + work.s1_536);
  const double s8_248 = 0.3333333333333333*(3.95 - work.s1_534);
  const double s8_249 = 0.3333333333333333*(0.62 + work.s1_532);
  const double s8_250 = 0.3333333333333333*s8_233;
  work.s8_251 = s8_233*s8_248;
  const double s8_252 = 0.3333333333333333*s8_235;
  const double s8_253 = 0.3333333333333333*(R_lower_arm_right_y_y*work.s1_525 - work.s1_37);
  const double s8_254 = 0.3333333333333333*s8_236;
  work.s8_255 = s8_236*s8_248 + s8_235*s8_247;
  const double s8_256 = 0.3333333333333333*s8_238;
  const double s8_257 = 0.3333333333333333*(s8_239 - R_carrier_right_aux1_x_x*work.s1_532);
  const double s8_258 = 0.3333333333333333*s8_241;
  work.s8_259 = s8_241*s8_248 + s8_238*s8_247;
  const double s8_260 = 0.3333333333333333*s8_243;
  const double s8_261 = 0.3333333333333333*(s8_244 + work.R_carrier_right_aux2_z_y*work.s1_525);
  const double s8_262 = 0.3333333333333333*s8_246;
  work.s8_263 = s8_246*s8_248 + s8_243*s8_247;
  work.s8_264 = work.F_arb_front_right_x + s8_247;
  work.s8_265 = work.F_arb_front_right_z + s8_248;
  work.s8_266 = work.N_arb_front_right_x + work.s1_529*s8_248;
  work.s8_267 = work.N_arb_front_right_y + work.s1_532*s8_247 - work.s1_525*s8_248;
  work.s8_268 = work.N_arb_front_right_z - work.s1_529*s8_247;
  // drag_link
  const double s8_269 = 1.5*(0.4 - work.s1_556);
  const double s8_270 = 1.5*(4.4 - work.s1_555);
  work.s8_271 = work.s1_553*s8_269;
  work.s8_272 = work.F_pitman_arm_x + s8_269;
  work.s8_273 = work.F_pitman_arm_z + s8_270;
  work.s8_274 = work.N_pitman_arm_x + work.s1_553*s8_270;
  work.s8_275 = work.N_pitman_arm_y - work.s1_554*s8_270 - 0.6*s8_269;
  work.s8_276 = work.N_pitman_arm_z - work.s8_271;
  const double s8_277 = 1.5*(work.s1_554 - 3.25);
  // tie_rod_left
  const double s8_278 = 0.62 + work.s1_579;
  const double s8_279 = work.b_carrier_left_rz_x - R_lower_arm_left_y_y*work.s1_576;
  const double s8_280 = s8_279 - R_lower_arm_left_z_y*work.s1_579;
  const double s8_281 = R_lower_arm_left_y_y*work.s1_573 - work.s1_10;
  const double s8_282 = work.b_carrier_left_rx_x + work.R_carrier_left_aux1_y_x*work.s1_579;
  const double s8_283 = s8_282 - work.R_carrier_left_aux1_z_x*work.s1_576;
  const double s8_284 = work.b_carrier_left_rx_y + work.R_carrier_left_aux1_z_x*work.s1_573;
  const double s8_285 = s8_284 - R_carrier_left_aux1_x_x*work.s1_579;
  const double s8_286 = work.b_carrier_left_rx_z + R_carrier_left_aux1_x_x*work.s1_576;
  const double s8_287 = work.b_carrier_left_ry_x + work.R_carrier_left_aux2_y_y*work.s1_579;
  const double s8_288 = s8_287 - work.R_carrier_left_aux2_z_y*work.s1_576;
  const double s8_289 = work.R_carrier_left_aux2_z_y*work.s1_573;
  const double s8_290 = work.s1_13*work.s1_579 - work.s1_22 + s8_289;
  const double s8_291 = work.b_carrier_left_ry_z - work.R_carrier_left_aux2_y_y*work.s1_573;
  const double s8_292 = 1.1666666666666667*(work.s1_585 - 3.25);
  const double s8_293 = 1.1666666666666667*s8_278;
  const double s8_294 = 1.1666666666666667*(work.s1_576 - 0.4);
  work.s8_295 = s8_213 + (work.s8_35 + s8_293);
  work.s8_296 = s8_214 + (work.F_lower_arm_left_z + s8_294);
  const double s8_297 = work.N_lower_arm_left_x + work.s1_507*s8_213 + 0.72*s8_214;
  work.s8_298 = s8_297 + work.s1_584*s8_294 - 0.6*s8_293;
  work.s8_299 = work.N_lower_arm_left_y - work.s1_505*s8_214 - work.s1_585*s8_294;
  work.s8_300 = work.N_lower_arm_left_z - work.s1_505*s8_213 - work.s1_585*s8_293;
  work.s8_301 = s8_278*s8_292;
  const double s8_302 = 1.1666666666666667*s8_280;
  const double s8_303 = 1.1666666666666667*s8_281;
  const double s8_304 = 1.1666666666666667*(R_lower_arm_left_z_y*work.s1_573 - work.s1_11);
  work.s8_305 = s8_216 + (work.F_carrier_left_rz_x + s8_302);
  work.s8_306 = s8_217 + (work.F_carrier_left_rz_y + s8_303);
  work.s8_307 = s8_218 + (work.F_carrier_left_rz_z + s8_304);
  const double s8_308 = work.N_carrier_left_rz_x + 0.72*s8_218 - work.s1_507*s8_217 + 0.6*s8_303;
  work.s8_309 = s8_308 + work.s1_584*s8_304;
  const double s8_310 = work.N_carrier_left_rz_y + work.s1_507*s8_216 - work.s1_505*s8_218;
  work.s8_311 = s8_310 - work.s1_585*s8_304 - 0.6*s8_302;
  const double s8_312 = work.N_carrier_left_rz_z + work.s1_505*s8_217 - 0.72*s8_216;
  work.s8_313 = s8_312 + work.s1_585*s8_303 - work.s1_584*s8_302;
  work.s8_314 = s8_281*s8_292 - work.s1_597*s8_280;
  const double s8_315 = 1.1666666666666667*s8_283;
  const double s8_316 = 1.1666666666666667*s8_285;
  const double s8_317 = 1.1666666666666667*(s8_286 - work.R_carrier_left_aux1_y_x*work.s1_573);
  work.s8_318 = s8_220 + (work.F_carrier_left_rx_x + s8_315);
  work.s8_319 = s8_221 + (work.F_carrier_left_rx_y + s8_316);
  work.s8_320 = s8_222 + (work.F_carrier_left_rx_z + s8_317);
  const double s8_321 = work.N_carrier_left_rx_x + 0.72*s8_222 - work.s1_507*s8_221 + 0.6*s8_316;
  work.s8_322 = s8_321 + work.s1_584*s8_317;
  const double s8_323 = work.N_carrier_left_rx_y + work.s1_507*s8_220 - work.s1_505*s8_222;
  work.s8_324 = s8_323 - work.s1_585*s8_317 - 0.6*s8_315;
  const double s8_325 = work.N_carrier_left_rx_z + work.s1_505*s8_221 - 0.72*s8_220;
  work.s8_326 = s8_325 + work.s1_585*s8_316 - work.s1_584*s8_315;
  work.s8_327 = s8_285*s8_292 - work.s1_597*s8_283;
  const double s8_328 = 1.1666666666666667*s8_288;
  const double s8_329 = 1.1666666666666667*s8_290;
  const double s8_330 = 1.1666666666666667*(s8_291 - work.s1_13*work.s1_576);
  work.s8_331 = s8_224 + (work.F_carrier_left_ry_x + s8_328);
  work.s8_332 = s8_225 + (work.F_carrier_left_ry_y + s8_329);
  work.s8_333 = s8_226 + (work.F_carrier_left_ry_z + s8_330);
  const double s8_334 = work.N_carrier_left_ry_x + 0.72*s8_226 - work.s1_507*s8_225 + 0.6*s8_329;
  work.s8_335 = s8_334 + work.s1_584*s8_330;
  const double s8_336 = work.N_carrier_left_ry_y + work.s1_507*s8_224 - work.s1_505*s8_226;
  work.s8_337 = s8_336 - work.s1_585*s8_330 - 0.6*s8_328;
  const double s8_338 = work.N_carrier_left_ry_z + work.s1_505*s8_225 - 0.72*s8_224;
  work.s8_339 = s8_338 + work.s1_585*s8_329 - work.s1_584*s8_328;
  work.s8_340 = s8_290*s8_292 - work.s1_597*s8_288;
  // tie_rod_right
  const double s8_341 = 0.62 + work.s1_609;
  const double s8_342 = work.b_carrier_right_rz_x - R_lower_arm_right_y_y*work.s1_607;
  const double s8_343 = s8_342 - R_lower_arm_right_z_y*work.s1_609;
  const double s8_344 = R_lower_arm_right_y_y*work.s1_604 - work.s1_37;
  const double s8_345 = work.b_carrier_right_rx_x + work.R_carrier_right_aux1_y_x*work.s1_609;
  const double s8_346 = s8_345 - work.R_carrier_right_aux1_z_x*work.s1_607;
  const double s8_347 = work.R_carrier_right_aux1_z_x*work.s1_604 - work.s1_44;
  const double s8_348 = s8_347 - R_carrier_right_aux1_x_x*work.s1_609;
  const double s8_349 = work.b_carrier_right_rx_z + R_carrier_right_aux1_x_x*work.s1_607;
  const double s8_350 = work.b_carrier_right_ry_x + work.R_carrier_right_aux2_y_y*work.s1_609;
  const double s8_351 = s8_350 - work.R_carrier_right_aux2_z_y*work.s1_607;
  const double s8_352 = work.b_carrier_right_ry_y + work.s1_40*work.s1_609;
  const double s8_353 = s8_352 + work.R_carrier_right_aux2_z_y*work.s1_604;
  const double s8_354 = work.b_carrier_right_ry_z - work.R_carrier_right_aux2_y_y*work.s1_604;
  const double s8_355 = 1.1666666666666667*(work.s1_611 - 3.25);
  const double s8_356 = 1.1666666666666667*s8_341;
  const double s8_357 = 1.1666666666666667*(0.4 + work.s1_607);
  work.s8_358 = s8_249 + (work.s8_73 + s8_356);
  work.s8_359 = s8_250 + (work.F_lower_arm_right_z + s8_357);
  const double s8_360 = work.N_lower_arm_right_x + work.s1_536*s8_249 - 0.72*s8_250 - 0.6*s8_356;
  work.s8_361 = s8_360 - work.s1_610*s8_357;
  work.s8_362 = work.N_lower_arm_right_y - work.s1_534*s8_250 - work.s1_611*s8_357;
  work.s8_363 = work.N_lower_arm_right_z - work.s1_534*s8_249 - work.s1_611*s8_356;
  work.s8_364 = s8_341*s8_355;
  const double s8_365 = 1.1666666666666667*s8_343;
  const double s8_366 = 1.1666666666666667*s8_344;
  const double s8_367 = 1.1666666666666667*(R_lower_arm_right_z_y*work.s1_604 - work.s1_38);
  work.s8_368 = s8_252 + (work.F_carrier_right_rz_x + s8_365);
  work.s8_369 = s8_253 + (work.F_carrier_right_rz_y + s8_366);
  work.s8_370 = s8_254 + (work.F_carrier_right_rz_z + s8_367);
  const double s8_371 = work.N_carrier_right_rz_x - work.s1_536*s8_253 - 0.72*s8_254;
  work.s8_372 = s8_371 + 0.6*s8_366 - work.s1_610*s8_367;
  const double s8_373 = work.N_carrier_right_rz_y + work.s1_536*s8_252 - work.s1_534*s8_254;
  work.s8_374 = s8_373 - work.s1_611*s8_367 - 0.6*s8_365;
  const double s8_375 = work.N_carrier_right_rz_z + 0.72*s8_252 + work.s1_534*s8_253;
  work.s8_376 = s8_375 + work.s1_610*s8_365 + work.s1_611*s8_366;
  work.s8_377 = s8_344*s8_355 + work.s1_623*s8_343;
  const double s8_378 = 1.1666666666666667*s8_346;
  const double s8_379 = 1.1666666666666667*s8_348;
  const double s8_380 = 1.1666666666666667*(s8_349 - work.R_carrier_right_aux1_y_x*work.s1_604);
  work.s8_381 = s8_256 + (work.F_carrier_right_rx_x + s8_378);
  work.s8_382 = s8_257 + (work.F_carrier_right_rx_y + s8_379);
  work.s8_383 = s8_258 + (work.F_carrier_right_rx_z + s8_380);
  const double s8_384 = work.N_carrier_right_rx_x - work.s1_536*s8_257 - 0.72*s8_258;
  work.s8_385 = s8_384 + 0.6*s8_379 - work.s1_610*s8_380;
  const double s8_386 = work.N_carrier_right_rx_y + work.s1_536*s8_256 - work.s1_534*s8_258;
  work.s8_387 = s8_386 - work.s1_611*s8_380 - 0.6*s8_378;
  const double s8_388 = work.N_carrier_right_rx_z + 0.72*s8_256 + work.s1_534*s8_257;
  work.s8_389 = s8_388 + work.s1_610*s8_378 + work.s1_611*s8_379;
  work.s8_390 = s8_348*s8_355 + work.s1_623*s8_346;
  const double s8_391 = 1.1666666666666667*s8_351;
  const double s8_392 = 1.1666666666666667*s8_353;
  const double s8_393 = 1.1666666666666667*(s8_354 - work.s1_40*work.s1_607);
  work.s8_394 = s8_260 + (work.F_carrier_right_ry_x + s8_391);
  work.s8_395 = s8_261 + (work.F_carrier_right_ry_y + s8_392);
  work.s8_396 = s8_262 + (work.F_carrier_right_ry_z + s8_393);
  const double s8_397 = work.N_carrier_right_ry_x - work.s1_536*s8_261 - 0.72*s8_262;
  work.s8_398 = s8_397 + 0.6*s8_392 - work.s1_610*s8_393;
  const double s8_399 = work.N_carrier_right_ry_y + work.s1_536*s8_260 - work.s1_534*s8_262;
  work.s8_400 = s8_399 - work.s1_611*s8_393 - 0.6*s8_391;
  const double s8_401 = work.N_carrier_right_ry_z + 0.72*s8_260 + work.s1_534*s8_261;
  work.s8_402 = s8_401 + work.s1_610*s8_391 + work.s1_611*s8_392;
  work.s8_403 = s8_353*s8_355 + work.s1_623*s8_351;
  work.s8_404 = work.s1_623 - work.s1_597 - work.s1_380 - work.s1_571;
  work.s8_405 = s8_277 + (work.F_bell_crank_y + (s8_292 + s8_355));
  const double s8_406 = work.N_bell_crank_x + work.s1_556*s8_277 - work.s1_579*s8_292;
  work.s8_407 = s8_406 - work.s1_609*s8_355;
  const double s8_408 = work.N_bell_crank_y + work.s1_556*work.s1_571 - work.s1_579*work.s1_597;
  work.s8_409 = s8_408 + work.s1_609*work.s1_623;
  const double s8_410 = work.N_bell_crank_z + 0.5*work.s1_571 + work.s1_555*s8_277;
  const double s8_411 = s8_410 + work.s1_576*work.s1_597 + work.s1_573*s8_292;
  work.s8_412 = s8_411 + work.s1_604*s8_355 - work.s1_607*work.s1_623;
  const double s8_413 = projection.Rz[0]*work.s8_107 + projection.Rz[3]*work.s8_109;
  const double s8_414 = s8_413 + projection.Rz[6]*work.s8_116 + projection.Rz[9]*work.s8_129;
  const double s8_415 = projection.Rz[0]*work.s8_109 + projection.Rz[3]*work.s8_114;
  const double s8_416 = s8_415 + projection.Rz[6]*work.s8_121 + projection.Rz[9]*work.s8_134;
  const double s8_417 = projection.Rz[0]*work.s8_116 + projection.Rz[3]*work.s8_121;
  const double s8_418 = s8_417 + projection.Rz[6]*work.s8_127 + projection.Rz[9]*work.s8_140;
  const double s8_419 = projection.Rz[0]*work.s8_129 + projection.Rz[3]*work.s8_134;
  const double s8_420 = s8_419 + projection.Rz[6]*work.s8_140 + projection.Rz[9]*work.s8_146;
  const double s8_421 = projection.Rz[0]*work.s8_215 + projection.Rz[3]*work.s8_219;
  const double s8_422 = s8_421 + projection.Rz[6]*work.s8_223 + projection.Rz[9]*work.s8_227;
  work.s8_423 = s8_422 + projection.Rz[15]*work.s8_149;
  const double s8_424 = projection.Rz[18]*work.s8_151 + projection.Rz[21]*work.s8_153;
  const double s8_425 = s8_424 + projection.Rz[24]*work.s8_160 + projection.Rz[27]*work.s8_173;
  work.s8_426 = s8_425 + projection.Rz[33]*work.s8_251 - projection.Rz[39]*work.s8_364;
  const double s8_427 = projection.Rz[18]*work.s8_153 + projection.Rz[21]*work.s8_158;
  const double s8_428 = s8_427 + projection.Rz[24]*work.s8_165 + projection.Rz[27]*work.s8_178;
  work.s8_429 = s8_428 + projection.Rz[33]*work.s8_255 + projection.Rz[39]*work.s8_377;
  const double s8_430 = projection.Rz[18]*work.s8_160 + projection.Rz[21]*work.s8_165;
  const double s8_431 = s8_430 + projection.Rz[24]*work.s8_171 + projection.Rz[27]*work.s8_184;
  work.s8_432 = s8_431 + projection.Rz[33]*work.s8_259 + projection.Rz[39]*work.s8_390;
  const double s8_433 = projection.Rz[18]*work.s8_173 + projection.Rz[21]*work.s8_178;
  const double s8_434 = s8_433 + projection.Rz[24]*work.s8_184 + projection.Rz[27]*work.s8_190;
  work.s8_435 = s8_434 + projection.Rz[33]*work.s8_263 + projection.Rz[39]*work.s8_403;
  work.s8_436 = projection.Rz[30]*work.s8_192;
  const double s8_437 = projection.Rz[18]*work.s8_251 + projection.Rz[21]*work.s8_255;
  const double s8_438 = s8_437 + projection.Rz[24]*work.s8_259 + projection.Rz[27]*work.s8_263;
  work.s8_439 = s8_438 + projection.Rz[33]*work.s8_194;
  const double s8_440 = projection.Rz[0]*work.s8_296 + projection.Rz[3]*work.s8_307;
  const double s8_441 = s8_440 + projection.Rz[6]*work.s8_320 + projection.Rz[9]*work.s8_333;
  const double s8_442 = s8_441 + projection.Rz[12]*work.F_upper_arm_left_z;
  const double s8_443 = s8_442 + projection.Rz[15]*work.s8_229 + projection.Rz[18]*work.s8_359;
  const double s8_444 = s8_443 + projection.Rz[21]*work.s8_370 + projection.Rz[24]*work.s8_383;
  const double s8_445 = projection.Rz[30]*work.F_upper_arm_right_z;
  const double s8_446 = s8_444 + projection.Rz[27]*work.s8_396 + s8_445;
  const double s8_447 = s8_446 + projection.Rz[33]*work.s8_265 + projection.Rz[36]*work.s8_273;
  work.s8_448 = projection.Rz[36]*work.s8_195 - projection.Rz[39]*work.s8_271;
  const double s8_449 = projection.Rz[3]*work.s8_305 + projection.Rz[6]*work.s8_318;
  const double s8_450 = s8_449 + projection.Rz[9]*work.s8_331 + projection.Rz[15]*work.s8_228;
  const double s8_451 = s8_450 + projection.Rz[21]*work.s8_368 + projection.Rz[24]*work.s8_381;
  const double s8_452 = s8_451 + projection.Rz[27]*work.s8_394 + projection.Rz[33]*work.s8_264;
  const double s8_453 = s8_452 + projection.Rz[36]*work.s8_272 + projection.Rz[39]*work.s8_404;
  const double s8_454 = projection.Rz[3]*work.s8_306 - projection.Rz[0]*work.s8_295;
  const double s8_455 = s8_454 + projection.Rz[6]*work.s8_319 + projection.Rz[9]*work.s8_332;
  const double s8_456 = s8_455 - projection.Rz[12]*work.s8_71 - projection.Rz[18]*work.s8_358;
  const double s8_457 = s8_456 + projection.Rz[21]*work.s8_369 + projection.Rz[24]*work.s8_382;
  const double s8_458 = projection.Rz[30]*work.F_upper_arm_right_y;
  const double s8_459 = s8_457 + projection.Rz[27]*work.s8_395 + s8_458;
  const double s8_460 = s8_459 + projection.Rz[39]*work.s8_405;
  const double s8_461 = projection.Rz[0]*work.s8_298 + projection.Rz[3]*work.s8_309;
  const double s8_462 = s8_461 + projection.Rz[6]*work.s8_322 + projection.Rz[9]*work.s8_335;
  const double s8_463 = s8_462 + projection.Rz[12]*work.N_upper_arm_left_x;
  const double s8_464 = s8_463 + projection.Rz[15]*work.s8_230 + projection.Rz[18]*work.s8_361;
  const double s8_465 = s8_464 + projection.Rz[21]*work.s8_372 + projection.Rz[24]*work.s8_385;
  const double s8_466 = projection.Rz[30]*work.N_upper_arm_right_x;
  const double s8_467 = s8_465 + projection.Rz[27]*work.s8_398 + s8_466;
  const double s8_468 = s8_467 + projection.Rz[33]*work.s8_266 + projection.Rz[36]*work.s8_274;
  work.s8_469 = s8_468 + projection.Rz[39]*work.s8_407;
  const double s8_470 = projection.Rz[0]*work.s8_299 + projection.Rz[3]*work.s8_311;
  const double s8_471 = s8_470 + projection.Rz[6]*work.s8_324 + projection.Rz[9]*work.s8_337;
  const double s8_472 = s8_471 + projection.Rz[12]*work.N_upper_arm_left_y;
  const double s8_473 = s8_472 + projection.Rz[15]*work.s8_231 + projection.Rz[18]*work.s8_362;
  const double s8_474 = s8_473 + projection.Rz[21]*work.s8_374 + projection.Rz[24]*work.s8_387;
  const double s8_475 = s8_474 + projection.Rz[27]*work.s8_400 - projection.Rz[30]*work.s8_106;
  const double s8_476 = s8_475 + projection.Rz[33]*work.s8_267 + projection.Rz[36]*work.s8_275;
  const double s8_477 = s8_476 + projection.Rz[39]*work.s8_409;
  const double s8_478 = projection.Rz[0]*work.s8_300 + projection.Rz[3]*work.s8_313;
  const double s8_479 = s8_478 + projection.Rz[6]*work.s8_326 + projection.Rz[9]*work.s8_339;
  const double s8_480 = s8_479 - projection.Rz[12]*work.s8_72 - projection.Rz[15]*work.s8_232;
  const double s8_481 = s8_480 + projection.Rz[18]*work.s8_363 + projection.Rz[21]*work.s8_376;
  const double s8_482 = s8_481 + projection.Rz[24]*work.s8_389 + projection.Rz[27]*work.s8_402;
  const double s8_483 = s8_482 + projection.Rz[30]*work.N_upper_arm_right_z;
  const double s8_484 = s8_483 + projection.Rz[33]*work.s8_268 + projection.Rz[36]*work.s8_276;
  const double s8_485 = s8_484 + projection.Rz[39]*work.s8_412;
  const double s8_486 = projection.Rz[3]*work.s8_314 - projection.Rz[0]*work.s8_301;
  const double s8_487 = s8_486 + projection.Rz[6]*work.s8_327 + projection.Rz[9]*work.s8_340;
  const double s8_488 = s8_487 - projection.Rz[18]*work.s8_364 + projection.Rz[21]*work.s8_377;
  const double s8_489 = s8_488 + projection.Rz[24]*work.s8_390 + projection.Rz[27]*work.s8_403;
  work.s8_490 = s8_489 - projection.Rz[36]*work.s8_271 + projection.Rz[39]*work.s8_196;
  work.s8_491 = work.cosines[2]*s8_477 - work.sines[2]*s8_485;
  const double s1_3 = work.sines[1];
  work.s8_492 = work.R_chassis_z_y*s8_477 + work.R_chassis_z_z*s8_485 - s1_3*work.s8_469;
  work.s8_493 = work.R_chassis_z_y*s8_460 + work.R_chassis_z_z*s8_447 - s1_3*s8_453;
  const double s8_494 = work.R_chassis_y_y*s8_460 + work.R_chassis_y_z*s8_447;
  work.s8_495 = s8_494 + work.R_chassis_aux5_y_x*s8_453;
  const double s8_496 = work.R_chassis_x_y*s8_460 + work.R_chassis_x_z*s8_447;
  work.s8_497 = s8_496 + work.R_chassis_aux5_x_x*s8_453;
  const double s8_498 = s8_414 + projection.Rz[15]*work.s8_215 - projection.Rz[39]*work.s8_301;
  const double s8_499 = s8_416 + projection.Rz[15]*work.s8_219 + projection.Rz[39]*work.s8_314;
  const double s8_500 = s8_418 + projection.Rz[15]*work.s8_223 + projection.Rz[39]*work.s8_327;
  const double s8_501 = projection.Rz[0]*s8_498 + projection.Rz[3]*s8_499;
  const double s8_502 = s8_420 + projection.Rz[15]*work.s8_227 + projection.Rz[39]*work.s8_340;
  work.s8_503 = s8_501 + projection.Rz[6]*s8_500 + projection.Rz[9]*s8_502;
  work.s8_504 = projection.Rz[12]*(projection.Rz[12]*work.s8_147);
}

/// Part 8 of compute_chosen_accelerations: step 8: Rz' M Rz and right-hand side (63).
[[gnu::noinline]] void compute_chosen_accelerations_8(const Projection& projection,
    ChosenAccelerationsWork& __restrict work) noexcept {
  // --- step 8: Rz' M Rz and right-hand side (63), continued ---
  // tie_rod_right
  const double s8_505 = work.s8_503 + work.s8_504 + projection.Rz[15]*work.s8_423;
  const double s8_506 = s8_505 + projection.Rz[18]*work.s8_426 + projection.Rz[21]*work.s8_429;
  const double s8_507 = s8_506 + projection.Rz[24]*work.s8_432 + projection.Rz[27]*work.s8_435;
  const double s8_508 = s8_507 + projection.Rz[30]*work.s8_436 + projection.Rz[33]*work.s8_439;
  work.s8_509 = s8_508 + projection.Rz[36]*work.s8_448 + projection.Rz[39]*work.s8_490;
  const double s8_510 = projection.Rz[3]*work.Q_carrier_left_rz;
  const double s8_511 = projection.Rz[0]*work.Q_lower_arm_left + s8_510;
  const double s8_512 = s8_511 + projection.Rz[6]*work.Q_carrier_left_rx;
  const double s8_513 = s8_512 + projection.Rz[9]*work.Q_carrier_left_ry;
  const double s8_514 = s8_513 + projection.Rz[12]*work.Q_upper_arm_left;
  const double s8_515 = s8_514 + projection.Rz[15]*work.Q_arb_front_left;
  const double s8_516 = s8_515 + projection.Rz[18]*work.Q_lower_arm_right;
  const double s8_517 = s8_516 + projection.Rz[21]*work.Q_carrier_right_rz;
  const double s8_518 = s8_517 + projection.Rz[24]*work.Q_carrier_right_rx;
  const double s8_519 = s8_518 + projection.Rz[27]*work.Q_carrier_right_ry;
  const double s8_520 = s8_519 + projection.Rz[30]*work.Q_upper_arm_right;
  const double s8_521 = s8_520 + projection.Rz[33]*work.Q_arb_front_right;
  const double s8_522 = s8_521 + projection.Rz[36]*work.Q_pitman_arm;
  work.s8_523 = s8_522 + projection.Rz[39]*work.Q_bell_crank;
  const double s8_524 = projection.Rz[1]*work.s8_107 + projection.Rz[4]*work.s8_109;
  const double s8_525 = s8_524 + projection.Rz[7]*work.s8_116 + projection.Rz[10]*work.s8_129;
  const double s8_526 = s8_525 + projection.Rz[16]*work.s8_215 - projection.Rz[40]*work.s8_301;
  const double s8_527 = projection.Rz[1]*work.s8_109 + projection.Rz[4]*work.s8_114;
  const double s8_528 = s8_527 + projection.Rz[7]*work.s8_121 + projection.Rz[10]*work.s8_134;
  const double s8_529 = s8_528 + projection.Rz[16]*work.s8_219 + projection.Rz[40]*work.s8_314;
  const double s8_530 = projection.Rz[1]*work.s8_116 + projection.Rz[4]*work.s8_121;
  const double s8_531 = s8_530 + projection.Rz[7]*work.s8_127 + projection.Rz[10]*work.s8_140;
  const double s8_532 = s8_531 + projection.Rz[16]*work.s8_223 + projection.Rz[40]*work.s8_327;
  const double s8_533 = projection.Rz[1]*work.s8_129 + projection.Rz[4]*work.s8_134;
  const double s8_534 = s8_533 + projection.Rz[7]*work.s8_140 + projection.Rz[10]*work.s8_146;
  const double s8_535 = s8_534 + projection.Rz[16]*work.s8_227 + projection.Rz[40]*work.s8_340;
  const double s8_536 = projection.Rz[13]*work.s8_147;
  const double s8_537 = projection.Rz[1]*work.s8_215 + projection.Rz[4]*work.s8_219;
  const double s8_538 = s8_537 + projection.Rz[7]*work.s8_223 + projection.Rz[10]*work.s8_227;
  const double s8_539 = s8_538 + projection.Rz[16]*work.s8_149;
  const double s8_540 = projection.Rz[19]*work.s8_151 + projection.Rz[22]*work.s8_153;
  const double s8_541 = s8_540 + projection.Rz[25]*work.s8_160 + projection.Rz[28]*work.s8_173;
  const double s8_542 = s8_541 + projection.Rz[34]*work.s8_251 - projection.Rz[40]*work.s8_364;
  const double s8_543 = projection.Rz[19]*work.s8_153 + projection.Rz[22]*work.s8_158;
  const double s8_544 = s8_543 + projection.Rz[25]*work.s8_165 + projection.Rz[28]*work.s8_178;
  const double s8_545 = s8_544 + projection.Rz[34]*work.s8_255 + projection.Rz[40]*work.s8_377;
  const double s8_546 = projection.Rz[19]*work.s8_160 + projection.Rz[22]*work.s8_165;
  const double s8_547 = s8_546 + projection.Rz[25]*work.s8_171 + projection.Rz[28]*work.s8_184;
  const double s8_548 = s8_547 + projection.Rz[34]*work.s8_259 + projection.Rz[40]*work.s8_390;
  const double s8_549 = projection.Rz[19]*work.s8_173 + projection.Rz[22]*work.s8_178;
  const double s8_550 = s8_549 + projection.Rz[25]*work.s8_184 + projection.Rz[28]*work.s8_190;
  const double s8_551 = s8_550 + projection.Rz[34]*work.s8_263 + projection.Rz[40]*work.s8_403;
  const double s8_552 = projection.Rz[31]*work.s8_192;
  const double s8_553 = projection.Rz[19]*work.s8_251 + projection.Rz[22]*work.s8_255;
  const double s8_554 = s8_553 + projection.Rz[25]*work.s8_259 + projection.Rz[28]*work.s8_263;
  const double s8_555 = s8_554 + projection.Rz[34]*work.s8_194;
  const double s8_556 = projection.Rz[1]*work.s8_296 + projection.Rz[4]*work.s8_307;
  const double s8_557 = s8_556 + projection.Rz[7]*work.s8_320 + projection.Rz[10]*work.s8_333;
  const double s8_558 = s8_557 + projection.Rz[13]*work.F_upper_arm_left_z;
  const double s8_559 = s8_558 + projection.Rz[16]*work.s8_229 + projection.Rz[19]*work.s8_359;
  const double s8_560 = s8_559 + projection.Rz[22]*work.s8_370 + projection.Rz[25]*work.s8_383;
  const double s8_561 = projection.Rz[31]*work.F_upper_arm_right_z;
  const double s8_562 = s8_560 + projection.Rz[28]*work.s8_396 + s8_561;
  const double s8_563 = s8_562 + projection.Rz[34]*work.s8_265 + projection.Rz[37]*work.s8_273;
  const double s8_564 = projection.Rz[37]*work.s8_195 - projection.Rz[40]*work.s8_271;
  const double s8_565 = projection.Rz[4]*work.s8_305 + projection.Rz[7]*work.s8_318;
  const double s8_566 = s8_565 + projection.Rz[10]*work.s8_331 + projection.Rz[16]*work.s8_228;
  const double s8_567 = s8_566 + projection.Rz[22]*work.s8_368 + projection.Rz[25]*work.s8_381;
  const double s8_568 = s8_567 + projection.Rz[28]*work.s8_394 + projection.Rz[34]*work.s8_264;
  const double s8_569 = s8_568 + projection.Rz[37]*work.s8_272 + projection.Rz[40]*work.s8_404;
  const double s8_570 = projection.Rz[4]*work.s8_306 - projection.Rz[1]*work.s8_295;
  const double s8_571 = s8_570 + projection.Rz[7]*work.s8_319 + projection.Rz[10]*work.s8_332;
  const double s8_572 = s8_571 - projection.Rz[13]*work.s8_71 - projection.Rz[19]*work.s8_358;
  const double s8_573 = s8_572 + projection.Rz[22]*work.s8_369 + projection.Rz[25]*work.s8_382;
  const double s8_574 = projection.Rz[31]*work.F_upper_arm_right_y;
  const double s8_575 = s8_573 + projection.Rz[28]*work.s8_395 + s8_574;
  const double s8_576 = s8_575 + projection.Rz[40]*work.s8_405;
  const double s8_577 = projection.Rz[1]*work.s8_298 + projection.Rz[4]*work.s8_309;
  const double s8_578 = s8_577 + projection.Rz[7]*work.s8_322 + projection.Rz[10]*work.s8_335;
  const double s8_579 = s8_578 + projection.Rz[13]*work.N_upper_arm_left_x;
  const double s8_580 = s8_579 + projection.Rz[16]*work.s8_230 + projection.Rz[19]*work.s8_361;
  const double s8_581 = s8_580 + projection.Rz[22]*work.s8_372 + projection.Rz[25]*work.s8_385;
  const double s8_582 = projection.Rz[31]*work.N_upper_arm_right_x;
  const double s8_583 = s8_581 + projection.Rz[28]*work.s8_398 + s8_582;
  const double s8_584 = s8_583 + projection.Rz[34]*work.s8_266 + projection.Rz[37]*work.s8_274;
  work.s8_585 = s8_584 + projection.Rz[40]*work.s8_407;
  const double s8_586 = projection.Rz[1]*work.s8_299 + projection.Rz[4]*work.s8_311;
  const double s8_587 = s8_586 + projection.Rz[7]*work.s8_324 + projection.Rz[10]*work.s8_337;
  const double s8_588 = s8_587 + projection.Rz[13]*work.N_upper_arm_left_y;
  const double s8_589 = s8_588 + projection.Rz[16]*work.s8_231 + projection.Rz[19]*work.s8_362;
  const double s8_590 = s8_589 + projection.Rz[22]*work.s8_374 + projection.Rz[25]*work.s8_387;
  const double s8_591 = s8_590 + projection.Rz[28]*work.s8_400 - projection.Rz[31]*work.s8_106;
  const double s8_592 = s8_591 + projection.Rz[34]*work.s8_267 + projection.Rz[37]*work.s8_275;
  const double s8_593 = s8_592 + projection.Rz[40]*work.s8_409;
  const double s8_594 = projection.Rz[1]*work.s8_300 + projection.Rz[4]*work.s8_313;
  const double s8_595 = s8_594 + projection.Rz[7]*work.s8_326 + projection.Rz[10]*work.s8_339;
  const double s8_596 = s8_595 - projection.Rz[13]*work.s8_72 - projection.Rz[16]*work.s8_232;
  const double s8_597 = s8_596 + projection.Rz[19]*work.s8_363 + projection.Rz[22]*work.s8_376;
  const double s8_598 = s8_597 + projection.Rz[25]*work.s8_389 + projection.Rz[28]*work.s8_402;
  const double s8_599 = s8_598 + projection.Rz[31]*work.N_upper_arm_right_z;
  const double s8_600 = s8_599 + projection.Rz[34]*work.s8_268 + projection.Rz[37]*work.s8_276;
  const double s8_601 = s8_600 + projection.Rz[40]*work.s8_412;
  const double s8_602 = projection.Rz[4]*work.s8_314 - projection.Rz[1]*work.s8_301;
  const double s8_603 = s8_602 + projection.Rz[7]*work.s8_327 + projection.Rz[10]*work.s8_340;
  const double s8_604 = s8_603 - projection.Rz[19]*work.s8_364 + projection.Rz[22]*work.s8_377;
  const double s8_605 = s8_604 + projection.Rz[25]*work.s8_390 + projection.Rz[28]*work.s8_403;
  const double s8_606 = s8_605 - projection.Rz[37]*work.s8_271 + projection.Rz[40]*work.s8_196;
  const double s1_2 = work.cosines[2];
  const double s1_1 = work.sines[2];
  work.s8_607 = s1_2*s8_593 - s1_1*s8_601;
  const double s1_3 = work.sines[1];
  work.s8_608 = work.R_chassis_z_y*s8_593 + work.R_chassis_z_z*s8_601 - s1_3*work.s8_585;
  work.s8_609 = work.R_chassis_z_y*s8_576 + work.R_chassis_z_z*s8_563 - s1_3*s8_569;
  const double s8_610 = work.R_chassis_y_y*s8_576 + work.R_chassis_y_z*s8_563;
  work.s8_611 = s8_610 + work.R_chassis_aux5_y_x*s8_569;
  const double s8_612 = work.R_chassis_x_y*s8_576 + work.R_chassis_x_z*s8_563;
  work.s8_613 = s8_612 + work.R_chassis_aux5_x_x*s8_569;
  const double s8_614 = projection.Rz[0]*s8_526 + projection.Rz[3]*s8_529;
  const double s8_615 = s8_614 + projection.Rz[6]*s8_532 + projection.Rz[9]*s8_535;
  const double s8_616 = s8_615 + projection.Rz[12]*s8_536 + projection.Rz[15]*s8_539;
  const double s8_617 = s8_616 + projection.Rz[18]*s8_542 + projection.Rz[21]*s8_545;
  const double s8_618 = s8_617 + projection.Rz[24]*s8_548 + projection.Rz[27]*s8_551;
  const double s8_619 = s8_618 + projection.Rz[30]*s8_552 + projection.Rz[33]*s8_555;
  work.s8_620 = s8_619 + projection.Rz[36]*s8_564 + projection.Rz[39]*s8_606;
  const double s8_621 = projection.Rz[1]*s8_526 + projection.Rz[4]*s8_529;
  const double s8_622 = s8_621 + projection.Rz[7]*s8_532 + projection.Rz[10]*s8_535;
  const double s8_623 = s8_622 + projection.Rz[13]*s8_536 + projection.Rz[16]*s8_539;
  const double s8_624 = s8_623 + projection.Rz[19]*s8_542 + projection.Rz[22]*s8_545;
  const double s8_625 = s8_624 + projection.Rz[25]*s8_548 + projection.Rz[28]*s8_551;
  const double s8_626 = s8_625 + projection.Rz[31]*s8_552 + projection.Rz[34]*s8_555;
  work.s8_627 = s8_626 + projection.Rz[37]*s8_564 + projection.Rz[40]*s8_606;
  const double s8_628 = projection.Rz[4]*work.Q_carrier_left_rz;
  const double s8_629 = projection.Rz[1]*work.Q_lower_arm_left + s8_628;
  const double s8_630 = s8_629 + projection.Rz[7]*work.Q_carrier_left_rx;
  const double s8_631 = s8_630 + projection.Rz[10]*work.Q_carrier_left_ry;
  const double s8_632 = s8_631 + projection.Rz[13]*work.Q_upper_arm_left;
  const double s8_633 = s8_632 + projection.Rz[16]*work.Q_arb_front_left;
  const double s8_634 = s8_633 + projection.Rz[19]*work.Q_lower_arm_right;
  const double s8_635 = s8_634 + projection.Rz[22]*work.Q_carrier_right_rz;
  const double s8_636 = s8_635 + projection.Rz[25]*work.Q_carrier_right_rx;
  const double s8_637 = s8_636 + projection.Rz[28]*work.Q_carrier_right_ry;
  const double s8_638 = s8_637 + projection.Rz[31]*work.Q_upper_arm_right;
  const double s8_639 = s8_638 + projection.Rz[34]*work.Q_arb_front_right;
  const double s8_640 = s8_639 + projection.Rz[37]*work.Q_pitman_arm;
  work.s8_641 = s8_640 + projection.Rz[40]*work.Q_bell_crank;
  const double s8_642 = projection.Rz[2]*work.s8_107 + projection.Rz[5]*work.s8_109;
  const double s8_643 = s8_642 + projection.Rz[8]*work.s8_116 + projection.Rz[11]*work.s8_129;
  const double s8_644 = s8_643 + projection.Rz[17]*work.s8_215 - projection.Rz[41]*work.s8_301;
  const double s8_645 = projection.Rz[2]*work.s8_109 + projection.Rz[5]*work.s8_114;
  const double s8_646 = s8_645 + projection.Rz[8]*work.s8_121 + projection.Rz[11]*work.s8_134;
  const double s8_647 = s8_646 + projection.Rz[17]*work.s8_219 + projection.Rz[41]*work.s8_314;
  const double s8_648 = projection.Rz[2]*work.s8_116 + projection.Rz[5]*work.s8_121;
  const double s8_649 = s8_648 + projection.Rz[8]*work.s8_127 + projection.Rz[11]*work.s8_140;
  const double s8_650 = s8_649 + projection.Rz[17]*work.s8_223 + projection.Rz[41]*work.s8_327;
  const double s8_651 = projection.Rz[2]*work.s8_129 + projection.Rz[5]*work.s8_134;
  const double s8_652 = s8_651 + projection.Rz[8]*work.s8_140 + projection.Rz[11]*work.s8_146;
  const double s8_653 = s8_652 + projection.Rz[17]*work.s8_227 + projection.Rz[41]*work.s8_340;
  const double s8_654 = projection.Rz[14]*work.s8_147;
  const double s8_655 = projection.Rz[2]*work.s8_215 + projection.Rz[5]*work.s8_219;
  const double s8_656 = s8_655 + projection.Rz[8]*work.s8_223 + projection.Rz[11]*work.s8_227;
  const double s8_657 = s8_656 + projection.Rz[17]*work.s8_149;
  const double s8_658 = projection.Rz[20]*work.s8_151 + projection.Rz[23]*work.s8_153;
  const double s8_659 = s8_658 + projection.Rz[26]*work.s8_160 + projection.Rz[29]*work.s8_173;
  const double s8_660 = s8_659 + projection.Rz[35]*work.s8_251 - projection.Rz[41]*work.s8_364;
  const double s8_661 = projection.Rz[20]*work.s8_153 + projection.Rz[23]*work.s8_158;
  const double s8_662 = s8_661 + projection.Rz[26]*work.s8_165 + projection.Rz[29]*work.s8_178;
  const double s8_663 = s8_662 + projection.Rz[35]*work.s8_255 + projection.Rz[41]*work.s8_377;
  const double s8_664 = projection.Rz[20]*work.s8_160 + projection.Rz[23]*work.s8_165;
  const double s8_665 = s8_664 + projection.Rz[26]*work.s8_171 + projection.Rz[29]*work.s8_184;
  const double s8_666 = s8_665 + projection.Rz[35]*work.s8_259 + projection.Rz[41]*work.s8_390;
  const double s8_667 = projection.Rz[20]*work.s8_173 + projection.Rz[23]*work.s8_178;
  const double s8_668 = s8_667 + projection.Rz[26]*work.s8_184 + projection.Rz[29]*work.s8_190;
  const double s8_669 = s8_668 + projection.Rz[35]*work.s8_263 + projection.Rz[41]*work.s8_403;
  const double s8_670 = projection.Rz[32]*work.s8_192;
  const double s8_671 = projection.Rz[20]*work.s8_251 + projection.Rz[23]*work.s8_255;
  const double s8_672 = s8_671 + projection.Rz[26]*work.s8_259 + projection.Rz[29]*work.s8_263;
  const double s8_673 = s8_672 + projection.Rz[35]*work.s8_194;
  const double s8_674 = projection.Rz[2]*work.s8_296 + projection.Rz[5]*work.s8_307;
  const double s8_675 = s8_674 + projection.Rz[8]*work.s8_320 + projection.Rz[11]*work.s8_333;
  const double s8_676 = s8_675 + projection.Rz[14]*work.F_upper_arm_left_z;
  const double s8_677 = s8_676 + projection.Rz[17]*work.s8_229 + projection.Rz[20]*work.s8_359;
  const double s8_678 = s8_677 + projection.Rz[23]*work.s8_370 + projection.Rz[26]*work.s8_383;
  const double s8_679 = projection.Rz[32]*work.F_upper_arm_right_z;
  const double s8_680 = s8_678 + projection.Rz[29]*work.s8_396 + s8_679;
  const double s8_681 = s8_680 + projection.Rz[35]*work.s8_265 + projection.Rz[38]*work.s8_273;
  const double s8_682 = projection.Rz[38]*work.s8_195 - projection.Rz[41]*work.s8_271;
  const double s8_683 = projection.Rz[5]*work.s8_305 + projection.Rz[8]*work.s8_318;
  const double s8_684 = s8_683 + projection.Rz[11]*work.s8_331 + projection.Rz[17]*work.s8_228;
  const double s8_685 = s8_684 + projection.Rz[23]*work.s8_368 + projection.Rz[26]*work.s8_381;
  const double s8_686 = s8_685 + projection.Rz[29]*work.s8_394 + projection.Rz[35]*work.s8_264;
  const double s8_687 = s8_686 + projection.Rz[38]*work.s8_272 + projection.Rz[41]*work.s8_404;
  const double s8_688 = projection.Rz[5]*work.s8_306 - projection.Rz[2]*work.s8_295;
  const double s8_689 = s8_688 + projection.Rz[8]*work.s8_319 + projection.Rz[11]*work.s8_332;
  const double s8_690 = s8_689 - projection.Rz[14]*work.s8_71 - projection.Rz[20]*work.s8_358;
  const double s8_691 = s8_690 + projection.Rz[23]*work.s8_369 + projection.Rz[26]*work.s8_382;
  const double s8_692 = projection.Rz[32]*work.F_upper_arm_right_y;
  const double s8_693 = s8_691 + projection.Rz[29]*work.s8_395 + s8_692;
  const double s8_694 = s8_693 + projection.Rz[41]*work.s8_405;
  const double s8_695 = projection.Rz[2]*work.s8_298 + projection.Rz[5]*work.s8_309;
  const double s8_696 = s8_695 + projection.Rz[8]*work.s8_322 + projection.Rz[11]*work.s8_335;
  const double s8_697 = s8_696 + projection.Rz[14]*work.N_upper_arm_left_x;
  const double s8_698 = s8_697 + projection.Rz[17]*work.s8_230 + projection.Rz[20]*work.s8_361;
  const double s8_699 = s8_698 + projection.Rz[23]*work.s8_372 + projection.Rz[26]*work.s8_385;
  const double s8_700 = projection.Rz[32]*work.N_upper_arm_right_x;
  const double s8_701 = s8_699 + projection.Rz[29]*work.s8_398 + s8_700;
  const double s8_702 = s8_701 + projection.Rz[35]*work.s8_266 + projection.Rz[38]*work.s8_274;
  work.s8_703 = s8_702 + projection.Rz[41]*work.s8_407;
  const double s8_704 = projection.Rz[2]*work.s8_299 + projection.Rz[5]*work.s8_311;
  const double s8_705 = s8_704 + projection.Rz[8]*work.s8_324 + projection.Rz[11]*work.s8_337;
  const double s8_706 = s8_705 + projection.Rz[14]*work.N_upper_arm_left_y;
  const double s8_707 = s8_706 + projection.Rz[17]*work.s8_231 + projection.Rz[20]*work.s8_362;
  const double s8_708 = s8_707 + projection.Rz[23]*work.s8_374 + projection.Rz[26]*work.s8_387;
  const double s8_709 = s8_708 + projection.Rz[29]*work.s8_400 - projection.Rz[32]*work.s8_106;
  const double s8_710 = s8_709 + projection.Rz[35]*work.s8_267 + projection.Rz[38]*work.s8_275;
  const double s8_711 = s8_710 + projection.Rz[41]*work.s8_409;
  const double s8_712 = projection.Rz[2]*work.s8_300 + projection.Rz[5]*work.s8_313;
  const double s8_713 = s8_712 + projection.Rz[8]*work.s8_326 + projection.Rz[11]*work.s8_339;
  const double s8_714 = s8_713 - projection.Rz[14]*work.s8_72 - projection.Rz[17]*work.s8_232;
  const double s8_715 = s8_714 + projection.Rz[20]*work.s8_363 + projection.Rz[23]*work.s8_376;
  const double s8_716 = s8_715 + projection.Rz[26]*work.s8_389 + projection.Rz[29]*work.s8_402;
  const double s8_717 = s8_716 + projection.Rz[32]*work.N_upper_arm_right_z;
  const double s8_718 = s8_717 + projection.Rz[35]*work.s8_268 + projection.Rz[38]*work.s8_276;
  const double s8_719 = s8_718 + projection.Rz[41]*work.s8_412;
  const double s8_720 = projection.Rz[5]*work.s8_314 - projection.Rz[2]*work.s8_301;
  const double s8_721 = s8_720 + projection.Rz[8]*work.s8_327 + projection.Rz[11]*work.s8_340;
  const double s8_722 = s8_721 - projection.Rz[20]*work.s8_364 + projection.Rz[23]*work.s8_377;
  const double s8_723 = s8_722 + projection.Rz[26]*work.s8_390 + projection.Rz[29]*work.s8_403;
  const double s8_724 = s8_723 - projection.Rz[38]*work.s8_271 + projection.Rz[41]*work.s8_196;
  work.s8_725 = s1_2*s8_711 - s1_1*s8_719;
  work.s8_726 = work.R_chassis_z_y*s8_711 + work.R_chassis_z_z*s8_719 - s1_3*work.s8_703;
  work.s8_727 = work.R_chassis_z_y*s8_694 + work.R_chassis_z_z*s8_681 - s1_3*s8_687;
  const double s8_728 = work.R_chassis_y_y*s8_694 + work.R_chassis_y_z*s8_681;
  work.s8_729 = s8_728 + work.R_chassis_aux5_y_x*s8_687;
  const double s8_730 = work.R_chassis_x_y*s8_694 + work.R_chassis_x_z*s8_681;
  work.s8_731 = s8_730 + work.R_chassis_aux5_x_x*s8_687;
  const double s8_732 = projection.Rz[0]*s8_644 + projection.Rz[3]*s8_647;
  const double s8_733 = s8_732 + projection.Rz[6]*s8_650 + projection.Rz[9]*s8_653;
  const double s8_734 = s8_733 + projection.Rz[12]*s8_654 + projection.Rz[15]*s8_657;
  const double s8_735 = s8_734 + projection.Rz[18]*s8_660 + projection.Rz[21]*s8_663;
  const double s8_736 = s8_735 + projection.Rz[24]*s8_666 + projection.Rz[27]*s8_669;
  const double s8_737 = s8_736 + projection.Rz[30]*s8_670 + projection.Rz[33]*s8_673;
  work.s8_738 = s8_737 + projection.Rz[36]*s8_682 + projection.Rz[39]*s8_724;
  const double s8_739 = projection.Rz[1]*s8_644 + projection.Rz[4]*s8_647;
  const double s8_740 = s8_739 + projection.Rz[7]*s8_650 + projection.Rz[10]*s8_653;
  const double s8_741 = s8_740 + projection.Rz[13]*s8_654 + projection.Rz[16]*s8_657;
  const double s8_742 = s8_741 + projection.Rz[19]*s8_660 + projection.Rz[22]*s8_663;
  const double s8_743 = s8_742 + projection.Rz[25]*s8_666 + projection.Rz[28]*s8_669;
  const double s8_744 = s8_743 + projection.Rz[31]*s8_670 + projection.Rz[34]*s8_673;
  work.s8_745 = s8_744 + projection.Rz[37]*s8_682 + projection.Rz[40]*s8_724;
  const double s8_746 = projection.Rz[2]*s8_644 + projection.Rz[5]*s8_647;
  const double s8_747 = s8_746 + projection.Rz[8]*s8_650 + projection.Rz[11]*s8_653;
  const double s8_748 = s8_747 + projection.Rz[14]*s8_654 + projection.Rz[17]*s8_657;
  const double s8_749 = s8_748 + projection.Rz[20]*s8_660 + projection.Rz[23]*s8_663;
  const double s8_750 = s8_749 + projection.Rz[26]*s8_666 + projection.Rz[29]*s8_669;
  const double s8_751 = s8_750 + projection.Rz[32]*s8_670 + projection.Rz[35]*s8_673;
  work.s8_752 = s8_751 + projection.Rz[38]*s8_682 + projection.Rz[41]*s8_724;
  const double s8_753 = projection.Rz[5]*work.Q_carrier_left_rz;
  const double s8_754 = projection.Rz[2]*work.Q_lower_arm_left + s8_753;
  const double s8_755 = s8_754 + projection.Rz[8]*work.Q_carrier_left_rx;
  const double s8_756 = s8_755 + projection.Rz[11]*work.Q_carrier_left_ry;
  const double s8_757 = s8_756 + projection.Rz[14]*work.Q_upper_arm_left;
  const double s8_758 = s8_757 + projection.Rz[17]*work.Q_arb_front_left;
  const double s8_759 = s8_758 + projection.Rz[20]*work.Q_lower_arm_right;
  const double s8_760 = s8_759 + projection.Rz[23]*work.Q_carrier_right_rz;
  const double s8_761 = s8_760 + projection.Rz[26]*work.Q_carrier_right_rx;
  const double s8_762 = s8_761 + projection.Rz[29]*work.Q_carrier_right_ry;
  const double s8_763 = s8_762 + projection.Rz[32]*work.Q_upper_arm_right;
  const double s8_764 = s8_763 + projection.Rz[35]*work.Q_arb_front_right;
  const double s8_765 = s8_764 + projection.Rz[38]*work.Q_pitman_arm;
  work.s8_766 = s8_765 + projection.Rz[41]*work.Q_bell_crank;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s8_767 = work.R_carrier_left_aux2_y_y*work.s1_164;
  const double s8_768 = s8_767 - work.R_carrier_left_aux2_z_y*work.s1_163;
  const double F_wheel_front_left_x = s8_768 + 105.0*work.b_wheel_front_left_x;
  const double s8_769 = work.s1_13*work.s1_164 + work.R_carrier_left_aux2_z_y*work.s1_162;
  const double F_wheel_front_left_y = s8_769 - 105.0*work.s1_30;
  const double s8_770 = work.R_carrier_left_aux2_y_y*work.s1_162;
  const double F_wheel_front_left_z = 105.0*work.b_wheel_front_left_z - s8_770 -
      work.s1_13*work.s1_163;
  const double s8_771 = work.R_carrier_left_aux2_y_y*work.s1_171;
  const double s8_772 = s8_771 + work.R_carrier_left_aux2_z_y*work.s1_172;
  const double s8_773 = s8_772 - work.s1_13*work.s1_168 + work.s1_30*work.s1_164;
  work.N_wheel_front_left_x = s8_773 + work.b_wheel_front_left_z*work.s1_163;
  const double s8_774 = work.R_carrier_left_aux2_y_y*work.s1_169;
  const double s8_775 = s8_774 + work.R_carrier_left_aux2_z_y*work.s1_173;
  const double s8_776 = s8_775 - work.s1_13*work.s1_171 + work.b_wheel_front_left_x*work.s1_164;
  const double N_wheel_front_left_y = s8_776 - work.b_wheel_front_left_z*work.s1_162;
  const double s8_777 = work.R_carrier_left_aux2_y_y*work.s1_173;
  const double s8_778 = s8_777 + work.R_carrier_left_aux2_z_y*work.s1_170;
  const double s8_779 = s8_778 - work.s1_13*work.s1_172 - work.b_wheel_front_left_x*work.s1_163;
  const double N_wheel_front_left_z = s8_779 - work.s1_30*work.s1_162;
  const double s8_780 = work.R_carrier_left_aux2_y_y*N_wheel_front_left_y;
  const double s8_781 = s8_780 + work.R_carrier_left_aux2_z_y*N_wheel_front_left_z;
  const double s8_782 = s8_781 - work.s1_13*work.N_wheel_front_left_x;
  const double s8_783 = s8_782 + work.b_wheel_front_left_z*F_wheel_front_left_z;
  const double s8_784 = s8_783 + work.b_wheel_front_left_x*F_wheel_front_left_x;
  work.s8_785 = s8_784 - work.s1_30*F_wheel_front_left_y;
  const double s8_786 = s8_782 + work.b_carrier_left_ry_z*F_wheel_front_left_z;
  const double s8_787 = s8_786 + work.b_carrier_left_ry_x*F_wheel_front_left_x;
  const double s8_788 = s8_787 - work.s1_22*F_wheel_front_left_y;
  const double s8_789 = work.R_carrier_left_aux1_y_x*N_wheel_front_left_y;
  const double s8_790 = s8_789 + work.R_carrier_left_aux1_z_x*N_wheel_front_left_z;
  const double s8_791 = s8_790 + work.cosines[4]*work.N_wheel_front_left_x;
  const double s8_792 = s8_791 + work.b_carrier_left_rx_y*F_wheel_front_left_y;
  const double s8_793 = s8_792 + work.b_carrier_left_rx_z*F_wheel_front_left_z;
  const double s8_794 = s8_793 + work.b_carrier_left_rx_x*F_wheel_front_left_x;
  const double s8_795 = work.cosines[3]*N_wheel_front_left_z;
  const double s8_796 = work.b_carrier_left_rz_x*F_wheel_front_left_x;
  const double s8_797 = s8_795 - work.sines[3]*N_wheel_front_left_y + s8_796;
  const double s8_798 = s8_797 - work.s1_11*F_wheel_front_left_z;
  const double s8_799 = s8_798 - work.s1_10*F_wheel_front_left_y;
  const double s8_800 = work.N_wheel_front_left_x - 0.62*F_wheel_front_left_y;
  const double s8_801 = s8_800 - 0.4*F_wheel_front_left_z;
  work.s8_802 = s1_2*N_wheel_front_left_y - s1_1*N_wheel_front_left_z;
  const double s8_803 = work.R_chassis_z_y*N_wheel_front_left_y;
  const double s8_804 = s8_803 + work.R_chassis_z_z*N_wheel_front_left_z;
  work.s8_805 = s8_804 - s1_3*work.N_wheel_front_left_x;
  const double s8_806 = work.R_chassis_z_y*F_wheel_front_left_y;
  const double s8_807 = s8_806 + work.R_chassis_z_z*F_wheel_front_left_z;
  work.s8_808 = s8_807 - s1_3*F_wheel_front_left_x;
  const double s8_809 = work.R_chassis_y_y*F_wheel_front_left_y;
  const double s8_810 = s8_809 + work.R_chassis_y_z*F_wheel_front_left_z;
  work.s8_811 = s8_810 + work.R_chassis_aux5_y_x*F_wheel_front_left_x;
  const double s8_812 = work.R_chassis_x_y*F_wheel_front_left_y;
  const double s8_813 = s8_812 + work.R_chassis_x_z*F_wheel_front_left_z;
  work.s8_814 = s8_813 + work.R_chassis_aux5_x_x*F_wheel_front_left_x;
  const double s8_815 = projection.Rz[0]*s8_801 + projection.Rz[3]*s8_799;
  work.s8_816 = s8_815 + projection.Rz[6]*s8_794 + projection.Rz[9]*s8_788;
  const double s8_817 = projection.Rz[1]*s8_801 + projection.Rz[4]*s8_799;
  work.s8_818 = s8_817 + projection.Rz[7]*s8_794 + projection.Rz[10]*s8_788;
  const double s8_819 = projection.Rz[2]*s8_801 + projection.Rz[5]*s8_799;
  work.s8_820 = s8_819 + projection.Rz[8]*s8_794 + projection.Rz[11]*s8_788;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s8_821 = work.R_carrier_right_aux2_y_y*work.s1_301;
  const double s8_822 = s8_821 - work.R_carrier_right_aux2_z_y*work.s1_300;
  work.F_wheel_front_right_x = s8_822 + 105.0*work.b_wheel_front_right_x;
  const double s8_823 = work.s1_40*work.s1_301 + work.R_carrier_right_aux2_z_y*work.s1_299;
  work.F_wheel_front_right_y = s8_823 - 105.0*work.s1_56;
  const double s8_824 = work.R_carrier_right_aux2_y_y*work.s1_299;
  work.F_wheel_front_right_z = 105.0*work.b_wheel_front_right_z - s8_824 - work.s1_40*work.s1_300;
  const double s8_825 = work.R_carrier_right_aux2_y_y*work.s1_308;
  const double s8_826 = s8_825 + work.R_carrier_right_aux2_z_y*work.s1_309;
  const double s8_827 = s8_826 - work.s1_40*work.s1_305 + work.s1_56*work.s1_301;
  work.N_wheel_front_right_x = s8_827 + work.b_wheel_front_right_z*work.s1_300;
  const double s8_828 = work.R_carrier_right_aux2_y_y*work.s1_306;
  const double s8_829 = s8_828 + work.R_carrier_right_aux2_z_y*work.s1_310;
  const double s8_830 = s8_829 - work.s1_40*work.s1_308 + work.b_wheel_front_right_x*work.s1_301;
  work.N_wheel_front_right_y = s8_830 - work.b_wheel_front_right_z*work.s1_299;
  const double s8_831 = work.R_carrier_right_aux2_y_y*work.s1_310;
  const double s8_832 = s8_831 + work.R_carrier_right_aux2_z_y*work.s1_307;
  work.s8_833 = s8_832 - work.s1_40*work.s1_309 - work.b_wheel_front_right_x*work.s1_300;
}

/// Part 9 of compute_chosen_accelerations: step 8: Rz' M Rz and right-hand side (63).
[[gnu::noinline]] void compute_chosen_accelerations_9(const State& state,
    const Projection& projection, ChosenAccelerationsWork& __restrict work) noexcept {
  // --- step 8: Rz' M Rz and right-hand side (63), continued ---
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double N_wheel_front_right_z = work.s8_833 - work.s1_56*work.s1_299;
  const double s8_834 = work.R_carrier_right_aux2_y_y*work.N_wheel_front_right_y;
  const double s8_835 = s8_834 + work.R_carrier_right_aux2_z_y*N_wheel_front_right_z;
  const double s8_836 = s8_835 - work.s1_40*work.N_wheel_front_right_x;
  const double s8_837 = s8_836 + work.b_wheel_front_right_z*work.F_wheel_front_right_z;
  const double s8_838 = s8_837 + work.b_wheel_front_right_x*work.F_wheel_front_right_x;
  work.s8_839 = s8_838 - work.s1_56*work.F_wheel_front_right_y;
  const double s8_840 = s8_836 + work.b_carrier_right_ry_y*work.F_wheel_front_right_y;
  const double s8_841 = s8_840 + work.b_carrier_right_ry_z*work.F_wheel_front_right_z;
  const double s8_842 = s8_841 + work.b_carrier_right_ry_x*work.F_wheel_front_right_x;
  const double s8_843 = work.R_carrier_right_aux1_y_x*work.N_wheel_front_right_y;
  const double s8_844 = s8_843 + work.R_carrier_right_aux1_z_x*N_wheel_front_right_z;
  const double s8_845 = s8_844 + work.cosines[10]*work.N_wheel_front_right_x;
  const double s8_846 = s8_845 + work.b_carrier_right_rx_z*work.F_wheel_front_right_z;
  const double s8_847 = s8_846 + work.b_carrier_right_rx_x*work.F_wheel_front_right_x;
  const double s8_848 = s8_847 - work.s1_44*work.F_wheel_front_right_y;
  const double s8_849 = work.sines[9]*work.N_wheel_front_right_y;
  const double s8_850 = work.b_carrier_right_rz_x*work.F_wheel_front_right_x;
  const double s8_851 = work.cosines[9]*N_wheel_front_right_z - s8_849 + s8_850;
  const double s8_852 = s8_851 - work.s1_38*work.F_wheel_front_right_z;
  const double s8_853 = s8_852 - work.s1_37*work.F_wheel_front_right_y;
  const double s8_854 = work.N_wheel_front_right_x + 0.4*work.F_wheel_front_right_z;
  const double s8_855 = s8_854 - 0.62*work.F_wheel_front_right_y;
  const double s1_2 = work.cosines[2];
  const double s1_1 = work.sines[2];
  work.s8_856 = s1_2*work.N_wheel_front_right_y - s1_1*N_wheel_front_right_z;
  const double s8_857 = work.R_chassis_z_y*work.N_wheel_front_right_y;
  const double s1_3 = work.sines[1];
  const double s8_858 = s8_857 + work.R_chassis_z_z*N_wheel_front_right_z;
  work.s8_859 = s8_858 - s1_3*work.N_wheel_front_right_x;
  const double s8_860 = work.R_chassis_z_y*work.F_wheel_front_right_y;
  const double s8_861 = s8_860 + work.R_chassis_z_z*work.F_wheel_front_right_z;
  work.s8_862 = s8_861 - s1_3*work.F_wheel_front_right_x;
  const double s8_863 = work.R_chassis_y_y*work.F_wheel_front_right_y;
  const double s8_864 = s8_863 + work.R_chassis_y_z*work.F_wheel_front_right_z;
  work.s8_865 = s8_864 + work.R_chassis_aux5_y_x*work.F_wheel_front_right_x;
  const double s8_866 = work.R_chassis_x_y*work.F_wheel_front_right_y;
  const double s8_867 = s8_866 + work.R_chassis_x_z*work.F_wheel_front_right_z;
  work.s8_868 = s8_867 + work.R_chassis_aux5_x_x*work.F_wheel_front_right_x;
  const double s8_869 = projection.Rz[18]*s8_855 + projection.Rz[21]*s8_853;
  work.s8_870 = s8_869 + projection.Rz[24]*s8_848 + projection.Rz[27]*s8_842;
  const double s8_871 = projection.Rz[19]*s8_855 + projection.Rz[22]*s8_853;
  work.s8_872 = s8_871 + projection.Rz[25]*s8_848 + projection.Rz[28]*s8_842;
  const double s8_873 = projection.Rz[20]*s8_855 + projection.Rz[23]*s8_853;
  work.s8_874 = s8_873 + projection.Rz[26]*s8_848 + projection.Rz[29]*s8_842;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double F_rear_axle_rz_x = 1174.0*z_rear_axle_ty - work.N_rear_axle_tz_x;
  const double F_rear_axle_rz_y = work.N_rear_axle_ty_z - 1174.0*work.r_rear_axle_aux1_x;
  const double N_rear_axle_rz_x = work.s1_768 + work.r_rear_axle_aux1_x*work.N_rear_axle_tx_y;
  const double N_rear_axle_rz_y = work.s1_769 + z_rear_axle_ty*work.N_rear_axle_tx_y;
  const double s8_875 = work.s1_766 - z_rear_axle_ty*work.N_rear_axle_tz_x;
  const double N_rear_axle_rz_z = s8_875 - work.r_rear_axle_aux1_x*work.N_rear_axle_ty_z;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double F_rear_axle_ry_x = R_rear_axle_aux4_x_x*work.N_rear_axle_tx_y - 1174.0*work.s1_59;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  const double F_rear_axle_ry_y = R_rear_axle_aux4_y_x*work.N_rear_axle_tx_y - 1174.0*work.s1_60;
  const double s8_876 = R_rear_axle_aux4_x_x*work.N_rear_axle_ty_z;
  const double s8_877 = R_rear_axle_aux4_y_x*work.N_rear_axle_tz_x;
  const double F_rear_axle_ry_z = 1174.0*work.b_rear_axle_ry_z - s8_876 - s8_877;
  const double s8_878 = R_rear_axle_aux4_x_x*work.s1_767 - R_rear_axle_aux4_y_x*work.s1_762;
  const double s8_879 = work.b_rear_axle_ry_z*work.N_rear_axle_tz_x;
  const double N_rear_axle_ry_x = s8_878 + work.s1_60*work.N_rear_axle_tx_y + s8_879;
  const double s8_880 = R_rear_axle_aux4_x_x*work.s1_764 - R_rear_axle_aux4_y_x*work.s1_767;
  const double s8_881 = s8_880 - work.b_rear_axle_ry_z*work.N_rear_axle_ty_z;
  const double N_rear_axle_ry_y = s8_881 - work.s1_59*work.N_rear_axle_tx_y;
  const double s8_882 = R_rear_axle_aux4_x_x*work.s1_769 - R_rear_axle_aux4_y_x*work.s1_768;
  const double s8_883 = s8_882 + work.s1_59*work.N_rear_axle_tz_x;
  const double N_rear_axle_ry_z = s8_883 - work.s1_60*work.N_rear_axle_ty_z;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_58 = work.sines[18];
  const double s8_884 = work.R_rear_axle_aux5_y_x*work.N_rear_axle_tx_y;
  const double F_rear_axle_rx_x = s1_58*work.N_rear_axle_tz_x + s8_884 - 1174.0*work.s1_64;
  const double s8_885 = work.R_rear_axle_aux5_x_x*work.N_rear_axle_tx_y;
  const double F_rear_axle_rx_y = 1174.0*work.b_rear_axle_rx_y - s8_885 -
      s1_58*work.N_rear_axle_ty_z;
  const double s8_886 = work.R_rear_axle_aux5_x_x*work.N_rear_axle_tz_x;
  const double s8_887 = s8_886 - work.R_rear_axle_aux5_y_x*work.N_rear_axle_ty_z;
  const double F_rear_axle_rx_z = s8_887 + 1174.0*work.b_rear_axle_rx_z;
  const double s8_888 = work.R_rear_axle_aux5_y_x*work.s1_767;
  const double s8_889 = s8_888 + work.R_rear_axle_aux5_x_x*work.s1_762 - s1_58*work.s1_768;
  const double s8_890 = s8_889 + work.b_rear_axle_rx_z*work.N_rear_axle_tz_x;
  const double N_rear_axle_rx_x = s8_890 - work.b_rear_axle_rx_y*work.N_rear_axle_tx_y;
  const double s8_891 = work.R_rear_axle_aux5_y_x*work.s1_764;
  const double s8_892 = s8_891 + work.R_rear_axle_aux5_x_x*work.s1_767 - s1_58*work.s1_769;
  const double s8_893 = s8_892 - work.b_rear_axle_rx_z*work.N_rear_axle_ty_z;
  const double N_rear_axle_rx_y = s8_893 - work.s1_64*work.N_rear_axle_tx_y;
  const double s8_894 = work.R_rear_axle_aux5_y_x*work.s1_769;
  const double s8_895 = s8_894 + work.R_rear_axle_aux5_x_x*work.s1_768 - s1_58*work.s1_766;
  const double s8_896 = work.b_rear_axle_rx_y*work.N_rear_axle_ty_z;
  const double N_rear_axle_rx_z = s8_895 + work.s1_64*work.N_rear_axle_tz_x + s8_896;
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double F_arb_rear_left_x = 3.8999999999999995 - work.s1_460;
  const double s8_897 = 28.6 + work.s1_459;
  const double s8_898 = work.s1_463 + 3.3000000000000003*work.s1_459;
  const double N_arb_rear_left_y = s8_898 - 0.44999999999999996*work.s1_460;
  const double N_arb_rear_left_z = work.s1_465 - 1.9799999999999995;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double F_arb_rear_right_x = 3.8999999999999995 - work.s1_489;
  const double s8_899 = 28.6 + work.s1_488;
  const double N_arb_rear_right_x = 14.52 + work.s1_493;
  const double s8_900 = work.s1_492 + 3.3000000000000003*work.s1_488;
  const double N_arb_rear_right_y = s8_900 - 0.44999999999999996*work.s1_489;
  const double N_arb_rear_right_z = 1.9799999999999995 - work.s1_494;
  const double s8_901 = N_rear_axle_rz_z + z_rear_axle_ty*F_rear_axle_rz_x;
  const double s8_902 = s8_901 - work.r_rear_axle_aux1_x*F_rear_axle_rz_y;
  const double s8_903 = N_rear_axle_ry_z + z_rear_axle_ty*F_rear_axle_ry_x;
  const double s8_904 = s8_903 - work.r_rear_axle_aux1_x*F_rear_axle_ry_y;
  const double s8_905 = R_rear_axle_aux4_x_x*N_rear_axle_ry_y;
  const double s8_906 = s8_905 - R_rear_axle_aux4_y_x*N_rear_axle_ry_x;
  const double s8_907 = s8_906 + work.b_rear_axle_ry_z*F_rear_axle_ry_z;
  const double s8_908 = s8_907 - work.s1_59*F_rear_axle_ry_x - work.s1_60*F_rear_axle_ry_y;
  const double s8_909 = N_rear_axle_rx_z + z_rear_axle_ty*F_rear_axle_rx_x;
  const double s8_910 = s8_909 - work.r_rear_axle_aux1_x*F_rear_axle_rx_y;
  const double s8_911 = R_rear_axle_aux4_x_x*N_rear_axle_rx_y;
  const double s8_912 = s8_911 - R_rear_axle_aux4_y_x*N_rear_axle_rx_x;
  const double s8_913 = s8_912 + work.b_rear_axle_ry_z*F_rear_axle_rx_z;
  const double s8_914 = s8_913 - work.s1_59*F_rear_axle_rx_x - work.s1_60*F_rear_axle_rx_y;
  const double s8_915 = work.R_rear_axle_aux5_y_x*N_rear_axle_rx_y;
  const double s8_916 = s8_915 + work.R_rear_axle_aux5_x_x*N_rear_axle_rx_x;
  const double s8_917 = s8_916 - s1_58*N_rear_axle_rx_z + work.b_rear_axle_rx_y*F_rear_axle_rx_y;
  const double s8_918 = s8_917 + work.b_rear_axle_rx_z*F_rear_axle_rx_z;
  const double s8_919 = s8_918 - work.s1_64*F_rear_axle_rx_x;
  const double s8_920 = N_arb_rear_left_y + 3.3000000000000003*s8_897;
  const double s8_921 = s8_920 + 0.44999999999999996*F_arb_rear_left_x;
  const double s8_922 = N_arb_rear_right_y + 3.3000000000000003*s8_899;
  work.s8_923 = s8_922 + 0.44999999999999996*F_arb_rear_right_x;
  // long_rod_left
  const double s8_924 = work.b_rear_axle_ry_z - R_rear_axle_aux4_x_x*work.s1_637;
  const double s8_925 = work.b_rear_axle_rx_y - work.R_rear_axle_aux5_x_x*work.s1_640;
  const double s8_926 = work.b_rear_axle_rx_z + work.R_rear_axle_aux5_x_x*work.s1_639;
  const double s8_927 = 3.0*(z_rear_axle_ty - work.s1_639);
  const double s8_928 = 3.0*(work.s1_637 - work.r_rear_axle_aux1_x);
  const double s8_929 = 0.55*s8_927;
  const double s8_930 = 3.0*(R_rear_axle_aux4_x_x*work.s1_640 - work.s1_59);
  const double s8_931 = 3.0*(R_rear_axle_aux4_y_x*work.s1_640 - work.s1_60);
  const double s8_932 = 3.0*(s8_924 - R_rear_axle_aux4_y_x*work.s1_639);
  const double s8_933 = 0.55*s8_930;
  const double s8_934 = s1_58*work.s1_639 - work.s1_64 + work.R_rear_axle_aux5_y_x*work.s1_640;
  const double s8_935 = 3.0*s8_934;
  const double s8_936 = 3.0*(s8_925 - s1_58*work.s1_637);
  const double s8_937 = 3.0*(s8_926 - work.R_rear_axle_aux5_y_x*work.s1_637);
  const double s8_938 = 0.55*s8_935;
  // diag_rod_left
  const double s8_939 = work.b_rear_axle_ry_z - R_rear_axle_aux4_x_x*work.s1_658;
  const double s8_940 = work.b_rear_axle_rx_y - work.R_rear_axle_aux5_x_x*work.s1_662;
  const double s8_941 = work.b_rear_axle_rx_z + work.R_rear_axle_aux5_x_x*work.s1_660;
  const double s8_942 = 2.6666666666666665*(z_rear_axle_ty - work.s1_660);
  const double s8_943 = 2.6666666666666665*(work.s1_658 - work.r_rear_axle_aux1_x);
  const double s8_944 = 2.6666666666666665*(R_rear_axle_aux4_x_x*work.s1_662 - work.s1_59);
  const double s8_945 = 2.6666666666666665*(R_rear_axle_aux4_y_x*work.s1_662 - work.s1_60);
  const double s8_946 = 2.6666666666666665*(s8_939 - R_rear_axle_aux4_y_x*work.s1_660);
  const double s8_947 = s1_58*work.s1_660 - work.s1_64 + work.R_rear_axle_aux5_y_x*work.s1_662;
  const double s8_948 = 2.6666666666666665*s8_947;
  const double s8_949 = 2.6666666666666665*(s8_940 - s1_58*work.s1_658);
  const double s8_950 = 2.6666666666666665*(s8_941 - work.R_rear_axle_aux5_y_x*work.s1_658);
  // arb_link_rear_left
  const double s8_951 = z_rear_axle_ty - work.s1_684;
  const double s8_952 = R_rear_axle_aux4_x_x*work.s1_687 - work.s1_59;
  const double s8_953 = work.b_rear_axle_ry_z - R_rear_axle_aux4_x_x*work.s1_683;
  const double s8_954 = s8_953 - R_rear_axle_aux4_y_x*work.s1_684;
  const double s8_955 = s1_58*work.s1_684 - work.s1_64 + work.R_rear_axle_aux5_y_x*work.s1_687;
  const double s8_956 = work.b_rear_axle_rx_y - work.R_rear_axle_aux5_x_x*work.s1_687;
  const double s8_957 = work.b_rear_axle_rx_z + work.R_rear_axle_aux5_x_x*work.s1_684;
  const double s8_958 = s8_957 - work.R_rear_axle_aux5_y_x*work.s1_683;
  const double s8_959 = 0.3333333333333333*(0.44999999999999996 - work.s1_689);
  const double s8_960 = 0.3333333333333333*(3.3000000000000003 + work.s1_688);
  const double s8_961 = 2.916666666666667 + work.N_rear_axle_tz_x;
  const double s8_962 = 0.3333333333333333*s8_951;
  const double s8_963 = 0.3333333333333333*(work.s1_683 - work.r_rear_axle_aux1_x);
  const double s8_964 = s8_951*s8_959;
  const double s8_965 = 0.3333333333333333*s8_952;
  const double s8_966 = 0.3333333333333333*(R_rear_axle_aux4_y_x*work.s1_687 - work.s1_60);
  const double s8_967 = 0.3333333333333333*s8_954;
  const double s8_968 = s8_952*s8_959 - s8_954*s8_960;
  const double s8_969 = 0.3333333333333333*s8_955;
  const double s8_970 = 0.3333333333333333*(s8_956 - s1_58*work.s1_683);
  const double s8_971 = 0.3333333333333333*s8_958;
  const double s8_972 = s8_955*s8_959 - s8_958*s8_960;
  const double s8_973 = F_arb_rear_left_x + s8_959;
  const double s8_974 = s8_897 + s8_960;
  const double s8_975 = 14.52 + work.s1_464 + work.s1_684*s8_960;
  work.s8_976 = N_arb_rear_left_y + work.s1_683*s8_960 + work.s1_687*s8_959;
  work.s8_977 = N_arb_rear_left_z - work.s1_684*s8_959;
  // long_rod_right
  const double s8_978 = work.b_rear_axle_ry_z - R_rear_axle_aux4_x_x*work.s1_707;
  const double s8_979 = work.b_rear_axle_rx_y - work.R_rear_axle_aux5_x_x*work.s1_709;
  const double s8_980 = work.b_rear_axle_rx_z + work.R_rear_axle_aux5_x_x*work.s1_708;
  const double s8_981 = 3.0*(z_rear_axle_ty - work.s1_708);
  const double s8_982 = 3.0*(work.s1_707 - work.r_rear_axle_aux1_x);
  const double s8_983 = 0.55*s8_981;
  const double s8_984 = 3.0*(R_rear_axle_aux4_x_x*work.s1_709 - work.s1_59);
  const double s8_985 = 3.0*(R_rear_axle_aux4_y_x*work.s1_709 - work.s1_60);
  const double s8_986 = 3.0*(s8_978 - R_rear_axle_aux4_y_x*work.s1_708);
  const double s8_987 = 0.55*s8_984;
  const double s8_988 = s1_58*work.s1_708 - work.s1_64 + work.R_rear_axle_aux5_y_x*work.s1_709;
  const double s8_989 = 3.0*s8_988;
  const double s8_990 = 3.0*(s8_979 - s1_58*work.s1_707);
  const double s8_991 = 3.0*(s8_980 - work.R_rear_axle_aux5_y_x*work.s1_707);
  const double s8_992 = 0.55*s8_989;
  // diag_rod_right
  const double s8_993 = work.b_rear_axle_ry_z - R_rear_axle_aux4_x_x*work.s1_723;
  const double s8_994 = work.b_rear_axle_rx_y - work.R_rear_axle_aux5_x_x*work.s1_725;
  const double s8_995 = work.b_rear_axle_rx_z + work.R_rear_axle_aux5_x_x*work.s1_724;
  const double s8_996 = 2.6666666666666665*(z_rear_axle_ty - work.s1_724);
  const double s8_997 = 2.6666666666666665*(work.s1_723 - work.r_rear_axle_aux1_x);
  const double s8_998 = 2.6666666666666665*(R_rear_axle_aux4_x_x*work.s1_725 - work.s1_59);
  const double s8_999 = 2.6666666666666665*(R_rear_axle_aux4_y_x*work.s1_725 - work.s1_60);
  const double s8_1000 = 2.6666666666666665*(s8_993 - R_rear_axle_aux4_y_x*work.s1_724);
  const double s8_1001 = s1_58*work.s1_724 - work.s1_64 + work.R_rear_axle_aux5_y_x*work.s1_725;
  const double s8_1002 = 2.6666666666666665*s8_1001;
  const double s8_1003 = 2.6666666666666665*(s8_994 - s1_58*work.s1_723);
  const double s8_1004 = 2.6666666666666665*(s8_995 - work.R_rear_axle_aux5_y_x*work.s1_723);
  // arb_link_rear_right
  const double s8_1005 = z_rear_axle_ty - work.s1_740;
  const double s8_1006 = R_rear_axle_aux4_x_x*work.s1_741 - work.s1_59;
  const double s8_1007 = work.b_rear_axle_ry_z - R_rear_axle_aux4_x_x*work.s1_739;
  const double s8_1008 = s8_1007 - R_rear_axle_aux4_y_x*work.s1_740;
  const double s8_1009 = s1_58*work.s1_740 - work.s1_64 + work.R_rear_axle_aux5_y_x*work.s1_741;
  const double s8_1010 = work.b_rear_axle_rx_y - work.R_rear_axle_aux5_x_x*work.s1_741;
  const double s8_1011 = work.b_rear_axle_rx_z + work.R_rear_axle_aux5_x_x*work.s1_740;
  const double s8_1012 = s8_1011 - work.R_rear_axle_aux5_y_x*work.s1_739;
  work.s8_1013 = 0.3333333333333333*(0.44999999999999996 - work.s1_743);
  work.s8_1014 = 0.3333333333333333*(3.3000000000000003 + work.s1_742);
  work.s8_1015 = work.N_rear_axle_tx_y - work.s1_701 - work.s1_755 - 4.1000000000000005;
  work.s8_1016 = 2.916666666666667 - s8_961;
  const double s8_1017 = 4.1000000000000005 + (work.s1_701 + work.s1_755 - work.N_rear_axle_tx_y);
  work.s8_1018 = work.s1_754 + (work.s1_700 + work.N_rear_axle_ty_z) - 18.666666666666664;
  const double s8_1019 = s8_961 - 2.916666666666667;
  work.s8_1020 = 18.666666666666664 - work.N_rear_axle_ty_z - work.s1_700 - work.s1_754;
  const double s8_1021 = 0.3333333333333333*s8_1005;
  const double s8_1022 = 0.3333333333333333*(work.s1_739 - work.r_rear_axle_aux1_x);
  const double s8_1023 = F_rear_axle_rz_x + (s8_942 + (s8_962 + (s8_981 + (s8_996 + s8_1021))));
  const double s8_1024 = s8_927 + s8_1023;
  const double s8_1025 = F_rear_axle_rz_y + (s8_943 + (s8_963 + (s8_982 + (s8_997 + s8_1022))));
  const double s8_1026 = s8_928 + s8_1025;
  const double s8_1027 = s8_943 + s8_997;
  const double s8_1028 = s8_928 + s8_982;
  const double s8_1029 = N_rear_axle_rz_x + work.s1_689*s8_963 + work.s1_743*s8_1022;
  const double s8_1030 = s8_1029 + 0.15000000000000002*s8_1027 + 0.55*s8_1028;
  const double s8_1031 = N_rear_axle_rz_y - s8_929 - s8_983 - work.s1_689*s8_962;
  work.s8_1032 = s8_1031 - work.s1_743*s8_1021 - 0.15000000000000002*(s8_942 + s8_996);
  const double s8_1033 = N_rear_axle_rz_z + s8_983 - s8_929 + work.s1_688*s8_963;
  const double s8_1034 = s8_1033 + work.s1_742*s8_1022 + 0.4*(s8_996 - s8_942);
  const double s8_1035 = s8_1034 + 0.6*(s8_1021 - s8_962) - 1.6*s8_1028;
  work.s8_1036 = s8_1035 - 1.6999999999999997*s8_1027;
  work.s8_1037 = s8_1005*work.s8_1013;
  const double s8_1038 = 0.3333333333333333*s8_1006;
  const double s8_1039 = 0.3333333333333333*(R_rear_axle_aux4_y_x*work.s1_741 - work.s1_60);
  const double s8_1040 = 0.3333333333333333*s8_1008;
  const double s8_1041 = F_rear_axle_ry_x + (s8_944 + (s8_965 + (s8_984 + (s8_998 + s8_1038))));
  const double s8_1042 = s8_930 + s8_1041;
  const double s8_1043 = F_rear_axle_ry_y + (s8_945 + (s8_966 + (s8_985 + (s8_999 + s8_1039))));
  const double s8_1044 = s8_931 + s8_1043;
  const double s8_1045 = F_rear_axle_ry_z + (s8_946 + (s8_967 + (s8_986 + (s8_1000 + s8_1040))));
  const double s8_1046 = s8_932 + s8_1045;
  const double s8_1047 = s8_931 + s8_985;
  const double s8_1048 = s8_945 + s8_999;
  const double s8_1049 = N_rear_axle_ry_x + work.s1_689*s8_966 + work.s1_743*s8_1039;
  const double s8_1050 = s8_1049 + 0.55*(s8_932 + s8_1047 - s8_986) + 0.4*(s8_946 - s8_1000);
  const double s8_1051 = s8_1050 + 0.6*(s8_967 - s8_1040) + 0.15000000000000002*s8_1048;
  const double s8_1052 = N_rear_axle_ry_y - s8_933 - s8_987 - work.s1_688*s8_967;
  const double s8_1053 = s8_1052 - work.s1_689*s8_965 - work.s1_742*s8_1040 - work.s1_743*s8_1038;
  const double s8_1054 = s8_1053 - 0.15000000000000002*(s8_944 + s8_998) + 1.6*(s8_932 + s8_986);
  work.s8_1055 = s8_1054 + 1.6999999999999997*(s8_946 + s8_1000);
  const double s8_1056 = N_rear_axle_ry_z + s8_987 - s8_933 + work.s1_688*s8_966;
  const double s8_1057 = s8_1056 + work.s1_742*s8_1039 + 0.4*(s8_998 - s8_944);
  const double s8_1058 = s8_1057 + 0.6*(s8_1038 - s8_965) - 1.6*s8_1047;
  work.s8_1059 = s8_1058 - 1.6999999999999997*s8_1048;
  work.s8_1060 = s8_1006*work.s8_1013 - s8_1008*work.s8_1014;
  const double s8_1061 = 0.3333333333333333*s8_1009;
  const double s8_1062 = 0.3333333333333333*(s8_1010 - s1_58*work.s1_739);
  const double s8_1063 = 0.3333333333333333*s8_1012;
  const double s8_1064 = F_rear_axle_rx_x + (s8_948 + (s8_969 + (s8_989 + (s8_1002 + s8_1061))));
  const double s8_1065 = s8_935 + s8_1064;
  const double s8_1066 = F_rear_axle_rx_y + (s8_949 + (s8_970 + (s8_990 + (s8_1003 + s8_1062))));
  const double s8_1067 = s8_936 + s8_1066;
  const double s8_1068 = F_rear_axle_rx_z + (s8_950 + (s8_971 + (s8_991 + (s8_1004 + s8_1063))));
  const double s8_1069 = s8_937 + s8_1068;
  const double s8_1070 = s8_936 + s8_990;
  const double s8_1071 = s8_949 + s8_1003;
  const double s8_1072 = N_rear_axle_rx_x + work.s1_689*s8_970 + work.s1_743*s8_1062;
  const double s8_1073 = s8_1072 + 0.55*(s8_937 + s8_1070 - s8_991) + 0.4*(s8_950 - s8_1004);
  const double s8_1074 = s8_1073 + 0.6*(s8_971 - s8_1063) + 0.15000000000000002*s8_1071;
  const double s8_1075 = N_rear_axle_rx_y - s8_938 - s8_992 - work.s1_688*s8_971;
  const double s8_1076 = s8_1075 - work.s1_689*s8_969 - work.s1_742*s8_1063 - work.s1_743*s8_1061;
  const double s8_1077 = s8_1076 - 0.15000000000000002*(s8_948 + s8_1002) + 1.6*(s8_937 + s8_991);
  work.s8_1078 = s8_1077 + 1.6999999999999997*(s8_950 + s8_1004);
  const double s8_1079 = N_rear_axle_rx_z + s8_992 - s8_938 + work.s1_688*s8_970;
  const double s8_1080 = s8_1079 + work.s1_742*s8_1062 + 0.4*(s8_1002 - s8_948);
  const double s8_1081 = s8_1080 + 0.6*(s8_1061 - s8_969) - 1.6*s8_1070;
  work.s8_1082 = s8_1081 - 1.6999999999999997*s8_1071;
  work.s8_1083 = s8_1009*work.s8_1013 - s8_1012*work.s8_1014;
  const double s8_1084 = F_arb_rear_right_x + work.s8_1013;
  const double s8_1085 = s8_899 + work.s8_1014;
  work.s8_1086 = N_arb_rear_right_x - work.s1_740*work.s8_1014;
  work.s8_1087 = N_arb_rear_right_y + work.s1_739*work.s8_1014 + work.s1_741*work.s8_1013;
  work.s8_1088 = N_arb_rear_right_z - work.s1_740*work.s8_1013;
  const double s8_1089 = 1174.0*projection.Rz[42] + projection.Rz[48]*F_rear_axle_rz_x;
  const double s8_1090 = s8_1089 + projection.Rz[50]*F_rear_axle_ry_x;
  const double s8_1091 = s8_1090 + projection.Rz[52]*F_rear_axle_rx_x + projection.Rz[54]*s8_959;
  const double s8_1092 = 1174.0*projection.Rz[44] + projection.Rz[48]*F_rear_axle_rz_y;
  const double s8_1093 = s8_1092 + projection.Rz[50]*F_rear_axle_ry_y;
  const double s8_1094 = 1174.0*projection.Rz[46] + projection.Rz[50]*F_rear_axle_ry_z;
  const double s8_1095 = s8_1094 + projection.Rz[52]*F_rear_axle_rx_z - projection.Rz[54]*s8_960;
  const double s8_1096 = projection.Rz[42]*F_rear_axle_rz_x + projection.Rz[44]*F_rear_axle_rz_y;
  const double s8_1097 = s8_1096 + projection.Rz[48]*s8_902 + projection.Rz[50]*s8_904;
  const double s8_1098 = s8_1097 + projection.Rz[52]*s8_910 + projection.Rz[54]*s8_964;
  const double s8_1099 = projection.Rz[42]*F_rear_axle_ry_x + projection.Rz[44]*F_rear_axle_ry_y;
  const double s8_1100 = s8_1099 + projection.Rz[46]*F_rear_axle_ry_z + projection.Rz[48]*s8_904;
  const double s8_1101 = s8_1100 + projection.Rz[50]*s8_908 + projection.Rz[52]*s8_914;
  const double s8_1102 = 1186.0*projection.Rz[44] + projection.Rz[48]*s8_1026;
  const double s8_1103 = s8_1102 + projection.Rz[50]*s8_1044 + projection.Rz[52]*s8_1067;
  const double s8_1104 = projection.Rz[42]*F_rear_axle_rx_x + projection.Rz[44]*F_rear_axle_rx_y;
  const double s8_1105 = s8_1104 + projection.Rz[46]*F_rear_axle_rx_z + projection.Rz[48]*s8_910;
  const double s8_1106 = s8_1105 + projection.Rz[50]*s8_914 + projection.Rz[52]*s8_919;
  const double s8_1107 = projection.Rz[42]*s8_959 - projection.Rz[46]*s8_960;
  const double s8_1108 = s8_1107 + projection.Rz[48]*s8_964 + projection.Rz[50]*s8_968;
  const double s8_1109 = 1186.0*projection.Rz[42] + projection.Rz[48]*s8_1024;
  const double s8_1110 = s8_1109 + projection.Rz[50]*s8_1042 + projection.Rz[52]*s8_1065;
  const double s8_1111 = s8_1110 + projection.Rz[54]*s8_973 + projection.Rz[56]*s8_1084;
  const double s8_1112 = 1186.0*projection.Rz[46] + projection.Rz[50]*s8_1046;
  const double s8_1113 = s8_1112 + projection.Rz[52]*s8_1069 - projection.Rz[54]*s8_974;
  const double s8_1114 = s8_1113 - projection.Rz[56]*s8_1085;
  const double s8_1115 = projection.Rz[44]*s8_1017 + projection.Rz[46]*s8_1019;
  const double s8_1116 = s8_1115 + projection.Rz[48]*s8_1030 + projection.Rz[50]*s8_1051;
  const double s8_1117 = s8_1116 + projection.Rz[52]*s8_1074 - projection.Rz[54]*s8_975;
  work.s8_1118 = s8_1117 + projection.Rz[56]*work.s8_1086;
  const double s8_1119 = projection.Rz[42]*work.s8_1015 + projection.Rz[46]*work.s8_1020;
  const double s8_1120 = s8_1119 + projection.Rz[48]*work.s8_1032;
  const double s8_1121 = s8_1120 + projection.Rz[50]*work.s8_1055;
  const double s8_1122 = s8_1121 + projection.Rz[52]*work.s8_1078 + projection.Rz[54]*work.s8_976;
  const double s8_1123 = s8_1122 + projection.Rz[56]*work.s8_1087;
  const double s8_1124 = projection.Rz[42]*work.s8_1016 + projection.Rz[44]*work.s8_1018;
  const double s8_1125 = s8_1124 + projection.Rz[48]*work.s8_1036;
  const double s8_1126 = s8_1125 + projection.Rz[50]*work.s8_1059;
  const double s8_1127 = s8_1126 + projection.Rz[52]*work.s8_1082 + projection.Rz[54]*work.s8_977;
  const double s8_1128 = s8_1127 + projection.Rz[56]*work.s8_1088;
  const double s8_1129 = projection.Rz[42]*work.s8_1013 - projection.Rz[46]*work.s8_1014;
  const double s8_1130 = s8_1129 + projection.Rz[48]*work.s8_1037;
  const double s8_1131 = s8_1130 + projection.Rz[50]*work.s8_1060;
  work.s8_1132 = s1_2*s8_1123 - s1_1*s8_1128;
  const double s8_1133 = work.R_chassis_z_y*s8_1123 + work.R_chassis_z_z*s8_1128;
  work.s8_1134 = s8_1133 - s1_3*work.s8_1118;
  work.s8_1135 = work.R_chassis_z_y*s8_1103 + work.R_chassis_z_z*s8_1114 - s1_3*s8_1111;
  const double s8_1136 = work.R_chassis_y_y*s8_1103 + work.R_chassis_y_z*s8_1114;
  work.s8_1137 = s8_1136 + work.R_chassis_aux5_y_x*s8_1111;
  const double s8_1138 = work.R_chassis_x_y*s8_1103 + work.R_chassis_x_z*s8_1114;
  work.s8_1139 = s8_1138 + work.R_chassis_aux5_x_x*s8_1111;
  const double s8_1140 = projection.Rz[44]*(s8_1093 + projection.Rz[52]*F_rear_axle_rx_y);
  const double s8_1141 = projection.Rz[42]*(s8_1091 + projection.Rz[56]*work.s8_1013) + s8_1140;
  const double s8_1142 = s8_1141 + projection.Rz[46]*(s8_1095 - projection.Rz[56]*work.s8_1014);
  const double s8_1143 = s8_1101 + projection.Rz[54]*s8_968 + projection.Rz[56]*work.s8_1060;
  const double s8_1144 = s8_1142 + projection.Rz[48]*(s8_1098 + projection.Rz[56]*work.s8_1037);
  const double s8_1145 = s8_1106 + projection.Rz[54]*s8_972 + projection.Rz[56]*work.s8_1083;
  const double s8_1146 = s8_1108 + projection.Rz[52]*s8_972 + projection.Rz[54]*s8_921;
  const double s8_1147 = s8_1144 + projection.Rz[50]*s8_1143 + projection.Rz[52]*s8_1145;
  const double s8_1148 = s8_1131 + projection.Rz[52]*work.s8_1083 + projection.Rz[56]*work.s8_923;
  work.s8_1149 = s8_1147 + projection.Rz[54]*s8_1146 + projection.Rz[56]*s8_1148;
  const double s8_1150 = projection.Rz[42]*work.Q_rear_axle_tx;
  const double s8_1151 = s8_1150 + projection.Rz[44]*work.Q_rear_axle_ty;
  const double s8_1152 = s8_1151 + projection.Rz[46]*work.Q_rear_axle_tz;
  const double s8_1153 = s8_1152 + projection.Rz[48]*work.Q_rear_axle_rz;
  const double s8_1154 = s8_1153 + projection.Rz[50]*work.Q_rear_axle_ry;
  const double s8_1155 = s8_1154 + projection.Rz[52]*work.Q_rear_axle_rx;
  const double s8_1156 = s8_1155 + projection.Rz[54]*work.Q_arb_rear_left;
  work.s8_1157 = s8_1156 + projection.Rz[56]*work.Q_arb_rear_right;
  const double s8_1158 = 1174.0*projection.Rz[43] + projection.Rz[49]*F_rear_axle_rz_x;
  const double s8_1159 = s8_1158 + projection.Rz[51]*F_rear_axle_ry_x;
  const double s8_1160 = s8_1159 + projection.Rz[53]*F_rear_axle_rx_x + projection.Rz[55]*s8_959;
  work.s8_1161 = s8_1160 + projection.Rz[57]*work.s8_1013;
  const double s8_1162 = 1174.0*projection.Rz[45] + projection.Rz[49]*F_rear_axle_rz_y;
  const double s8_1163 = s8_1162 + projection.Rz[51]*F_rear_axle_ry_y;
  work.s8_1164 = s8_1163 + projection.Rz[53]*F_rear_axle_rx_y;
  const double s8_1165 = 1174.0*projection.Rz[47] + projection.Rz[51]*F_rear_axle_ry_z;
  const double s8_1166 = s8_1165 + projection.Rz[53]*F_rear_axle_rx_z - projection.Rz[55]*s8_960;
  work.s8_1167 = s8_1166 - projection.Rz[57]*work.s8_1014;
  const double s8_1168 = projection.Rz[43]*F_rear_axle_rz_x + projection.Rz[45]*F_rear_axle_rz_y;
  const double s8_1169 = s8_1168 + projection.Rz[49]*s8_902 + projection.Rz[51]*s8_904;
  const double s8_1170 = s8_1169 + projection.Rz[53]*s8_910 + projection.Rz[55]*s8_964;
  work.s8_1171 = s8_1170 + projection.Rz[57]*work.s8_1037;
  const double s8_1172 = projection.Rz[43]*F_rear_axle_ry_x + projection.Rz[45]*F_rear_axle_ry_y;
  const double s8_1173 = s8_1172 + projection.Rz[47]*F_rear_axle_ry_z + projection.Rz[49]*s8_904;
  const double s8_1174 = s8_1173 + projection.Rz[51]*s8_908 + projection.Rz[53]*s8_914;
  work.s8_1175 = s8_1174 + projection.Rz[55]*s8_968 + projection.Rz[57]*work.s8_1060;
  const double s8_1176 = 1186.0*projection.Rz[45] + projection.Rz[49]*s8_1026;
  work.s8_1177 = s8_1176 + projection.Rz[51]*s8_1044 + projection.Rz[53]*s8_1067;
  const double s8_1178 = projection.Rz[43]*F_rear_axle_rx_x + projection.Rz[45]*F_rear_axle_rx_y;
  const double s8_1179 = s8_1178 + projection.Rz[47]*F_rear_axle_rx_z + projection.Rz[49]*s8_910;
  const double s8_1180 = s8_1179 + projection.Rz[51]*s8_914 + projection.Rz[53]*s8_919;
  work.s8_1181 = s8_1180 + projection.Rz[55]*s8_972 + projection.Rz[57]*work.s8_1083;
  const double s8_1182 = projection.Rz[43]*s8_959 - projection.Rz[47]*s8_960;
  const double s8_1183 = s8_1182 + projection.Rz[49]*s8_964 + projection.Rz[51]*s8_968;
  work.s8_1184 = s8_1183 + projection.Rz[53]*s8_972 + projection.Rz[55]*s8_921;
  const double s8_1185 = 1186.0*projection.Rz[43] + projection.Rz[49]*s8_1024;
  const double s8_1186 = s8_1185 + projection.Rz[51]*s8_1042 + projection.Rz[53]*s8_1065;
  work.s8_1187 = s8_1186 + projection.Rz[55]*s8_973 + projection.Rz[57]*s8_1084;
  const double s8_1188 = 1186.0*projection.Rz[47] + projection.Rz[51]*s8_1046;
  const double s8_1189 = s8_1188 + projection.Rz[53]*s8_1069 - projection.Rz[55]*s8_974;
  work.s8_1190 = s8_1189 - projection.Rz[57]*s8_1085;
  const double s8_1191 = projection.Rz[45]*s8_1017 + projection.Rz[47]*s8_1019;
  const double s8_1192 = s8_1191 + projection.Rz[49]*s8_1030 + projection.Rz[51]*s8_1051;
  work.s8_1193 = s8_1192 + projection.Rz[53]*s8_1074 - projection.Rz[55]*s8_975;
}

/// Part 10 of compute_chosen_accelerations: step 8: Rz' M Rz and right-hand side (63); step 9:
/// independent and all accelerations (63), (62).
[[gnu::noinline]] void compute_chosen_accelerations_10(const State& state,
    const Projection& projection, ChosenAccelerationsWork& __restrict work,
    ChosenAccelerations& __restrict result) noexcept {
  // --- step 8: Rz' M Rz and right-hand side (63), continued ---
  // arb_link_rear_right
  const double s8_1194 = work.s8_1193 + projection.Rz[57]*work.s8_1086;
  const double s8_1195 = projection.Rz[43]*work.s8_1015 + projection.Rz[47]*work.s8_1020;
  const double s8_1196 = s8_1195 + projection.Rz[49]*work.s8_1032;
  const double s8_1197 = s8_1196 + projection.Rz[51]*work.s8_1055;
  const double s8_1198 = s8_1197 + projection.Rz[53]*work.s8_1078 + projection.Rz[55]*work.s8_976;
  const double s8_1199 = s8_1198 + projection.Rz[57]*work.s8_1087;
  const double s8_1200 = projection.Rz[43]*work.s8_1016 + projection.Rz[45]*work.s8_1018;
  const double s8_1201 = s8_1200 + projection.Rz[49]*work.s8_1036;
  const double s8_1202 = s8_1201 + projection.Rz[51]*work.s8_1059;
  const double s8_1203 = s8_1202 + projection.Rz[53]*work.s8_1082 + projection.Rz[55]*work.s8_977;
  const double s8_1204 = s8_1203 + projection.Rz[57]*work.s8_1088;
  const double s8_1205 = projection.Rz[43]*work.s8_1013 - projection.Rz[47]*work.s8_1014;
  const double s8_1206 = s8_1205 + projection.Rz[49]*work.s8_1037;
  const double s8_1207 = s8_1206 + projection.Rz[51]*work.s8_1060;
  const double s8_1208 = s8_1207 + projection.Rz[53]*work.s8_1083 + projection.Rz[57]*work.s8_923;
  const double s1_2 = work.cosines[2];
  const double s1_1 = work.sines[2];
  const double s8_1209 = s1_2*s8_1199 - s1_1*s8_1204;
  const double s1_3 = work.sines[1];
  const double s8_1210 = work.R_chassis_z_y*s8_1199 + work.R_chassis_z_z*s8_1204 - s1_3*s8_1194;
  const double s8_1211 = work.R_chassis_z_y*work.s8_1177 + work.R_chassis_z_z*work.s8_1190;
  const double s8_1212 = s8_1211 - s1_3*work.s8_1187;
  const double s8_1213 = work.R_chassis_y_y*work.s8_1177 + work.R_chassis_y_z*work.s8_1190;
  const double s8_1214 = s8_1213 + work.R_chassis_aux5_y_x*work.s8_1187;
  const double s8_1215 = work.R_chassis_x_y*work.s8_1177 + work.R_chassis_x_z*work.s8_1190;
  const double s8_1216 = s8_1215 + work.R_chassis_aux5_x_x*work.s8_1187;
  const double s8_1217 = projection.Rz[42]*work.s8_1161 + projection.Rz[44]*work.s8_1164;
  const double s8_1218 = s8_1217 + projection.Rz[46]*work.s8_1167;
  const double s8_1219 = s8_1218 + projection.Rz[48]*work.s8_1171;
  const double s8_1220 = s8_1219 + projection.Rz[50]*work.s8_1175;
  const double s8_1221 = s8_1220 + projection.Rz[52]*work.s8_1181;
  const double s8_1222 = s8_1221 + projection.Rz[54]*work.s8_1184 + projection.Rz[56]*s8_1208;
  const double s8_1223 = projection.Rz[43]*work.s8_1161 + projection.Rz[45]*work.s8_1164;
  const double s8_1224 = s8_1223 + projection.Rz[47]*work.s8_1167;
  const double s8_1225 = s8_1224 + projection.Rz[49]*work.s8_1171;
  const double s8_1226 = s8_1225 + projection.Rz[51]*work.s8_1175;
  const double s8_1227 = s8_1226 + projection.Rz[53]*work.s8_1181;
  const double s8_1228 = s8_1227 + projection.Rz[55]*work.s8_1184 + projection.Rz[57]*s8_1208;
  const double s8_1229 = projection.Rz[43]*work.Q_rear_axle_tx;
  const double s8_1230 = s8_1229 + projection.Rz[45]*work.Q_rear_axle_ty;
  const double s8_1231 = s8_1230 + projection.Rz[47]*work.Q_rear_axle_tz;
  const double s8_1232 = s8_1231 + projection.Rz[49]*work.Q_rear_axle_rz;
  const double s8_1233 = s8_1232 + projection.Rz[51]*work.Q_rear_axle_ry;
  const double s8_1234 = s8_1233 + projection.Rz[53]*work.Q_rear_axle_rx;
  const double s8_1235 = s8_1234 + projection.Rz[55]*work.Q_arb_rear_left;
  const double s8_1236 = s8_1235 + projection.Rz[57]*work.Q_arb_rear_right;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s8_1237 = work.R_rear_axle_y_y*work.s1_439 - work.R_rear_axle_z_y*work.s1_438;
  const double F_wheel_rear_left_x = s8_1237 + 200.0*work.b_wheel_rear_left_x;
  const double s8_1238 = work.R_rear_axle_z_y*work.s1_437 - work.R_rear_axle_x_y*work.s1_439;
  const double F_wheel_rear_left_y = s8_1238 + 200.0*work.b_wheel_rear_left_y;
  const double s8_1239 = work.R_rear_axle_x_y*work.s1_438 - work.R_rear_axle_y_y*work.s1_437;
  const double F_wheel_rear_left_z = s8_1239 + 200.0*work.b_wheel_rear_left_z;
  const double s8_1240 = work.R_rear_axle_y_y*work.s1_446 + work.R_rear_axle_z_y*work.s1_447;
  const double s8_1241 = s8_1240 + work.R_rear_axle_x_y*work.s1_443;
  const double s8_1242 = s8_1241 + work.b_wheel_rear_left_z*work.s1_438;
  work.N_wheel_rear_left_x = s8_1242 - work.b_wheel_rear_left_y*work.s1_439;
  const double s8_1243 = work.R_rear_axle_y_y*work.s1_444 + work.R_rear_axle_z_y*work.s1_448;
  const double s8_1244 = s8_1243 + work.R_rear_axle_x_y*work.s1_446;
  const double s8_1245 = s8_1244 + work.b_wheel_rear_left_x*work.s1_439;
  const double N_wheel_rear_left_y = s8_1245 - work.b_wheel_rear_left_z*work.s1_437;
  const double s8_1246 = work.R_rear_axle_y_y*work.s1_448 + work.R_rear_axle_z_y*work.s1_445;
  const double s8_1247 = s8_1246 + work.R_rear_axle_x_y*work.s1_447;
  const double s8_1248 = s8_1247 + work.b_wheel_rear_left_y*work.s1_437;
  const double N_wheel_rear_left_z = s8_1248 - work.b_wheel_rear_left_x*work.s1_438;
  const double s8_1249 = work.R_rear_axle_y_y*N_wheel_rear_left_y;
  const double s8_1250 = s8_1249 + work.R_rear_axle_z_y*N_wheel_rear_left_z;
  const double s8_1251 = s8_1250 + work.R_rear_axle_x_y*work.N_wheel_rear_left_x;
  const double s8_1252 = s8_1251 + work.b_wheel_rear_left_y*F_wheel_rear_left_y;
  const double s8_1253 = s8_1252 + work.b_wheel_rear_left_z*F_wheel_rear_left_z;
  const double s8_1254 = s8_1253 + work.b_wheel_rear_left_x*F_wheel_rear_left_x;
  const double s8_1255 = work.R_rear_axle_aux5_x_x*work.N_wheel_rear_left_x;
  const double s1_58 = work.sines[18];
  const double s8_1256 = work.R_rear_axle_aux5_y_x*N_wheel_rear_left_y + s8_1255;
  const double s8_1257 = work.b_rear_axle_rx_y*F_wheel_rear_left_y;
  const double s8_1258 = s8_1256 - s1_58*N_wheel_rear_left_z + s8_1257;
  const double s8_1259 = s8_1258 + work.b_rear_axle_rx_z*F_wheel_rear_left_z;
  const double s8_1260 = s8_1259 - work.s1_64*F_wheel_rear_left_x;
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double R_rear_axle_aux4_y_x = work.sines[17];
  const double s8_1261 = R_rear_axle_aux4_y_x*work.N_wheel_rear_left_x;
  const double s8_1262 = R_rear_axle_aux4_x_x*N_wheel_rear_left_y - s8_1261;
  const double s8_1263 = s8_1262 + work.b_rear_axle_ry_z*F_wheel_rear_left_z;
  const double s8_1264 = s8_1263 - work.s1_59*F_wheel_rear_left_x;
  const double s8_1265 = s8_1264 - work.s1_60*F_wheel_rear_left_y;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s8_1266 = N_wheel_rear_left_z + z_rear_axle_ty*F_wheel_rear_left_x;
  const double s8_1267 = s8_1266 - work.r_rear_axle_aux1_x*F_wheel_rear_left_y;
  work.s8_1268 = s1_2*N_wheel_rear_left_y - s1_1*N_wheel_rear_left_z;
  const double s8_1269 = work.R_chassis_z_y*N_wheel_rear_left_y;
  const double s8_1270 = s8_1269 + work.R_chassis_z_z*N_wheel_rear_left_z;
  work.s8_1271 = s8_1270 - s1_3*work.N_wheel_rear_left_x;
  const double s8_1272 = work.R_chassis_z_y*F_wheel_rear_left_y;
  const double s8_1273 = s8_1272 + work.R_chassis_z_z*F_wheel_rear_left_z;
  work.s8_1274 = s8_1273 - s1_3*F_wheel_rear_left_x;
  const double s8_1275 = work.R_chassis_y_y*F_wheel_rear_left_y;
  const double s8_1276 = s8_1275 + work.R_chassis_y_z*F_wheel_rear_left_z;
  work.s8_1277 = s8_1276 + work.R_chassis_aux5_y_x*F_wheel_rear_left_x;
  const double s8_1278 = work.R_chassis_x_y*F_wheel_rear_left_y;
  const double s8_1279 = s8_1278 + work.R_chassis_x_z*F_wheel_rear_left_z;
  work.s8_1280 = s8_1279 + work.R_chassis_aux5_x_x*F_wheel_rear_left_x;
  const double s8_1281 = projection.Rz[42]*F_wheel_rear_left_x;
  const double s8_1282 = s8_1281 + projection.Rz[44]*F_wheel_rear_left_y;
  const double s8_1283 = s8_1282 + projection.Rz[46]*F_wheel_rear_left_z;
  const double s8_1284 = s8_1283 + projection.Rz[48]*s8_1267 + projection.Rz[50]*s8_1265;
  work.s8_1285 = s8_1284 + projection.Rz[52]*s8_1260;
  const double s8_1286 = projection.Rz[43]*F_wheel_rear_left_x;
  const double s8_1287 = s8_1286 + projection.Rz[45]*F_wheel_rear_left_y;
  const double s8_1288 = s8_1287 + projection.Rz[47]*F_wheel_rear_left_z;
  const double s8_1289 = s8_1288 + projection.Rz[49]*s8_1267 + projection.Rz[51]*s8_1265;
  work.s8_1290 = s8_1289 + projection.Rz[53]*s8_1260;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s8_1291 = work.R_rear_axle_y_y*work.s1_468 - work.R_rear_axle_z_y*work.s1_467;
  const double F_wheel_rear_right_x = s8_1291 + 200.0*work.b_wheel_rear_right_x;
  const double s8_1292 = work.R_rear_axle_z_y*work.s1_466 - work.R_rear_axle_x_y*work.s1_468;
  const double F_wheel_rear_right_y = s8_1292 + 200.0*work.b_wheel_rear_right_y;
  const double s8_1293 = work.R_rear_axle_x_y*work.s1_467 - work.R_rear_axle_y_y*work.s1_466;
  const double F_wheel_rear_right_z = s8_1293 + 200.0*work.b_wheel_rear_right_z;
  const double s8_1294 = work.R_rear_axle_y_y*work.s1_475 + work.R_rear_axle_z_y*work.s1_476;
  const double s8_1295 = s8_1294 + work.R_rear_axle_x_y*work.s1_472;
  const double s8_1296 = s8_1295 + work.b_wheel_rear_right_z*work.s1_467;
  work.N_wheel_rear_right_x = s8_1296 - work.b_wheel_rear_right_y*work.s1_468;
  const double s8_1297 = work.R_rear_axle_y_y*work.s1_473 + work.R_rear_axle_z_y*work.s1_477;
  const double s8_1298 = s8_1297 + work.R_rear_axle_x_y*work.s1_475;
  const double s8_1299 = s8_1298 + work.b_wheel_rear_right_x*work.s1_468;
  const double N_wheel_rear_right_y = s8_1299 - work.b_wheel_rear_right_z*work.s1_466;
  const double s8_1300 = work.R_rear_axle_y_y*work.s1_477 + work.R_rear_axle_z_y*work.s1_474;
  const double s8_1301 = s8_1300 + work.R_rear_axle_x_y*work.s1_476;
  const double s8_1302 = s8_1301 + work.b_wheel_rear_right_y*work.s1_466;
  const double N_wheel_rear_right_z = s8_1302 - work.b_wheel_rear_right_x*work.s1_467;
  const double s8_1303 = work.R_rear_axle_y_y*N_wheel_rear_right_y;
  const double s8_1304 = s8_1303 + work.R_rear_axle_z_y*N_wheel_rear_right_z;
  const double s8_1305 = s8_1304 + work.R_rear_axle_x_y*work.N_wheel_rear_right_x;
  const double s8_1306 = s8_1305 + work.b_wheel_rear_right_y*F_wheel_rear_right_y;
  const double s8_1307 = s8_1306 + work.b_wheel_rear_right_z*F_wheel_rear_right_z;
  const double s8_1308 = s8_1307 + work.b_wheel_rear_right_x*F_wheel_rear_right_x;
  const double s8_1309 = work.R_rear_axle_aux5_x_x*work.N_wheel_rear_right_x;
  const double s8_1310 = work.R_rear_axle_aux5_y_x*N_wheel_rear_right_y + s8_1309;
  const double s8_1311 = work.b_rear_axle_rx_y*F_wheel_rear_right_y;
  const double s8_1312 = s8_1310 - s1_58*N_wheel_rear_right_z + s8_1311;
  const double s8_1313 = s8_1312 + work.b_rear_axle_rx_z*F_wheel_rear_right_z;
  const double s8_1314 = s8_1313 - work.s1_64*F_wheel_rear_right_x;
  const double s8_1315 = R_rear_axle_aux4_y_x*work.N_wheel_rear_right_x;
  const double s8_1316 = R_rear_axle_aux4_x_x*N_wheel_rear_right_y - s8_1315;
  const double s8_1317 = s8_1316 + work.b_rear_axle_ry_z*F_wheel_rear_right_z;
  const double s8_1318 = s8_1317 - work.s1_59*F_wheel_rear_right_x;
  const double s8_1319 = s8_1318 - work.s1_60*F_wheel_rear_right_y;
  const double s8_1320 = N_wheel_rear_right_z + z_rear_axle_ty*F_wheel_rear_right_x;
  const double s8_1321 = s8_1320 - work.r_rear_axle_aux1_x*F_wheel_rear_right_y;
  work.s8_1322 = s1_2*N_wheel_rear_right_y - s1_1*N_wheel_rear_right_z;
  const double s8_1323 = work.R_chassis_z_y*N_wheel_rear_right_y;
  const double s8_1324 = s8_1323 + work.R_chassis_z_z*N_wheel_rear_right_z;
  work.s8_1325 = s8_1324 - s1_3*work.N_wheel_rear_right_x;
  const double s8_1326 = work.R_chassis_z_y*F_wheel_rear_right_y;
  const double s8_1327 = s8_1326 + work.R_chassis_z_z*F_wheel_rear_right_z;
  work.s8_1328 = s8_1327 - s1_3*F_wheel_rear_right_x;
  const double s8_1329 = work.R_chassis_y_y*F_wheel_rear_right_y;
  const double s8_1330 = s8_1329 + work.R_chassis_y_z*F_wheel_rear_right_z;
  work.s8_1331 = s8_1330 + work.R_chassis_aux5_y_x*F_wheel_rear_right_x;
  const double s8_1332 = work.R_chassis_x_y*F_wheel_rear_right_y;
  const double s8_1333 = s8_1332 + work.R_chassis_x_z*F_wheel_rear_right_z;
  work.s8_1334 = s8_1333 + work.R_chassis_aux5_x_x*F_wheel_rear_right_x;
  const double s8_1335 = projection.Rz[42]*F_wheel_rear_right_x;
  const double s8_1336 = s8_1335 + projection.Rz[44]*F_wheel_rear_right_y;
  const double s8_1337 = s8_1336 + projection.Rz[46]*F_wheel_rear_right_z;
  const double s8_1338 = s8_1337 + projection.Rz[48]*s8_1321 + projection.Rz[50]*s8_1319;
  work.s8_1339 = s8_1338 + projection.Rz[52]*s8_1314;
  const double s8_1340 = projection.Rz[43]*F_wheel_rear_right_x;
  const double s8_1341 = s8_1340 + projection.Rz[45]*F_wheel_rear_right_y;
  const double s8_1342 = s8_1341 + projection.Rz[47]*F_wheel_rear_right_z;
  const double s8_1343 = s8_1342 + projection.Rz[49]*s8_1321 + projection.Rz[51]*s8_1319;
  work.s8_1344 = s8_1343 + projection.Rz[53]*s8_1314;
  // operations: 1780 add, 1973 multiply

  // --- step 9: independent and all accelerations (63), (62) ---
  result.inertia[14] = s8_1308 - 1e-12*s8_1308;
  work.s9_1 = 1.0/s8_1308;
  work.s9_2 = work.s8_1334*work.s9_1;
  work.s9_3 = work.s8_1331*work.s9_1;
  work.s9_4 = work.s8_1328*work.s9_1;
  work.s9_5 = work.s8_1325*work.s9_1;
  const double s9_6 = work.s8_1322*work.s9_1;
  const double s9_7 = work.N_wheel_rear_right_x*work.s9_1;
  const double s9_8 = work.s8_1339*work.s9_1;
  const double s9_9 = work.s8_1344*work.s9_1;
  result.inertia[13] = s8_1254 - 1e-12*s8_1254;
  work.s9_10 = 1.0/s8_1254;
  work.s9_11 = work.s8_1280*work.s9_10;
  work.s9_12 = work.s8_1277*work.s9_10;
  work.s9_13 = work.s8_1274*work.s9_10;
  work.s9_14 = work.s8_1271*work.s9_10;
  const double s9_15 = work.s8_1268*work.s9_10;
  const double s9_16 = work.N_wheel_rear_left_x*work.s9_10;
  const double s9_17 = work.s8_1285*work.s9_10;
  const double s9_18 = work.s8_1290*work.s9_10;
  work.s9_19 = s8_1216 - work.s8_1334*s9_9 - work.s8_1280*s9_18;
  work.s9_20 = s8_1214 - work.s8_1331*s9_9 - work.s8_1277*s9_18;
  work.s9_21 = s8_1212 - work.s8_1328*s9_9 - work.s8_1274*s9_18;
  work.s9_22 = s8_1210 - work.s8_1325*s9_9 - work.s8_1271*s9_18;
  work.s9_23 = s8_1209 - work.s8_1322*s9_9 - work.s8_1268*s9_18;
  const double s9_24 = s8_1194 - work.N_wheel_rear_right_x*s9_9;
  work.s9_25 = s9_24 - work.N_wheel_rear_left_x*s9_18;
  work.s9_26 = s8_1222 - work.s8_1339*s9_9 - work.s8_1285*s9_18;
  const double s9_27 = s8_1228 - work.s8_1344*s9_9 - work.s8_1290*s9_18;
  work.s9_28 = s8_1236 - work.Q_wheel_rear_right*s9_9 - work.Q_wheel_rear_left*s9_18;
  result.inertia[12] = s9_27 - 1e-12*s8_1228;
  work.s9_29 = 1.0/s9_27;
  work.s9_30 = work.s9_19*work.s9_29;
  work.s9_31 = work.s9_20*work.s9_29;
  work.s9_32 = work.s9_21*work.s9_29;
  work.s9_33 = work.s9_22*work.s9_29;
  const double s9_34 = work.s9_23*work.s9_29;
  const double s9_35 = work.s9_25*work.s9_29;
  const double s9_36 = work.s9_26*work.s9_29;
  work.s9_37 = work.s8_1139 - work.s8_1334*s9_8 - work.s8_1280*s9_17 - work.s9_19*s9_36;
  work.s9_38 = work.s8_1137 - work.s8_1331*s9_8 - work.s8_1277*s9_17 - work.s9_20*s9_36;
  work.s9_39 = work.s8_1135 - work.s8_1328*s9_8 - work.s8_1274*s9_17 - work.s9_21*s9_36;
  work.s9_40 = work.s8_1134 - work.s8_1325*s9_8 - work.s8_1271*s9_17 - work.s9_22*s9_36;
  work.s9_41 = work.s8_1132 - work.s8_1322*s9_8 - work.s8_1268*s9_17 - work.s9_23*s9_36;
  const double s9_42 = work.s8_1118 - work.N_wheel_rear_right_x*s9_8;
  work.s9_43 = s9_42 - work.N_wheel_rear_left_x*s9_17 - work.s9_25*s9_36;
  const double s9_44 = work.s8_1149 - work.s8_1339*s9_8 - work.s8_1285*s9_17 - work.s9_26*s9_36;
  const double s9_45 = work.s8_1157 - work.Q_wheel_rear_right*s9_8;
  work.s9_46 = s9_45 - work.Q_wheel_rear_left*s9_17 - work.s9_28*s9_36;
  result.inertia[11] = s9_44 - 1e-12*work.s8_1149;
  work.s9_47 = 1.0/s9_44;
  work.s9_48 = work.s9_37*work.s9_47;
  work.s9_49 = work.s9_38*work.s9_47;
  work.s9_50 = work.s9_39*work.s9_47;
  work.s9_51 = work.s9_40*work.s9_47;
  const double s9_52 = work.s9_41*work.s9_47;
  const double s9_53 = work.s9_43*work.s9_47;
  result.inertia[10] = work.s8_839 - 1e-12*work.s8_839;
  work.s9_54 = 1.0/work.s8_839;
  work.s9_55 = work.s8_868*work.s9_54;
  work.s9_56 = work.s8_865*work.s9_54;
  work.s9_57 = work.s8_862*work.s9_54;
  work.s9_58 = work.s8_859*work.s9_54;
  const double s9_59 = work.s8_856*work.s9_54;
  const double s9_60 = work.N_wheel_front_right_x*work.s9_54;
  const double s9_61 = work.s8_870*work.s9_54;
  const double s9_62 = work.s8_872*work.s9_54;
  const double s9_63 = work.s8_874*work.s9_54;
  result.inertia[9] = work.s8_785 - 1e-12*work.s8_785;
  work.s9_64 = 1.0/work.s8_785;
  work.s9_65 = work.s8_814*work.s9_64;
  work.s9_66 = work.s8_811*work.s9_64;
  work.s9_67 = work.s8_808*work.s9_64;
  work.s9_68 = work.s8_805*work.s9_64;
  const double s9_69 = work.s8_802*work.s9_64;
  const double s9_70 = work.N_wheel_front_left_x*work.s9_64;
  const double s9_71 = work.s8_816*work.s9_64;
  const double s9_72 = work.s8_818*work.s9_64;
  const double s9_73 = work.s8_820*work.s9_64;
  work.s9_74 = work.s8_731 - work.s8_868*s9_63 - work.s8_814*s9_73;
  work.s9_75 = work.s8_729 - work.s8_865*s9_63 - work.s8_811*s9_73;
  work.s9_76 = work.s8_727 - work.s8_862*s9_63 - work.s8_808*s9_73;
  work.s9_77 = work.s8_726 - work.s8_859*s9_63 - work.s8_805*s9_73;
  work.s9_78 = work.s8_725 - work.s8_856*s9_63 - work.s8_802*s9_73;
  const double s9_79 = work.s8_703 - work.N_wheel_front_right_x*s9_63;
  work.s9_80 = s9_79 - work.N_wheel_front_left_x*s9_73;
  work.s9_81 = work.s8_738 - work.s8_870*s9_63 - work.s8_816*s9_73;
  work.s9_82 = work.s8_745 - work.s8_872*s9_63 - work.s8_818*s9_73;
  const double s9_83 = work.s8_752 - work.s8_874*s9_63 - work.s8_820*s9_73;
  const double s9_84 = work.s8_766 - work.Q_wheel_front_right*s9_63;
  work.s9_85 = s9_84 - work.Q_wheel_front_left*s9_73;
  result.inertia[8] = s9_83 - 1e-12*work.s8_752;
  work.s9_86 = 1.0/s9_83;
  work.s9_87 = work.s9_74*work.s9_86;
  work.s9_88 = work.s9_75*work.s9_86;
  work.s9_89 = work.s9_76*work.s9_86;
  work.s9_90 = work.s9_77*work.s9_86;
  const double s9_91 = work.s9_78*work.s9_86;
  const double s9_92 = work.s9_80*work.s9_86;
  const double s9_93 = work.s9_81*work.s9_86;
  const double s9_94 = work.s9_82*work.s9_86;
  work.s9_95 = work.s8_613 - work.s8_868*s9_62 - work.s8_814*s9_72 - work.s9_74*s9_94;
  work.s9_96 = work.s8_611 - work.s8_865*s9_62 - work.s8_811*s9_72 - work.s9_75*s9_94;
  work.s9_97 = work.s8_609 - work.s8_862*s9_62 - work.s8_808*s9_72 - work.s9_76*s9_94;
  work.s9_98 = work.s8_608 - work.s8_859*s9_62 - work.s8_805*s9_72 - work.s9_77*s9_94;
  work.s9_99 = work.s8_607 - work.s8_856*s9_62 - work.s8_802*s9_72 - work.s9_78*s9_94;
  const double s9_100 = work.s8_585 - work.N_wheel_front_right_x*s9_62;
  work.s9_101 = s9_100 - work.N_wheel_front_left_x*s9_72 - work.s9_80*s9_94;
  work.s9_102 = work.s8_620 - work.s8_870*s9_62 - work.s8_816*s9_72 - work.s9_81*s9_94;
  const double s9_103 = work.s8_627 - work.s8_872*s9_62 - work.s8_818*s9_72 - work.s9_82*s9_94;
  const double s9_104 = work.s8_641 - work.Q_wheel_front_right*s9_62;
  work.s9_105 = s9_104 - work.Q_wheel_front_left*s9_72 - work.s9_85*s9_94;
  result.inertia[7] = s9_103 - 1e-12*work.s8_627;
  work.s9_106 = 1.0/s9_103;
  work.s9_107 = work.s9_95*work.s9_106;
  work.s9_108 = work.s9_96*work.s9_106;
  work.s9_109 = work.s9_97*work.s9_106;
  work.s9_110 = work.s9_98*work.s9_106;
  const double s9_111 = work.s9_99*work.s9_106;
  const double s9_112 = work.s9_101*work.s9_106;
  const double s9_113 = work.s9_102*work.s9_106;
  const double s9_114 = work.s8_497 - work.s8_868*s9_61 - work.s8_814*s9_71 - work.s9_74*s9_93;
  work.s9_115 = s9_114 - work.s9_95*s9_113;
  const double s9_116 = work.s8_495 - work.s8_865*s9_61 - work.s8_811*s9_71 - work.s9_75*s9_93;
  work.s9_117 = s9_116 - work.s9_96*s9_113;
  const double s9_118 = work.s8_493 - work.s8_862*s9_61 - work.s8_808*s9_71 - work.s9_76*s9_93;
  work.s9_119 = s9_118 - work.s9_97*s9_113;
  const double s9_120 = work.s8_492 - work.s8_859*s9_61 - work.s8_805*s9_71 - work.s9_77*s9_93;
  work.s9_121 = s9_120 - work.s9_98*s9_113;
  const double s9_122 = work.s8_491 - work.s8_856*s9_61 - work.s8_802*s9_71 - work.s9_78*s9_93;
  work.s9_123 = s9_122 - work.s9_99*s9_113;
  const double s9_124 = work.s8_469 - work.N_wheel_front_right_x*s9_61;
  const double s9_125 = s9_124 - work.N_wheel_front_left_x*s9_71 - work.s9_80*s9_93;
  work.s9_126 = s9_125 - work.s9_101*s9_113;
  const double s9_127 = work.s8_509 - work.s8_870*s9_61 - work.s8_816*s9_71 - work.s9_81*s9_93;
  const double s9_128 = s9_127 - work.s9_102*s9_113;
  const double s9_129 = work.s8_523 - work.Q_wheel_front_right*s9_61;
  const double s9_130 = s9_129 - work.Q_wheel_front_left*s9_71 - work.s9_85*s9_93;
  work.s9_131 = s9_130 - work.s9_105*s9_113;
  result.inertia[6] = s9_128 - 1e-12*work.s8_509;
  work.s9_132 = 1.0/s9_128;
  work.s9_133 = work.s9_115*work.s9_132;
  work.s9_134 = work.s9_117*work.s9_132;
  work.s9_135 = work.s9_119*work.s9_132;
  work.s9_136 = work.s9_121*work.s9_132;
  const double s9_137 = work.s9_123*work.s9_132;
  const double s9_138 = work.s9_126*work.s9_132;
  const double s9_139 = work.N_chassis_tx_x - work.s8_1334*s9_7 - work.s8_1280*s9_16;
  const double s9_140 = s9_139 - work.s9_19*s9_35 - work.s9_37*s9_53 - work.s8_868*s9_60;
  const double s9_141 = s9_140 - work.s8_814*s9_70 - work.s9_74*s9_92 - work.s9_95*s9_112;
  work.s9_142 = s9_141 - work.s9_115*s9_138;
  const double s9_143 = work.N_chassis_ty_x - work.s8_1331*s9_7 - work.s8_1277*s9_16;
  const double s9_144 = s9_143 - work.s9_20*s9_35 - work.s9_38*s9_53 - work.s8_865*s9_60;
  const double s9_145 = s9_144 - work.s8_811*s9_70 - work.s9_75*s9_92 - work.s9_96*s9_112;
  work.s9_146 = s9_145 - work.s9_117*s9_138;
  const double s9_147 = work.N_chassis_tz_x - work.s8_1328*s9_7 - work.s8_1274*s9_16;
  const double s9_148 = s9_147 - work.s9_21*s9_35 - work.s9_39*s9_53 - work.s8_862*s9_60;
  const double s9_149 = s9_148 - work.s8_808*s9_70 - work.s9_76*s9_92 - work.s9_97*s9_112;
  work.s9_150 = s9_149 - work.s9_119*s9_138;
  const double s9_151 = work.N_chassis_rz_x - work.s8_1325*s9_7 - work.s8_1271*s9_16;
  const double s9_152 = s9_151 - work.s9_22*s9_35 - work.s9_40*s9_53 - work.s8_859*s9_60;
  const double s9_153 = s9_152 - work.s8_805*s9_70 - work.s9_77*s9_92 - work.s9_98*s9_112;
  work.s9_154 = s9_153 - work.s9_121*s9_138;
  const double s9_155 = work.N_chassis_ry_x - work.s8_1322*s9_7 - work.s8_1268*s9_16;
  const double s9_156 = s9_155 - work.s9_23*s9_35 - work.s9_41*s9_53 - work.s8_856*s9_60;
  const double s9_157 = s9_156 - work.s8_802*s9_70 - work.s9_78*s9_92 - work.s9_99*s9_112;
  work.s9_158 = s9_157 - work.s9_123*s9_138;
  const double s9_159 = work.N_chassis_rx_x - work.N_wheel_rear_right_x*s9_7;
  const double s9_160 = s9_159 - work.N_wheel_rear_left_x*s9_16 - work.s9_25*s9_35;
  const double s9_161 = s9_160 - work.s9_43*s9_53 - work.N_wheel_front_right_x*s9_60;
  const double s9_162 = s9_161 - work.N_wheel_front_left_x*s9_70 - work.s9_80*s9_92;
  const double s9_163 = s9_162 - work.s9_101*s9_112 - work.s9_126*s9_138;
  const double s9_164 = work.Q_chassis_rx - work.Q_wheel_rear_right*s9_7;
  const double s9_165 = s9_164 - work.Q_wheel_rear_left*s9_16 - work.s9_28*s9_35;
  const double s9_166 = s9_165 - work.s9_46*s9_53 - work.Q_wheel_front_right*s9_60;
  const double s9_167 = s9_166 - work.Q_wheel_front_left*s9_70 - work.s9_85*s9_92;
  work.s9_168 = s9_167 - work.s9_105*s9_112 - work.s9_131*s9_138;
  result.inertia[5] = s9_163 - 1e-12*work.N_chassis_rx_x;
  work.s9_169 = 1.0/s9_163;
  work.s9_170 = work.s9_142*work.s9_169;
  work.s9_171 = work.s9_146*work.s9_169;
  work.s9_172 = work.s9_150*work.s9_169;
  work.s9_173 = work.s9_154*work.s9_169;
  const double s9_174 = work.s9_158*work.s9_169;
  const double s9_175 = work.s8_34 - work.s8_1334*s9_6 - work.s8_1280*s9_15 - work.s9_19*s9_34;
  const double s9_176 = s9_175 - work.s9_37*s9_52 - work.s8_868*s9_59 - work.s8_814*s9_69;
  const double s9_177 = s9_176 - work.s9_74*s9_91 - work.s9_95*s9_111 - work.s9_115*s9_137;
  work.s9_178 = s9_177 - work.s9_142*s9_174;
  const double s9_179 = work.s8_32 - work.s8_1331*s9_6 - work.s8_1277*s9_15 - work.s9_20*s9_34;
  const double s9_180 = s9_179 - work.s9_38*s9_52 - work.s8_865*s9_59 - work.s8_811*s9_69;
  const double s9_181 = s9_180 - work.s9_75*s9_91 - work.s9_96*s9_111 - work.s9_117*s9_137;
  work.s9_182 = s9_181 - work.s9_146*s9_174;
  const double s9_183 = work.s8_30 + work.s8_1328*s9_6 + work.s8_1274*s9_15 + work.s9_21*s9_34;
  const double s9_184 = s9_183 + work.s9_39*s9_52 + work.s8_862*s9_59 + work.s8_808*s9_69;
  const double s9_185 = s9_184 + work.s9_76*s9_91 + work.s9_97*s9_111 + work.s9_119*s9_137;
  work.s9_186 = s9_185 + work.s9_150*s9_174;
  const double s9_187 = work.s8_28 - work.s8_1325*s9_6 - work.s8_1271*s9_15 - work.s9_22*s9_34;
  const double s9_188 = s9_187 - work.s9_40*s9_52 - work.s8_859*s9_59 - work.s8_805*s9_69;
  const double s9_189 = s9_188 - work.s9_77*s9_91 - work.s9_98*s9_111 - work.s9_121*s9_137;
  work.s9_190 = s9_189 - work.s9_154*s9_174;
  const double s9_191 = work.s8_26 - work.s8_1322*s9_6 - work.s8_1268*s9_15 - work.s9_23*s9_34;
  const double s9_192 = s9_191 - work.s9_41*s9_52 - work.s8_856*s9_59 - work.s8_802*s9_69;
  const double s9_193 = s9_192 - work.s9_78*s9_91 - work.s9_99*s9_111 - work.s9_123*s9_137;
  work.s9_194 = s9_193 - work.s9_158*s9_174;
  const double s9_195 = work.Q_chassis_ry - work.Q_wheel_rear_right*s9_6;
  const double s9_196 = s9_195 - work.Q_wheel_rear_left*s9_15 - work.s9_28*s9_34;
  const double s9_197 = s9_196 - work.s9_46*s9_52 - work.Q_wheel_front_right*s9_59;
  const double s9_198 = s9_197 - work.Q_wheel_front_left*s9_69 - work.s9_85*s9_91;
  work.s9_199 = s9_198 - work.s9_105*s9_111 - work.s9_131*s9_137 - work.s9_168*s9_174;
  result.inertia[4] = work.s9_194 - 1e-12*work.s8_26;
}

/// Part 11 of compute_chosen_accelerations: step 9: independent and all accelerations (63), (62).
[[gnu::noinline]] void compute_chosen_accelerations_11(const Projection& projection,
    ChosenAccelerationsWork& __restrict work, ChosenAccelerations& __restrict result) noexcept {
  // --- step 9: independent and all accelerations (63), (62), continued ---
  const double s9_200 = 1.0/work.s9_194;
  const double s9_201 = work.s9_178*s9_200;
  const double s9_202 = work.s9_182*s9_200;
  const double s9_203 = work.s9_186*s9_200;
  const double s9_204 = work.s9_190*s9_200;
  const double s9_205 = work.s8_23 - work.s8_1334*work.s9_5 - work.s8_1280*work.s9_14;
  const double s9_206 = s9_205 - work.s9_19*work.s9_33 - work.s9_37*work.s9_51;
  const double s9_207 = s9_206 - work.s8_868*work.s9_58 - work.s8_814*work.s9_68;
  const double s9_208 = s9_207 - work.s9_74*work.s9_90 - work.s9_95*work.s9_110;
  const double s9_209 = s9_208 - work.s9_115*work.s9_136 - work.s9_142*work.s9_173;
  const double s9_210 = s9_209 - work.s9_178*s9_204;
  const double s9_211 = work.s8_20 - work.s8_1331*work.s9_5 - work.s8_1277*work.s9_14;
  const double s9_212 = s9_211 - work.s9_20*work.s9_33 - work.s9_38*work.s9_51;
  const double s9_213 = s9_212 - work.s8_865*work.s9_58 - work.s8_811*work.s9_68;
  const double s9_214 = s9_213 - work.s9_75*work.s9_90 - work.s9_96*work.s9_110;
  const double s9_215 = s9_214 - work.s9_117*work.s9_136 - work.s9_146*work.s9_173;
  const double s9_216 = s9_215 - work.s9_182*s9_204;
  const double s9_217 = work.s8_17 - work.s8_1328*work.s9_5 - work.s8_1274*work.s9_14;
  const double s9_218 = s9_217 - work.s9_21*work.s9_33 - work.s9_39*work.s9_51;
  const double s9_219 = s9_218 - work.s8_862*work.s9_58 - work.s8_808*work.s9_68;
  const double s9_220 = s9_219 - work.s9_76*work.s9_90 - work.s9_97*work.s9_110;
  const double s9_221 = s9_220 - work.s9_119*work.s9_136 - work.s9_150*work.s9_173;
  const double s9_222 = s9_221 + work.s9_186*s9_204;
  const double s9_223 = work.s1_916 - work.s8_1325*work.s9_5 - work.s8_1271*work.s9_14;
  const double s9_224 = s9_223 - work.s9_22*work.s9_33 - work.s9_40*work.s9_51;
  const double s9_225 = s9_224 - work.s8_859*work.s9_58 - work.s8_805*work.s9_68;
  const double s9_226 = s9_225 - work.s9_77*work.s9_90 - work.s9_98*work.s9_110;
  const double s9_227 = s9_226 - work.s9_121*work.s9_136 - work.s9_154*work.s9_173;
  const double s9_228 = s9_227 - work.s9_190*s9_204;
  const double s9_229 = work.Q_chassis_rz - work.Q_wheel_rear_right*work.s9_5;
  const double s9_230 = s9_229 - work.Q_wheel_rear_left*work.s9_14 - work.s9_28*work.s9_33;
  const double s9_231 = s9_230 - work.s9_46*work.s9_51 - work.Q_wheel_front_right*work.s9_58;
  const double s9_232 = s9_231 - work.Q_wheel_front_left*work.s9_68 - work.s9_85*work.s9_90;
  const double s9_233 = s9_232 - work.s9_105*work.s9_110 - work.s9_131*work.s9_136;
  const double s9_234 = s9_233 - work.s9_168*work.s9_173 - work.s9_199*s9_204;
  result.inertia[3] = s9_228 - 1e-12*work.s1_916;
  const double s9_235 = 1.0/s9_228;
  const double s9_236 = s9_210*s9_235;
  const double s9_237 = s9_216*s9_235;
  const double s9_238 = s9_222*s9_235;
  const double s9_239 = work.s8_15 - work.s8_1334*work.s9_4 - work.s8_1280*work.s9_13;
  const double s9_240 = s9_239 - work.s9_19*work.s9_32 - work.s9_37*work.s9_50;
  const double s9_241 = s9_240 - work.s8_868*work.s9_57 - work.s8_814*work.s9_67;
  const double s9_242 = s9_241 - work.s9_74*work.s9_89 - work.s9_95*work.s9_109;
  const double s9_243 = s9_242 - work.s9_115*work.s9_135 - work.s9_142*work.s9_172;
  const double s9_244 = s9_243 + work.s9_178*s9_203 - s9_210*s9_238;
  const double s9_245 = work.s8_13 - work.s8_1331*work.s9_4 - work.s8_1277*work.s9_13;
  const double s9_246 = s9_245 - work.s9_20*work.s9_32 - work.s9_38*work.s9_50;
  const double s9_247 = s9_246 - work.s8_865*work.s9_57 - work.s8_811*work.s9_67;
  const double s9_248 = s9_247 - work.s9_75*work.s9_89 - work.s9_96*work.s9_109;
  const double s9_249 = s9_248 - work.s9_117*work.s9_135 - work.s9_146*work.s9_172;
  const double s9_250 = s9_249 + work.s9_182*s9_203 - s9_216*s9_238;
  const double s9_251 = work.s8_11 - work.s8_1328*work.s9_4 - work.s8_1274*work.s9_13;
  const double s9_252 = s9_251 - work.s9_21*work.s9_32 - work.s9_39*work.s9_50;
  const double s9_253 = s9_252 - work.s8_862*work.s9_57 - work.s8_808*work.s9_67;
  const double s9_254 = s9_253 - work.s9_76*work.s9_89 - work.s9_97*work.s9_109;
  const double s9_255 = s9_254 - work.s9_119*work.s9_135 - work.s9_150*work.s9_172;
  const double s9_256 = s9_255 - work.s9_186*s9_203 - s9_222*s9_238;
  const double s9_257 = work.Q_chassis_tz - work.Q_wheel_rear_right*work.s9_4;
  const double s9_258 = s9_257 - work.Q_wheel_rear_left*work.s9_13 - work.s9_28*work.s9_32;
  const double s9_259 = s9_258 - work.s9_46*work.s9_50 - work.Q_wheel_front_right*work.s9_57;
  const double s9_260 = s9_259 - work.Q_wheel_front_left*work.s9_67 - work.s9_85*work.s9_89;
  const double s9_261 = s9_260 - work.s9_105*work.s9_109 - work.s9_131*work.s9_135;
  const double s9_262 = s9_261 - work.s9_168*work.s9_172 + work.s9_199*s9_203 - s9_234*s9_238;
  result.inertia[2] = s9_256 - 1e-12*work.s8_11;
  const double s9_263 = 1.0/s9_256;
  const double s9_264 = s9_244*s9_263;
  const double s9_265 = s9_250*s9_263;
  const double s9_266 = work.s8_6 - work.s8_1334*work.s9_3 - work.s8_1280*work.s9_12;
  const double s9_267 = s9_266 - work.s9_19*work.s9_31 - work.s9_37*work.s9_49;
  const double s9_268 = s9_267 - work.s8_868*work.s9_56 - work.s8_814*work.s9_66;
  const double s9_269 = s9_268 - work.s9_74*work.s9_88 - work.s9_95*work.s9_108;
  const double s9_270 = s9_269 - work.s9_115*work.s9_134 - work.s9_142*work.s9_171;
  const double s9_271 = s9_270 - work.s9_178*s9_202 - s9_210*s9_237 - s9_244*s9_265;
  const double s9_272 = work.s8_4 - work.s8_1331*work.s9_3 - work.s8_1277*work.s9_12;
  const double s9_273 = s9_272 - work.s9_20*work.s9_31 - work.s9_38*work.s9_49;
  const double s9_274 = s9_273 - work.s8_865*work.s9_56 - work.s8_811*work.s9_66;
  const double s9_275 = s9_274 - work.s9_75*work.s9_88 - work.s9_96*work.s9_108;
  const double s9_276 = s9_275 - work.s9_117*work.s9_134 - work.s9_146*work.s9_171;
  const double s9_277 = s9_276 - work.s9_182*s9_202 - s9_216*s9_237 - s9_250*s9_265;
  const double s9_278 = work.Q_chassis_ty - work.Q_wheel_rear_right*work.s9_3;
  const double s9_279 = s9_278 - work.Q_wheel_rear_left*work.s9_12 - work.s9_28*work.s9_31;
  const double s9_280 = s9_279 - work.s9_46*work.s9_49 - work.Q_wheel_front_right*work.s9_56;
  const double s9_281 = s9_280 - work.Q_wheel_front_left*work.s9_66 - work.s9_85*work.s9_88;
  const double s9_282 = s9_281 - work.s9_105*work.s9_108 - work.s9_131*work.s9_134;
  const double s9_283 = s9_282 - work.s9_168*work.s9_171 - work.s9_199*s9_202 - s9_234*s9_237;
  const double s9_284 = s9_283 - s9_262*s9_265;
  result.inertia[1] = s9_277 - 1e-12*work.s8_4;
  const double s9_285 = 1.0/s9_277;
  const double s9_286 = s9_271*s9_285;
  const double s9_287 = work.s8_2 - work.s8_1334*work.s9_2 - work.s8_1280*work.s9_11;
  const double s9_288 = s9_287 - work.s9_19*work.s9_30 - work.s9_37*work.s9_48;
  const double s9_289 = s9_288 - work.s8_868*work.s9_55 - work.s8_814*work.s9_65;
  const double s9_290 = s9_289 - work.s9_74*work.s9_87 - work.s9_95*work.s9_107;
  const double s9_291 = s9_290 - work.s9_115*work.s9_133 - work.s9_142*work.s9_170;
  const double s9_292 = s9_291 - work.s9_178*s9_201 - s9_210*s9_236 - s9_244*s9_264;
  const double s9_293 = s9_292 - s9_271*s9_286;
  const double s9_294 = work.Q_chassis_tx - work.Q_wheel_rear_right*work.s9_2;
  const double s9_295 = s9_294 - work.Q_wheel_rear_left*work.s9_11 - work.s9_28*work.s9_30;
  const double s9_296 = s9_295 - work.s9_46*work.s9_48 - work.Q_wheel_front_right*work.s9_55;
  const double s9_297 = s9_296 - work.Q_wheel_front_left*work.s9_65 - work.s9_85*work.s9_87;
  const double s9_298 = s9_297 - work.s9_105*work.s9_107 - work.s9_131*work.s9_133;
  const double s9_299 = s9_298 - work.s9_168*work.s9_170 - work.s9_199*s9_201 - s9_234*s9_236;
  result.inertia[0] = s9_293 - 1e-12*work.s8_2;
  const double s9_300 = (s9_299 - s9_262*s9_264 - s9_284*s9_286)*(1.0/s9_293);
  result.zdd[Coordinate::chassis_tx] = s9_300;
  const double s9_301 = s9_285*(s9_284 - s9_271*s9_300);
  result.zdd[Coordinate::chassis_ty] = s9_301;
  const double s9_302 = s9_263*(s9_262 - s9_244*s9_300 - s9_250*s9_301);
  result.zdd[Coordinate::chassis_tz] = s9_302;
  const double s9_303 = s9_235*(s9_234 - s9_210*s9_300 - s9_216*s9_301 - s9_222*s9_302);
  result.zdd[Coordinate::chassis_rz] = s9_303;
  const double s9_304 = work.s9_199 - work.s9_178*s9_300 - work.s9_182*s9_301;
  const double s9_305 = s9_200*(s9_304 + work.s9_186*s9_302 - work.s9_190*s9_303);
  result.zdd[Coordinate::chassis_ry] = s9_305;
  const double s9_306 = work.s9_168 - work.s9_142*s9_300 - work.s9_146*s9_301;
  const double s9_307 = s9_306 - work.s9_150*s9_302 - work.s9_154*s9_303 - work.s9_158*s9_305;
  const double s9_308 = work.s9_169*s9_307;
  result.zdd[Coordinate::chassis_rx] = s9_308;
  const double s9_309 = work.s9_131 - work.s9_115*s9_300 - work.s9_117*s9_301;
  const double s9_310 = s9_309 - work.s9_119*s9_302 - work.s9_121*s9_303 - work.s9_123*s9_305;
  const double s9_311 = work.s9_132*(s9_310 - work.s9_126*s9_308);
  const double s9_312 = work.s9_105 - work.s9_95*s9_300 - work.s9_96*s9_301 - work.s9_97*s9_302;
  const double s9_313 = s9_312 - work.s9_98*s9_303 - work.s9_99*s9_305 - work.s9_101*s9_308;
  const double s9_314 = work.s9_106*(s9_313 - work.s9_102*s9_311);
  const double s9_315 = work.s9_85 - work.s9_74*s9_300 - work.s9_75*s9_301 - work.s9_76*s9_302;
  const double s9_316 = s9_315 - work.s9_77*s9_303 - work.s9_78*s9_305 - work.s9_80*s9_308;
  const double s9_317 = work.s9_86*(s9_316 - work.s9_81*s9_311 - work.s9_82*s9_314);
  const double s9_318 = work.Q_wheel_front_left - work.s8_814*s9_300 - work.s8_811*s9_301;
  const double s9_319 = s9_318 - work.s8_808*s9_302 - work.s8_805*s9_303 - work.s8_802*s9_305;
  const double s9_320 = s9_319 - work.N_wheel_front_left_x*s9_308 - work.s8_816*s9_311;
  result.zdd[Coordinate::wheel_front_left] = work.s9_64*(s9_320 - work.s8_818*s9_314 -
      work.s8_820*s9_317);
  const double s9_321 = work.Q_wheel_front_right - work.s8_868*s9_300 - work.s8_865*s9_301;
  const double s9_322 = s9_321 - work.s8_862*s9_302 - work.s8_859*s9_303 - work.s8_856*s9_305;
  const double s9_323 = s9_322 - work.N_wheel_front_right_x*s9_308 - work.s8_870*s9_311;
  result.zdd[Coordinate::wheel_front_right] = work.s9_54*(s9_323 - work.s8_872*s9_314 -
      work.s8_874*s9_317);
  const double s9_324 = work.s9_46 - work.s9_37*s9_300 - work.s9_38*s9_301 - work.s9_39*s9_302;
  const double s9_325 = s9_324 - work.s9_40*s9_303 - work.s9_41*s9_305 - work.s9_43*s9_308;
  const double s9_326 = work.s9_47*s9_325;
  const double s9_327 = work.s9_28 - work.s9_19*s9_300 - work.s9_20*s9_301 - work.s9_21*s9_302;
  const double s9_328 = s9_327 - work.s9_22*s9_303 - work.s9_23*s9_305 - work.s9_25*s9_308;
  const double s9_329 = work.s9_29*(s9_328 - work.s9_26*s9_326);
  const double s9_330 = work.Q_wheel_rear_left - work.s8_1280*s9_300 - work.s8_1277*s9_301;
  const double s9_331 = s9_330 - work.s8_1274*s9_302 - work.s8_1271*s9_303 - work.s8_1268*s9_305;
  const double s9_332 = s9_331 - work.N_wheel_rear_left_x*s9_308 - work.s8_1285*s9_326;
  result.zdd[Coordinate::wheel_rear_left] = work.s9_10*(s9_332 - work.s8_1290*s9_329);
  const double s9_333 = work.Q_wheel_rear_right - work.s8_1334*s9_300 - work.s8_1331*s9_301;
  const double s9_334 = s9_333 - work.s8_1328*s9_302 - work.s8_1325*s9_303 - work.s8_1322*s9_305;
  const double s9_335 = s9_334 - work.N_wheel_rear_right_x*s9_308 - work.s8_1339*s9_326;
  result.zdd[Coordinate::wheel_rear_right] = work.s9_1*(s9_335 - work.s8_1344*s9_329);
  const double s9_336 = projection.zdd_star[0] + projection.Rz[0]*s9_311;
  result.zdd[Coordinate::lower_arm_left] = s9_336 + projection.Rz[1]*s9_314 +
      projection.Rz[2]*s9_317;
  const double s9_337 = projection.zdd_star[1] + projection.Rz[3]*s9_311;
  result.zdd[Coordinate::carrier_left_rz] = s9_337 + projection.Rz[4]*s9_314 +
      projection.Rz[5]*s9_317;
  const double s9_338 = projection.zdd_star[2] + projection.Rz[6]*s9_311;
  result.zdd[Coordinate::carrier_left_rx] = s9_338 + projection.Rz[7]*s9_314 +
      projection.Rz[8]*s9_317;
  const double s9_339 = projection.zdd_star[3] + projection.Rz[9]*s9_311;
  result.zdd[Coordinate::carrier_left_ry] = s9_339 + projection.Rz[10]*s9_314 +
      projection.Rz[11]*s9_317;
  const double s9_340 = projection.zdd_star[4] + projection.Rz[12]*s9_311;
  result.zdd[Coordinate::upper_arm_left] = s9_340 + projection.Rz[13]*s9_314 +
      projection.Rz[14]*s9_317;
  const double s9_341 = projection.zdd_star[5] + projection.Rz[15]*s9_311;
  result.zdd[Coordinate::arb_front_left] = s9_341 + projection.Rz[16]*s9_314 +
      projection.Rz[17]*s9_317;
  const double s9_342 = projection.zdd_star[6] + projection.Rz[18]*s9_311;
  result.zdd[Coordinate::lower_arm_right] = s9_342 + projection.Rz[19]*s9_314 +
      projection.Rz[20]*s9_317;
  const double s9_343 = projection.zdd_star[7] + projection.Rz[21]*s9_311;
  result.zdd[Coordinate::carrier_right_rz] = s9_343 + projection.Rz[22]*s9_314 +
      projection.Rz[23]*s9_317;
  const double s9_344 = projection.zdd_star[8] + projection.Rz[24]*s9_311;
  result.zdd[Coordinate::carrier_right_rx] = s9_344 + projection.Rz[25]*s9_314 +
      projection.Rz[26]*s9_317;
  const double s9_345 = projection.zdd_star[9] + projection.Rz[27]*s9_311;
  result.zdd[Coordinate::carrier_right_ry] = s9_345 + projection.Rz[28]*s9_314 +
      projection.Rz[29]*s9_317;
  const double s9_346 = projection.zdd_star[10] + projection.Rz[30]*s9_311;
  result.zdd[Coordinate::upper_arm_right] = s9_346 + projection.Rz[31]*s9_314 +
      projection.Rz[32]*s9_317;
  const double s9_347 = projection.zdd_star[11] + projection.Rz[33]*s9_311;
  result.zdd[Coordinate::arb_front_right] = s9_347 + projection.Rz[34]*s9_314 +
      projection.Rz[35]*s9_317;
  const double s9_348 = projection.zdd_star[12] + projection.Rz[36]*s9_311;
  result.zdd[Coordinate::pitman_arm] = s9_348 + projection.Rz[37]*s9_314 + projection.Rz[38]*s9_317;
  const double s9_349 = projection.zdd_star[13] + projection.Rz[39]*s9_311;
  result.zdd[Coordinate::bell_crank] = s9_349 + projection.Rz[40]*s9_314 + projection.Rz[41]*s9_317;
  const double s9_350 = projection.zdd_star[14] + projection.Rz[42]*s9_326;
  result.zdd[Coordinate::rear_axle_tx] = s9_350 + projection.Rz[43]*s9_329;
  const double s9_351 = projection.zdd_star[15] + projection.Rz[44]*s9_326;
  result.zdd[Coordinate::rear_axle_ty] = s9_351 + projection.Rz[45]*s9_329;
  const double s9_352 = projection.zdd_star[16] + projection.Rz[46]*s9_326;
  result.zdd[Coordinate::rear_axle_tz] = s9_352 + projection.Rz[47]*s9_329;
  const double s9_353 = projection.zdd_star[17] + projection.Rz[48]*s9_326;
  result.zdd[Coordinate::rear_axle_rz] = s9_353 + projection.Rz[49]*s9_329;
  const double s9_354 = projection.zdd_star[18] + projection.Rz[50]*s9_326;
  result.zdd[Coordinate::rear_axle_ry] = s9_354 + projection.Rz[51]*s9_329;
  const double s9_355 = projection.zdd_star[19] + projection.Rz[52]*s9_326;
  result.zdd[Coordinate::rear_axle_rx] = s9_355 + projection.Rz[53]*s9_329;
  const double s9_356 = projection.zdd_star[20] + projection.Rz[54]*s9_326;
  result.zdd[Coordinate::arb_rear_left] = s9_356 + projection.Rz[55]*s9_329;
  const double s9_357 = projection.zdd_star[21] + projection.Rz[56]*s9_326;
  result.zdd[Coordinate::arb_rear_right] = s9_357 + projection.Rz[57]*s9_329;
  // operations: 570 add, 668 multiply, 15 divide
}

/// All accelerations with a partition chosen at run time.
void compute_chosen_accelerations(const Parameters& /*parameters*/, const Inputs& /*inputs*/,
    const State& state, const double* tau, const Projection& projection,
    ChosenAccelerations& __restrict result) noexcept {
  ChosenAccelerationsWork work;
  compute_chosen_accelerations_1(state, work);
  compute_chosen_accelerations_2(state, work);
  compute_chosen_accelerations_3(state, projection, work);
  compute_chosen_accelerations_4(state, projection, work);
  compute_chosen_accelerations_5(state, tau, work);
  compute_chosen_accelerations_6(tau, work);
  compute_chosen_accelerations_7(projection, work);
  compute_chosen_accelerations_8(projection, work);
  compute_chosen_accelerations_9(state, projection, work);
  compute_chosen_accelerations_10(state, projection, work, result);
  compute_chosen_accelerations_11(projection, work, result);
}

/// Values of compute_outputs that cross its parts.
struct OutputsWork {
  double
      sines[22], cosines[22], r_chassis_aux3_z, R_chassis_aux5_x_x, R_chassis_aux5_y_x,
      R_chassis_z_y, R_chassis_z_z, R_chassis_x_y, R_chassis_x_z, R_chassis_y_y, R_chassis_y_z,
      r_carrier_left_aux1_y, r_carrier_left_aux1_z, R_carrier_left_aux1_y_x,
      R_carrier_left_aux1_z_x, b_carrier_left_rz_x, s1_10, s1_11, s1_13, R_carrier_left_aux2_y_y,
      R_carrier_left_aux2_z_y, b_carrier_left_rx_x, b_carrier_left_rx_y, b_carrier_left_rx_z,
      R_carrier_left_x_x, R_carrier_left_y_x, R_carrier_left_z_x, R_carrier_left_x_z,
      R_carrier_left_y_z, R_carrier_left_z_z, b_carrier_left_ry_x, s1_22, b_carrier_left_ry_z,
      r_wheel_front_left_x, r_wheel_front_left_y, r_wheel_front_left_z, b_wheel_front_left_x, s1_30,
      b_wheel_front_left_z, r_carrier_right_aux1_y, s1_34, R_carrier_right_aux1_y_x,
      R_carrier_right_aux1_z_x, b_carrier_right_rz_x, s1_37, s1_38, s1_40, R_carrier_right_aux2_y_y,
      R_carrier_right_aux2_z_y, b_carrier_right_rx_x, s1_44, b_carrier_right_rx_z,
      R_carrier_right_x_x, R_carrier_right_y_x, R_carrier_right_z_x, R_carrier_right_x_z,
      R_carrier_right_y_z, R_carrier_right_z_z, b_carrier_right_ry_x, b_carrier_right_ry_y,
      b_carrier_right_ry_z, r_wheel_front_right_x, r_wheel_front_right_y, r_wheel_front_right_z,
      b_wheel_front_right_x, s1_56, b_wheel_front_right_z, r_rear_axle_aux1_x, r_rear_axle_aux3_z,
      R_rear_axle_aux5_x_x, R_rear_axle_aux5_y_x, s1_59, s1_60, b_rear_axle_ry_z, R_rear_axle_x_y,
      R_rear_axle_y_y, R_rear_axle_z_y, R_rear_axle_x_z, R_rear_axle_y_z, R_rear_axle_z_z, s1_64,
      b_rear_axle_rx_y, b_rear_axle_rx_z, r_wheel_rear_left_x, r_wheel_rear_left_y,
      r_wheel_rear_left_z, b_wheel_rear_left_x, b_wheel_rear_left_y, b_wheel_rear_left_z,
      r_wheel_rear_right_x, r_wheel_rear_right_y, r_wheel_rear_right_z, b_wheel_rear_right_x,
      b_wheel_rear_right_y, b_wheel_rear_right_z, s1_77, s1_79, s1_83, s1_84, s1_85, s1_88, s1_92,
      s1_96, s1_124, s1_126, s1_128, s1_130, s1_132, s1_134, s1_143, s1_145, s1_147, s1_149, s1_151,
      s1_153, s1_155, s1_157, s1_161, s1_162, s1_163, s1_165, s1_167, s1_170, s1_174, s1_178,
      s1_179, s1_180, s1_182, s1_184, s1_188, s1_189, s1_190, s1_193, s1_197, s1_200, s1_227,
      s1_229, s1_231, s1_233, s1_235, s1_237, s1_246, s1_248, s1_250, s1_252, s1_254, s1_256,
      s1_258, s1_260, s1_264, s1_265, s1_266, s1_268, s1_270, s1_273, s1_277, s1_281, s1_282,
      s1_283, s1_284, s1_285, s1_289, s1_290, s1_291, s1_293, s1_295, s1_301, s1_302, s1_303,
      s1_305, s1_307, s1_309, s1_323, s1_325, s1_326, s1_328, s1_330, s1_332, s1_341, s1_343,
      s1_344, s1_346, s1_348, s1_350, s1_373, s1_376, s1_379, s1_381, s1_383, s1_385, s1_389,
      s1_392, s1_394, s1_396, s1_397, s1_398, s1_399, s1_400, s1_402, s1_405, s1_408, s1_413,
      s1_414, s1_416, s1_419, s1_421, s1_422, s1_423, s1_432, s1_434, s1_435, s1_440, s1_442,
      s1_444, s1_452, s1_453, s1_456, s1_457, s1_458, s1_459, s1_460, s1_461, s1_462, s1_463,
      s1_464, s1_465, s1_466, s1_467, s1_468, s1_469, v_chassis_x, v_chassis_y, v_chassis_z,
      w_chassis_y, w_chassis_z, w_chassis_x, w_lower_arm_left_x, v_carrier_left_x, v_carrier_left_y,
      v_carrier_left_z, w_carrier_left_x, w_carrier_left_y, w_carrier_left_z, w_wheel_front_left_x,
      w_wheel_front_left_y, w_wheel_front_left_z, w_upper_arm_left_x, v_arb_front_left_x,
      v_arb_front_left_z, w_arb_front_left_y, w_lower_arm_right_x, v_carrier_right_x,
      v_carrier_right_y, v_carrier_right_z, w_carrier_right_x, w_carrier_right_y, w_carrier_right_z,
      w_wheel_front_right_x, w_wheel_front_right_y, w_wheel_front_right_z, w_upper_arm_right_x,
      v_arb_front_right_x, v_arb_front_right_z, w_arb_front_right_y, w_pitman_arm_y, w_bell_crank_z,
      v_rear_axle_x, v_rear_axle_y, v_rear_axle_z, w_rear_axle_x, w_rear_axle_y, w_rear_axle_z,
      w_wheel_rear_left_x, w_wheel_rear_left_y, w_wheel_rear_left_z, v_arb_rear_left_x,
      v_arb_rear_left_z, w_arb_rear_left_y, w_wheel_rear_right_x, w_wheel_rear_right_y,
      w_wheel_rear_right_z, v_arb_rear_right_x, v_arb_rear_right_z, w_arb_rear_right_y, s7_1, s7_2,
      s7_4, s7_5, s7_6, s7_7, s7_9, s7_11, s7_13, s7_16, s7_19, s7_22, s7_23, s7_24, s7_25, s7_27,
      s7_29, s7_31, s7_32, s7_33, s7_34, s7_36, s7_38, s7_40, s7_43, s7_46, s7_49, s7_50, s7_51,
      s7_52, s7_54, s7_56, s7_58, s7_59, s7_60, s7_61, s7_62, s7_63, s7_64, s7_66, s7_68, s7_70,
      s7_73, s7_76, s7_79, s7_81, s7_83, s7_85, s7_88, s7_91, s7_94, s7_96, s7_98, s7_100, s9_5,
      s9_7, s9_11, s9_12, s9_13, s9_15, s9_17, s9_19, s9_21, s9_23, s9_26, s9_29, s9_32, s9_35,
      s9_37, s9_38, s9_39, s9_40, s9_43, s9_45, s9_46, s9_49, s9_51, s9_52, s9_53, s9_54, s9_56,
      s9_58, s9_60, s9_62, s9_65, s9_68, s9_71, s9_74, s9_76, s9_77, s9_78, s9_79, s9_80, s9_82,
      s9_83, s9_85, s9_86, s9_90, s9_92, s9_93, s9_94, s9_95, s9_96, s9_98, s9_102, s9_103, s9_104,
      s9_105, s9_112, s9_114, s9_116, s9_118, s9_120, s9_123, s9_126, s9_127, s9_128, s9_130,
      s9_133, s9_136, s9_139, s9_142, s9_143, s9_144, s9_145, s9_146, s9_159;
};

/// Part 1 of compute_outputs: step 1: poses, axes b, accumulated inertias MR (50).
[[gnu::noinline]] void compute_outputs_1(const State& state,
    OutputsWork& __restrict work) noexcept {
  // --- step 1: poses, axes b, accumulated inertias MR (50) ---
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
  work.R_chassis_aux5_x_x = R_chassis_aux4_x_x*R_chassis_aux5_z_z;
  const double R_chassis_aux4_y_x = work.sines[0];
  work.R_chassis_aux5_y_x = R_chassis_aux4_y_x*R_chassis_aux5_z_z;
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s1_1 = work.sines[2];
  work.R_chassis_z_y = R_chassis_aux5_z_z*s1_1;
  const double s1_2 = work.cosines[2];
  work.R_chassis_z_z = R_chassis_aux5_z_z*s1_2;
  const double s1_3 = work.sines[1];
  const double s1_4 = s1_3*s1_1;
  const double s1_5 = s1_3*s1_2;
  work.R_chassis_x_y = R_chassis_aux4_x_x*s1_4 - R_chassis_aux4_y_x*s1_2;
  work.R_chassis_x_z = R_chassis_aux4_y_x*s1_1 + R_chassis_aux4_x_x*s1_5;
  work.R_chassis_y_y = R_chassis_aux4_x_x*s1_2 + R_chassis_aux4_y_x*s1_4;
  work.R_chassis_y_z = R_chassis_aux4_y_x*s1_5 - R_chassis_aux4_x_x*s1_1;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s1_6 = 0.4 + 0.44999999999999996*R_lower_arm_left_y_y;
  work.r_carrier_left_aux1_y = s1_6 + 0.04999999999999999*R_lower_arm_left_z_y;
  const double s1_7 = 0.44999999999999996*R_lower_arm_left_z_y - 0.62;
  work.r_carrier_left_aux1_z = s1_7 - 0.04999999999999999*R_lower_arm_left_y_y;
  const double s1_8 = work.sines[4];
  work.R_carrier_left_aux1_y_x = R_lower_arm_left_y_y*s1_8;
  work.R_carrier_left_aux1_z_x = R_lower_arm_left_z_y*s1_8;
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double R_carrier_left_aux1_y_y = R_lower_arm_left_y_y*R_carrier_left_aux1_x_x;
  const double R_carrier_left_aux1_z_y = R_lower_arm_left_z_y*R_carrier_left_aux1_x_x;
  const double s1_9 = R_lower_arm_left_z_y*work.r_carrier_left_aux1_z;
  work.b_carrier_left_rz_x = s1_9 + R_lower_arm_left_y_y*work.r_carrier_left_aux1_y;
  work.s1_10 = 3.6*R_lower_arm_left_y_y;
  work.s1_11 = 3.6*R_lower_arm_left_z_y;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_12 = work.cosines[5];
  work.s1_13 = s1_8*s1_12;
  const double s1_14 = work.sines[5];
  work.R_carrier_left_aux2_y_y = R_carrier_left_aux1_y_y*s1_12 - R_lower_arm_left_z_y*s1_14;
  work.R_carrier_left_aux2_z_y = R_carrier_left_aux1_z_y*s1_12 + R_lower_arm_left_y_y*s1_14;
  const double R_carrier_left_aux2_x_z = s1_8*s1_14;
  const double s1_15 = R_carrier_left_aux1_y_y*s1_14 + R_lower_arm_left_z_y*s1_12;
  const double R_carrier_left_aux2_z_z = R_lower_arm_left_y_y*s1_12 - R_carrier_left_aux1_z_y*s1_14;
  const double s1_16 = work.r_carrier_left_aux1_y*work.R_carrier_left_aux1_z_x;
  work.b_carrier_left_rx_x = s1_16 - work.r_carrier_left_aux1_z*work.R_carrier_left_aux1_y_x;
  const double s1_17 = work.r_carrier_left_aux1_z*R_carrier_left_aux1_x_x;
  work.b_carrier_left_rx_y = s1_17 - 3.6*work.R_carrier_left_aux1_z_x;
  const double s1_18 = work.r_carrier_left_aux1_y*R_carrier_left_aux1_x_x;
  work.b_carrier_left_rx_z = 3.6*work.R_carrier_left_aux1_y_x - s1_18;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_19 = work.cosines[6];
  const double s1_20 = work.sines[6];
  work.R_carrier_left_x_x = R_carrier_left_aux1_x_x*s1_19 - R_carrier_left_aux2_x_z*s1_20;
  work.R_carrier_left_y_x = s1_15*s1_20 + work.R_carrier_left_aux1_y_x*s1_19;
  work.R_carrier_left_z_x = work.R_carrier_left_aux1_z_x*s1_19 - R_carrier_left_aux2_z_z*s1_20;
  work.R_carrier_left_x_z = R_carrier_left_aux2_x_z*s1_19 + R_carrier_left_aux1_x_x*s1_20;
  work.R_carrier_left_y_z = work.R_carrier_left_aux1_y_x*s1_20 - s1_15*s1_19;
  work.R_carrier_left_z_z = R_carrier_left_aux2_z_z*s1_19 + work.R_carrier_left_aux1_z_x*s1_20;
  const double s1_21 = work.r_carrier_left_aux1_y*work.R_carrier_left_aux2_z_y;
  work.b_carrier_left_ry_x = s1_21 - work.r_carrier_left_aux1_z*work.R_carrier_left_aux2_y_y;
  work.s1_22 = 3.6*work.R_carrier_left_aux2_z_y + work.r_carrier_left_aux1_z*work.s1_13;
  work.b_carrier_left_ry_z = work.r_carrier_left_aux1_y*work.s1_13 +
      3.6*work.R_carrier_left_aux2_y_y;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s1_23 = 3.6 + 0.16999999999999998*work.R_carrier_left_x_z;
  work.r_wheel_front_left_x = s1_23 - 0.17499999999999993*work.s1_13;
  const double s1_24 = 0.17499999999999993*work.R_carrier_left_aux2_y_y;
  const double s1_25 = 0.16999999999999998*work.R_carrier_left_y_z;
  work.r_wheel_front_left_y = work.r_carrier_left_aux1_y + s1_24 + s1_25;
  const double s1_26 = 0.17499999999999993*work.R_carrier_left_aux2_z_y;
  const double s1_27 = 0.16999999999999998*work.R_carrier_left_z_z;
  work.r_wheel_front_left_z = work.r_carrier_left_aux1_z + s1_26 + s1_27;
  const double s1_28 = work.R_carrier_left_aux2_z_y*work.r_wheel_front_left_y;
  work.b_wheel_front_left_x = s1_28 - work.R_carrier_left_aux2_y_y*work.r_wheel_front_left_z;
  const double s1_29 = work.R_carrier_left_aux2_z_y*work.r_wheel_front_left_x;
  work.s1_30 = s1_29 + work.s1_13*work.r_wheel_front_left_z;
  const double s1_31 = work.R_carrier_left_aux2_y_y*work.r_wheel_front_left_x;
  work.b_wheel_front_left_z = work.s1_13*work.r_wheel_front_left_y + s1_31;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_z_y = work.sines[9];
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s1_32 = 0.04999999999999999*R_lower_arm_right_z_y - 0.4;
  work.r_carrier_right_aux1_y = s1_32 - 0.44999999999999996*R_lower_arm_right_y_y;
  const double s1_33 = 0.62 + 0.44999999999999996*R_lower_arm_right_z_y;
  work.s1_34 = s1_33 + 0.04999999999999999*R_lower_arm_right_y_y;
  const double s1_35 = work.sines[10];
  work.R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_35;
  work.R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_35;
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  const double s1_36 = R_lower_arm_right_y_y*work.r_carrier_right_aux1_y;
  work.b_carrier_right_rz_x = s1_36 - R_lower_arm_right_z_y*work.s1_34;
  work.s1_37 = 3.6*R_lower_arm_right_y_y;
  work.s1_38 = 3.6*R_lower_arm_right_z_y;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_39 = work.cosines[11];
  work.s1_40 = s1_35*s1_39;
  const double s1_41 = work.sines[11];
  work.R_carrier_right_aux2_y_y = R_carrier_right_aux1_y_y*s1_39 - R_lower_arm_right_z_y*s1_41;
  work.R_carrier_right_aux2_z_y = R_carrier_right_aux1_z_y*s1_39 + R_lower_arm_right_y_y*s1_41;
  const double R_carrier_right_aux2_x_z = s1_35*s1_41;
  const double s1_42 = R_carrier_right_aux1_y_y*s1_41 + R_lower_arm_right_z_y*s1_39;
  const double R_carrier_right_aux2_z_z = R_lower_arm_right_y_y*s1_39 -
      R_carrier_right_aux1_z_y*s1_41;
  const double s1_43 = work.r_carrier_right_aux1_y*work.R_carrier_right_aux1_z_x;
  work.b_carrier_right_rx_x = work.s1_34*work.R_carrier_right_aux1_y_x + s1_43;
  work.s1_44 = 3.6*work.R_carrier_right_aux1_z_x + work.s1_34*R_carrier_right_aux1_x_x;
  const double s1_45 = work.r_carrier_right_aux1_y*R_carrier_right_aux1_x_x;
  work.b_carrier_right_rx_z = 3.6*work.R_carrier_right_aux1_y_x - s1_45;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_46 = work.cosines[12];
  const double s1_47 = work.sines[12];
  work.R_carrier_right_x_x = R_carrier_right_aux1_x_x*s1_46 - R_carrier_right_aux2_x_z*s1_47;
  work.R_carrier_right_y_x = s1_42*s1_47 + work.R_carrier_right_aux1_y_x*s1_46;
  work.R_carrier_right_z_x = work.R_carrier_right_aux1_z_x*s1_46 - R_carrier_right_aux2_z_z*s1_47;
  work.R_carrier_right_x_z = R_carrier_right_aux2_x_z*s1_46 + R_carrier_right_aux1_x_x*s1_47;
  work.R_carrier_right_y_z = work.R_carrier_right_aux1_y_x*s1_47 - s1_42*s1_46;
  work.R_carrier_right_z_z = R_carrier_right_aux2_z_z*s1_46 + work.R_carrier_right_aux1_z_x*s1_47;
  const double s1_48 = work.r_carrier_right_aux1_y*work.R_carrier_right_aux2_z_y;
  work.b_carrier_right_ry_x = work.s1_34*work.R_carrier_right_aux2_y_y + s1_48;
  work.b_carrier_right_ry_y = work.s1_34*work.s1_40 - 3.6*work.R_carrier_right_aux2_z_y;
  const double s1_49 = work.r_carrier_right_aux1_y*work.s1_40;
  work.b_carrier_right_ry_z = s1_49 + 3.6*work.R_carrier_right_aux2_y_y;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s1_50 = 0.16999999999999998*work.R_carrier_right_x_z;
  work.r_wheel_front_right_x = 3.6 + 0.17499999999999993*work.s1_40 + s1_50;
  const double s1_51 = 0.16999999999999998*work.R_carrier_right_y_z;
  const double s1_52 = 0.17499999999999993*work.R_carrier_right_aux2_y_y;
  work.r_wheel_front_right_y = work.r_carrier_right_aux1_y + s1_51 - s1_52;
  const double s1_53 = 0.16999999999999998*work.R_carrier_right_z_z - work.s1_34;
  work.r_wheel_front_right_z = s1_53 - 0.17499999999999993*work.R_carrier_right_aux2_z_y;
  const double s1_54 = work.R_carrier_right_aux2_z_y*work.r_wheel_front_right_y;
  work.b_wheel_front_right_x = s1_54 - work.R_carrier_right_aux2_y_y*work.r_wheel_front_right_z;
  const double s1_55 = work.R_carrier_right_aux2_z_y*work.r_wheel_front_right_x;
  work.s1_56 = s1_55 + work.s1_40*work.r_wheel_front_right_z;
  const double s1_57 = work.R_carrier_right_aux2_y_y*work.r_wheel_front_right_x;
  work.b_wheel_front_right_z = work.s1_40*work.r_wheel_front_right_y + s1_57;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - 2.4999999999999996;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  work.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] - 0.5;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double R_rear_axle_aux5_z_z = work.cosines[18];
  work.R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double s1_58 = work.sines[18];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_58;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_58;
  work.s1_59 = work.r_rear_axle_aux3_z*R_rear_axle_aux4_x_x;
  work.s1_60 = work.r_rear_axle_aux3_z*R_rear_axle_aux4_y_x;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s1_61 = work.r_rear_axle_aux1_x*R_rear_axle_aux4_x_x;
  work.b_rear_axle_ry_z = z_rear_axle_ty*R_rear_axle_aux4_y_x + s1_61;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_62 = work.sines[19];
  const double s1_63 = work.cosines[19];
  work.R_rear_axle_x_y = R_rear_axle_aux5_x_z*s1_62 - R_rear_axle_aux4_y_x*s1_63;
  work.R_rear_axle_y_y = R_rear_axle_aux4_x_x*s1_63 + R_rear_axle_aux5_y_z*s1_62;
  work.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_62;
  work.R_rear_axle_x_z = R_rear_axle_aux4_y_x*s1_62 + R_rear_axle_aux5_x_z*s1_63;
  work.R_rear_axle_y_z = R_rear_axle_aux5_y_z*s1_63 - R_rear_axle_aux4_x_x*s1_62;
  work.R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_63;
  work.s1_64 = work.r_rear_axle_aux3_z*work.R_rear_axle_aux5_y_x + z_rear_axle_ty*s1_58;
  const double s1_65 = work.r_rear_axle_aux3_z*work.R_rear_axle_aux5_x_x;
  work.b_rear_axle_rx_y = work.r_rear_axle_aux1_x*s1_58 + s1_65;
  const double s1_66 = work.r_rear_axle_aux1_x*work.R_rear_axle_aux5_y_x;
  work.b_rear_axle_rx_z = s1_66 - z_rear_axle_ty*work.R_rear_axle_aux5_x_x;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s1_67 = 0.93*work.R_rear_axle_x_y;
  const double s1_68 = 0.93*work.R_rear_axle_y_y;
  const double s1_69 = 0.93*work.R_rear_axle_z_y;
  work.r_wheel_rear_left_x = work.r_rear_axle_aux1_x + s1_67;
  work.r_wheel_rear_left_y = z_rear_axle_ty + s1_68;
  work.r_wheel_rear_left_z = work.r_rear_axle_aux3_z + s1_69;
  const double s1_70 = work.R_rear_axle_z_y*work.r_wheel_rear_left_y;
  work.b_wheel_rear_left_x = s1_70 - work.R_rear_axle_y_y*work.r_wheel_rear_left_z;
  const double s1_71 = work.R_rear_axle_x_y*work.r_wheel_rear_left_z;
  work.b_wheel_rear_left_y = s1_71 - work.R_rear_axle_z_y*work.r_wheel_rear_left_x;
  const double s1_72 = work.R_rear_axle_y_y*work.r_wheel_rear_left_x;
  work.b_wheel_rear_left_z = s1_72 - work.R_rear_axle_x_y*work.r_wheel_rear_left_y;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  work.r_wheel_rear_right_x = work.r_rear_axle_aux1_x - s1_67;
  work.r_wheel_rear_right_y = z_rear_axle_ty - s1_68;
  work.r_wheel_rear_right_z = work.r_rear_axle_aux3_z - s1_69;
  const double s1_73 = work.R_rear_axle_z_y*work.r_wheel_rear_right_y;
  work.b_wheel_rear_right_x = s1_73 - work.R_rear_axle_y_y*work.r_wheel_rear_right_z;
  const double s1_74 = work.R_rear_axle_x_y*work.r_wheel_rear_right_z;
  work.b_wheel_rear_right_y = s1_74 - work.R_rear_axle_z_y*work.r_wheel_rear_right_x;
  const double s1_75 = work.R_rear_axle_y_y*work.r_wheel_rear_right_x;
  work.b_wheel_rear_right_z = s1_75 - work.R_rear_axle_x_y*work.r_wheel_rear_right_y;
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s1_76 = 0.4 + 0.21999999999999997*R_lower_arm_left_y_y;
  work.s1_77 = s1_76 + 0.025000000000000022*R_lower_arm_left_z_y;
  const double s1_78 = 0.21999999999999997*R_lower_arm_left_z_y - 0.62;
  work.s1_79 = s1_78 - 0.025000000000000022*R_lower_arm_left_y_y;
  const double s1_80 = 0.25*R_lower_arm_left_z_y;
  const double s1_81 = 0.8*R_lower_arm_left_y_y;
  const double s1_82 = R_lower_arm_left_y_y*(0.25*R_lower_arm_left_y_y);
  work.s1_83 = s1_82 + R_lower_arm_left_z_y*(0.8*R_lower_arm_left_z_y);
  work.s1_84 = R_lower_arm_left_z_y*s1_80 + R_lower_arm_left_y_y*s1_81;
  work.s1_85 = R_lower_arm_left_y_y*s1_80 - R_lower_arm_left_z_y*s1_81;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_86 = 3.6 + 0.16710914454277284*work.R_carrier_left_x_z;
  const double s1_87 = s1_86 - 0.003952802359882006*work.R_carrier_left_x_x;
  work.s1_88 = s1_87 - 0.07666666666666674*work.s1_13;
  const double s1_89 = 0.07666666666666674*work.R_carrier_left_aux2_y_y;
  const double s1_90 = 0.16710914454277284*work.R_carrier_left_y_z;
  const double s1_91 = 0.003952802359882006*work.R_carrier_left_y_x;
  work.s1_92 = work.r_carrier_left_aux1_y + s1_89 + s1_90 - s1_91;
  const double s1_93 = 0.07666666666666674*work.R_carrier_left_aux2_z_y;
  const double s1_94 = 0.16710914454277284*work.R_carrier_left_z_z;
  const double s1_95 = 0.003952802359882006*work.R_carrier_left_z_x;
  work.s1_96 = work.r_carrier_left_aux1_z + s1_93 + s1_94 - s1_95;
  const double s1_97 = 3.081700098328417*work.R_carrier_left_x_x;
  const double s1_98 = 0.04070875122910521*work.R_carrier_left_x_z;
  const double s1_99 = 0.039511111111111115*work.R_carrier_left_x_z;
  const double s1_100 = 0.05791111111111111*work.R_carrier_left_x_x;
  const double s1_101 = 3.1640788593903637*work.R_carrier_left_x_z;
  const double s1_102 = 0.04070875122910521*work.R_carrier_left_x_x;
  const double s1_103 = 0.04070875122910521*work.R_carrier_left_y_z;
  const double s1_104 = 3.081700098328417*work.R_carrier_left_y_x - s1_103;
  const double s1_105 = s1_104 - 0.05791111111111111*work.R_carrier_left_aux2_y_y;
  const double s1_106 = 2.6532900688298917*work.R_carrier_left_aux2_y_y;
  const double s1_107 = s1_106 - 0.039511111111111115*work.R_carrier_left_y_z;
  const double s1_108 = s1_107 - 0.05791111111111111*work.R_carrier_left_y_x;
  const double s1_109 = 0.04070875122910521*work.R_carrier_left_y_x;
  const double s1_110 = 3.1640788593903637*work.R_carrier_left_y_z - s1_109;
  const double s1_111 = s1_110 - 0.039511111111111115*work.R_carrier_left_aux2_y_y;
  const double s1_112 = 0.04070875122910521*work.R_carrier_left_z_z;
  const double s1_113 = 3.081700098328417*work.R_carrier_left_z_x - s1_112;
  const double s1_114 = s1_113 - 0.05791111111111111*work.R_carrier_left_aux2_z_y;
  const double s1_115 = 2.6532900688298917*work.R_carrier_left_aux2_z_y;
  const double s1_116 = s1_115 - 0.039511111111111115*work.R_carrier_left_z_z;
  const double s1_117 = s1_116 - 0.05791111111111111*work.R_carrier_left_z_x;
  const double s1_118 = 0.04070875122910521*work.R_carrier_left_z_x;
  const double s1_119 = 3.1640788593903637*work.R_carrier_left_z_z - s1_118;
  const double s1_120 = s1_119 - 0.039511111111111115*work.R_carrier_left_aux2_z_y;
  const double s1_121 = 0.039511111111111115*work.s1_13 + s1_101 - s1_102;
  const double s1_122 = work.s1_13*(2.6532900688298917*work.s1_13 + s1_99 + s1_100);
  const double s1_123 = work.R_carrier_left_x_x*(0.05791111111111111*work.s1_13 + s1_97 - s1_98);
  work.s1_124 = s1_122 + work.R_carrier_left_x_z*s1_121 + s1_123;
  const double s1_125 = work.R_carrier_left_aux2_y_y*s1_108 + work.R_carrier_left_y_z*s1_111;
  work.s1_126 = s1_125 + work.R_carrier_left_y_x*s1_105;
  const double s1_127 = work.R_carrier_left_aux2_z_y*s1_117 + work.R_carrier_left_z_z*s1_120;
  work.s1_128 = s1_127 + work.R_carrier_left_z_x*s1_114;
  const double s1_129 = work.R_carrier_left_x_z*s1_111 + work.R_carrier_left_x_x*s1_105;
  work.s1_130 = s1_129 - work.s1_13*s1_108;
  const double s1_131 = work.R_carrier_left_x_z*s1_120 + work.R_carrier_left_x_x*s1_114;
  work.s1_132 = s1_131 - work.s1_13*s1_117;
  const double s1_133 = work.R_carrier_left_aux2_y_y*s1_117 + work.R_carrier_left_y_z*s1_120;
  work.s1_134 = s1_133 + work.R_carrier_left_y_x*s1_114;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s1_135 = 6.0*work.R_carrier_left_y_x;
  const double s1_136 = 11.0*work.R_carrier_left_aux2_y_y;
  const double s1_137 = 6.0*work.R_carrier_left_y_z;
  const double s1_138 = 6.0*work.R_carrier_left_z_x;
  const double s1_139 = 11.0*work.R_carrier_left_aux2_z_y;
  const double s1_140 = 6.0*work.R_carrier_left_z_z;
  const double s1_141 = work.R_carrier_left_x_z*(6.0*work.R_carrier_left_x_z);
  const double s1_142 = work.R_carrier_left_x_x*(6.0*work.R_carrier_left_x_x);
  work.s1_143 = work.s1_13*(11.0*work.s1_13) + s1_141 + s1_142;
  const double s1_144 = work.R_carrier_left_aux2_y_y*s1_136 + work.R_carrier_left_y_z*s1_137;
  work.s1_145 = s1_144 + work.R_carrier_left_y_x*s1_135;
  const double s1_146 = work.R_carrier_left_aux2_z_y*s1_139 + work.R_carrier_left_z_z*s1_140;
  work.s1_147 = s1_146 + work.R_carrier_left_z_x*s1_138;
  const double s1_148 = work.R_carrier_left_x_z*s1_137 + work.R_carrier_left_x_x*s1_135;
  work.s1_149 = s1_148 - work.s1_13*s1_136;
  const double s1_150 = work.R_carrier_left_x_z*s1_140 + work.R_carrier_left_x_x*s1_138;
  work.s1_151 = s1_150 - work.s1_13*s1_139;
  const double s1_152 = work.R_carrier_left_aux2_y_y*s1_139 + work.R_carrier_left_y_z*s1_140;
  work.s1_153 = s1_152 + work.R_carrier_left_y_x*s1_138;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double R_upper_arm_left_z_y = work.sines[7];
  const double s1_154 = 0.5 + 0.15000000000000002*R_upper_arm_left_y_y;
  work.s1_155 = s1_154 + 0.010000000000000009*R_upper_arm_left_z_y;
  const double s1_156 = 0.15000000000000002*R_upper_arm_left_z_y - 0.28;
  work.s1_157 = s1_156 - 0.010000000000000009*R_upper_arm_left_y_y;
  const double s1_158 = 0.1*R_upper_arm_left_z_y;
  const double s1_159 = 0.25*R_upper_arm_left_y_y;
  const double s1_160 = R_upper_arm_left_z_y*(0.25*R_upper_arm_left_z_y);
  work.s1_161 = R_upper_arm_left_y_y*(0.1*R_upper_arm_left_y_y) + s1_160;
  work.s1_162 = R_upper_arm_left_z_y*s1_158 + R_upper_arm_left_y_y*s1_159;
  work.s1_163 = R_upper_arm_left_y_y*s1_158 - R_upper_arm_left_z_y*s1_159;
  // arb_front_left: arb_front_left, revolute, chassis
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s1_164 = 3.95 + 0.053846153846153884*R_arb_front_left_x_z;
  work.s1_165 = s1_164 - 0.1392307692307692*R_arb_front_left_x_x;
  const double s1_166 = 0.053846153846153884*R_arb_front_left_x_x - 0.5;
  work.s1_167 = s1_166 + 0.1392307692307692*R_arb_front_left_x_z;
  const double s1_168 = 0.003692307692307688*R_arb_front_left_x_z;
  const double s1_169 = 0.016246153846153844*R_arb_front_left_x_x;
  work.s1_170 = s1_169 - 0.00676923076923076*R_arb_front_left_x_z;
  const double s1_171 = 0.003692307692307688*R_arb_front_left_x_x;
  const double s1_172 = s1_171 - 0.18132307692307692*R_arb_front_left_x_z;
  const double s1_173 = 0.016246153846153844*R_arb_front_left_x_z;
  work.s1_174 = 0.00676923076923076*R_arb_front_left_x_x + s1_173;
  const double s1_175 = 0.23864615384615384*R_arb_front_left_x_x - s1_168;
  const double s1_176 = R_arb_front_left_x_z*(s1_171 + 0.23864615384615384*R_arb_front_left_x_z);
  const double s1_177 = R_arb_front_left_x_x*(s1_168 + 0.18132307692307692*R_arb_front_left_x_x);
  work.s1_178 = s1_176 + s1_177;
  work.s1_179 = R_arb_front_left_x_x*s1_175 - R_arb_front_left_x_z*s1_172;
  work.s1_180 = R_arb_front_left_x_z*s1_175 + R_arb_front_left_x_x*s1_172;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double s1_181 = 0.025000000000000022*R_lower_arm_right_z_y - 0.4;
  work.s1_182 = s1_181 - 0.21999999999999997*R_lower_arm_right_y_y;
  const double s1_183 = 0.62 + 0.21999999999999997*R_lower_arm_right_z_y;
  work.s1_184 = s1_183 + 0.025000000000000022*R_lower_arm_right_y_y;
  const double s1_185 = 0.25*R_lower_arm_right_z_y;
  const double s1_186 = 0.8*R_lower_arm_right_y_y;
  const double s1_187 = R_lower_arm_right_y_y*(0.25*R_lower_arm_right_y_y);
  work.s1_188 = s1_187 + R_lower_arm_right_z_y*(0.8*R_lower_arm_right_z_y);
  work.s1_189 = R_lower_arm_right_z_y*s1_185 + R_lower_arm_right_y_y*s1_186;
  work.s1_190 = R_lower_arm_right_y_y*s1_185 - R_lower_arm_right_z_y*s1_186;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_191 = 0.16710914454277284*work.R_carrier_right_x_z;
  const double s1_192 = 3.6 + 0.07666666666666674*work.s1_40 + s1_191;
  work.s1_193 = s1_192 - 0.003952802359882006*work.R_carrier_right_x_x;
  const double s1_194 = 0.16710914454277284*work.R_carrier_right_y_z;
  const double s1_195 = 0.003952802359882006*work.R_carrier_right_y_x;
  const double s1_196 = 0.07666666666666674*work.R_carrier_right_aux2_y_y;
  work.s1_197 = work.r_carrier_right_aux1_y + s1_194 - s1_195 - s1_196;
  const double s1_198 = 0.16710914454277284*work.R_carrier_right_z_z - work.s1_34;
  const double s1_199 = s1_198 - 0.003952802359882006*work.R_carrier_right_z_x;
  work.s1_200 = s1_199 - 0.07666666666666674*work.R_carrier_right_aux2_z_y;
  const double s1_201 = 0.04070875122910521*work.R_carrier_right_x_z;
  const double s1_202 = 3.081700098328417*work.R_carrier_right_x_x - s1_201;
  const double s1_203 = 0.039511111111111115*work.R_carrier_right_x_z;
  const double s1_204 = s1_203 + 0.05791111111111111*work.R_carrier_right_x_x;
  const double s1_205 = 0.04070875122910521*work.R_carrier_right_x_x;
  const double s1_206 = 3.1640788593903637*work.R_carrier_right_x_z - s1_205;
  const double s1_207 = 0.05791111111111111*work.R_carrier_right_aux2_y_y;
  const double s1_208 = s1_207 + 3.081700098328417*work.R_carrier_right_y_x;
  const double s1_209 = s1_208 - 0.04070875122910521*work.R_carrier_right_y_z;
  const double s1_210 = 2.6532900688298917*work.R_carrier_right_aux2_y_y;
  const double s1_211 = s1_210 + 0.039511111111111115*work.R_carrier_right_y_z;
  const double s1_212 = s1_211 + 0.05791111111111111*work.R_carrier_right_y_x;
  const double s1_213 = 0.039511111111111115*work.R_carrier_right_aux2_y_y;
  const double s1_214 = s1_213 + 3.1640788593903637*work.R_carrier_right_y_z;
  const double s1_215 = s1_214 - 0.04070875122910521*work.R_carrier_right_y_x;
  const double s1_216 = 0.05791111111111111*work.R_carrier_right_aux2_z_y;
  const double s1_217 = s1_216 + 3.081700098328417*work.R_carrier_right_z_x;
  const double s1_218 = s1_217 - 0.04070875122910521*work.R_carrier_right_z_z;
  const double s1_219 = 2.6532900688298917*work.R_carrier_right_aux2_z_y;
  const double s1_220 = s1_219 + 0.039511111111111115*work.R_carrier_right_z_z;
  const double s1_221 = s1_220 + 0.05791111111111111*work.R_carrier_right_z_x;
  const double s1_222 = 0.039511111111111115*work.R_carrier_right_aux2_z_y;
  const double s1_223 = s1_222 + 3.1640788593903637*work.R_carrier_right_z_z;
  const double s1_224 = s1_223 - 0.04070875122910521*work.R_carrier_right_z_x;
  const double s1_225 = work.R_carrier_right_x_z*(s1_206 - 0.039511111111111115*work.s1_40);
  const double s1_226 = work.R_carrier_right_x_x*(s1_202 - 0.05791111111111111*work.s1_40);
  work.s1_227 = s1_225 + s1_226 - work.s1_40*(s1_204 - 2.6532900688298917*work.s1_40);
  const double s1_228 = work.R_carrier_right_aux2_y_y*s1_212 + work.R_carrier_right_y_z*s1_215;
  work.s1_229 = s1_228 + work.R_carrier_right_y_x*s1_209;
  const double s1_230 = work.R_carrier_right_aux2_z_y*s1_221 + work.R_carrier_right_z_z*s1_224;
  work.s1_231 = s1_230 + work.R_carrier_right_z_x*s1_218;
  const double s1_232 = work.R_carrier_right_x_z*s1_215 + work.R_carrier_right_x_x*s1_209;
  work.s1_233 = s1_232 - work.s1_40*s1_212;
  const double s1_234 = work.R_carrier_right_x_z*s1_224 + work.R_carrier_right_x_x*s1_218;
  work.s1_235 = s1_234 - work.s1_40*s1_221;
  const double s1_236 = work.R_carrier_right_aux2_y_y*s1_221 + work.R_carrier_right_y_z*s1_224;
  work.s1_237 = s1_236 + work.R_carrier_right_y_x*s1_218;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s1_238 = 6.0*work.R_carrier_right_y_x;
  const double s1_239 = 11.0*work.R_carrier_right_aux2_y_y;
  const double s1_240 = 6.0*work.R_carrier_right_y_z;
  const double s1_241 = 6.0*work.R_carrier_right_z_x;
  const double s1_242 = 11.0*work.R_carrier_right_aux2_z_y;
  const double s1_243 = 6.0*work.R_carrier_right_z_z;
  const double s1_244 = work.R_carrier_right_x_z*(6.0*work.R_carrier_right_x_z);
  const double s1_245 = work.R_carrier_right_x_x*(6.0*work.R_carrier_right_x_x);
  work.s1_246 = work.s1_40*(11.0*work.s1_40) + s1_244 + s1_245;
  const double s1_247 = work.R_carrier_right_aux2_y_y*s1_239 + work.R_carrier_right_y_z*s1_240;
  work.s1_248 = s1_247 + work.R_carrier_right_y_x*s1_238;
  const double s1_249 = work.R_carrier_right_aux2_z_y*s1_242 + work.R_carrier_right_z_z*s1_243;
  work.s1_250 = s1_249 + work.R_carrier_right_z_x*s1_241;
  const double s1_251 = work.R_carrier_right_x_z*s1_240 + work.R_carrier_right_x_x*s1_238;
  work.s1_252 = s1_251 - work.s1_40*s1_239;
  const double s1_253 = work.R_carrier_right_x_z*s1_243 + work.R_carrier_right_x_x*s1_241;
  work.s1_254 = s1_253 - work.s1_40*s1_242;
  const double s1_255 = work.R_carrier_right_aux2_y_y*s1_242 + work.R_carrier_right_y_z*s1_243;
  work.s1_256 = s1_255 + work.R_carrier_right_y_x*s1_241;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s1_257 = 0.010000000000000009*R_upper_arm_right_z_y - 0.5;
  work.s1_258 = s1_257 - 0.15000000000000002*R_upper_arm_right_y_y;
  const double s1_259 = 0.28 + 0.15000000000000002*R_upper_arm_right_z_y;
  work.s1_260 = s1_259 + 0.010000000000000009*R_upper_arm_right_y_y;
  const double s1_261 = 0.1*R_upper_arm_right_z_y;
  const double s1_262 = 0.25*R_upper_arm_right_y_y;
  const double s1_263 = R_upper_arm_right_z_y*(0.25*R_upper_arm_right_z_y);
  work.s1_264 = R_upper_arm_right_y_y*(0.1*R_upper_arm_right_y_y) + s1_263;
  work.s1_265 = R_upper_arm_right_z_y*s1_261 + R_upper_arm_right_y_y*s1_262;
  work.s1_266 = R_upper_arm_right_y_y*s1_261 - R_upper_arm_right_z_y*s1_262;
  // arb_front_right: arb_front_right, revolute, chassis
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s1_267 = 3.95 + 0.053846153846153884*R_arb_front_right_x_z;
  work.s1_268 = s1_267 - 0.1392307692307692*R_arb_front_right_x_x;
  const double s1_269 = 0.053846153846153884*R_arb_front_right_x_x - 0.5;
  work.s1_270 = s1_269 + 0.1392307692307692*R_arb_front_right_x_z;
  const double s1_271 = 0.003692307692307688*R_arb_front_right_x_z;
  const double s1_272 = 0.016246153846153844*R_arb_front_right_x_x;
  work.s1_273 = 0.00676923076923076*R_arb_front_right_x_z - s1_272;
  const double s1_274 = 0.003692307692307688*R_arb_front_right_x_x;
  const double s1_275 = s1_274 - 0.18132307692307692*R_arb_front_right_x_z;
  const double s1_276 = 0.016246153846153844*R_arb_front_right_x_z;
  work.s1_277 = 0.00676923076923076*R_arb_front_right_x_x + s1_276;
  const double s1_278 = 0.23864615384615384*R_arb_front_right_x_x - s1_271;
  const double s1_279 = s1_274 + 0.23864615384615384*R_arb_front_right_x_z;
  const double s1_280 = s1_271 + 0.18132307692307692*R_arb_front_right_x_x;
  work.s1_281 = R_arb_front_right_x_z*s1_279 + R_arb_front_right_x_x*s1_280;
  work.s1_282 = R_arb_front_right_x_x*s1_278 - R_arb_front_right_x_z*s1_275;
  work.s1_283 = R_arb_front_right_x_z*s1_278 + R_arb_front_right_x_x*s1_275;
  // pitman_arm: pitman_arm, revolute, chassis
  const double R_pitman_arm_x_z = work.sines[15];
  work.s1_284 = 4.4 - 0.14666666666666664*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = work.cosines[15];
  work.s1_285 = 0.4 + 0.14666666666666664*R_pitman_arm_x_x;
  const double s1_286 = 0.0742*R_pitman_arm_x_z;
  const double s1_287 = 0.03*R_pitman_arm_x_x;
  const double s1_288 = R_pitman_arm_x_x*(0.0742*R_pitman_arm_x_x);
  work.s1_289 = R_pitman_arm_x_z*(0.03*R_pitman_arm_x_z) + s1_288;
  work.s1_290 = R_pitman_arm_x_x*s1_287 + R_pitman_arm_x_z*s1_286;
  work.s1_291 = R_pitman_arm_x_z*s1_287 - R_pitman_arm_x_x*s1_286;
  // bell_crank: bell_crank, revolute, chassis
  const double R_bell_crank_x_x = work.cosines[16];
  const double R_bell_crank_y_x = work.sines[16];
  const double s1_292 = 0.09720000000000001*R_bell_crank_x_x;
  work.s1_293 = s1_292 - 0.09380000000000002*R_bell_crank_y_x;
  const double s1_294 = 3.25 - 0.09720000000000001*R_bell_crank_y_x;
  work.s1_295 = s1_294 - 0.09380000000000002*R_bell_crank_x_x;
  const double s1_296 = 0.10155600000000002*R_bell_crank_y_x;
  const double s1_297 = 0.10155600000000002*R_bell_crank_x_x;
  const double s1_298 = 0.2800026666666667*R_bell_crank_y_x - s1_297;
  const double s1_299 = 0.14412600000000006*R_bell_crank_x_x - s1_296;
  const double s1_300 = R_bell_crank_y_x*(s1_297 + 0.14412600000000006*R_bell_crank_y_x);
  work.s1_301 = s1_300 + R_bell_crank_x_x*(s1_296 + 0.2800026666666667*R_bell_crank_x_x);
  work.s1_302 = R_bell_crank_x_x*s1_299 + R_bell_crank_y_x*s1_298;
  work.s1_303 = R_bell_crank_x_x*s1_298 - R_bell_crank_y_x*s1_299;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_304 = work.r_rear_axle_aux1_x + 0.0019465977605512485*work.R_rear_axle_x_z;
  work.s1_305 = s1_304 + 0.00017226528854435476*work.R_rear_axle_aux5_x_x;
  const double s1_306 = z_rear_axle_ty + 0.0019465977605512485*work.R_rear_axle_y_z;
  work.s1_307 = s1_306 + 0.00017226528854435476*work.R_rear_axle_aux5_y_x;
  const double s1_308 = work.r_rear_axle_aux3_z + 0.0019465977605512485*work.R_rear_axle_z_z;
  work.s1_309 = s1_308 - 0.00017226528854435476*s1_58;
  const double s1_310 = 264.98720045937415*work.R_rear_axle_aux5_x_x;
  const double s1_311 = 0.02174045363192678*work.R_rear_axle_aux5_x_x;
  const double s1_312 = 264.98720045937415*work.R_rear_axle_aux5_y_x;
  const double s1_313 = s1_312 - 0.02174045363192678*work.R_rear_axle_y_z;
  const double s1_314 = 45.96384415733562*work.R_rear_axle_y_y;
  const double s1_315 = 0.02174045363192678*work.R_rear_axle_aux5_y_x;
  const double s1_316 = 264.4099770312949*work.R_rear_axle_y_z - s1_315;
  const double s1_317 = 0.02174045363192678*work.R_rear_axle_z_z + 264.98720045937415*s1_58;
  const double s1_318 = 45.96384415733562*work.R_rear_axle_z_y;
  const double s1_319 = 264.4099770312949*work.R_rear_axle_z_z + 0.02174045363192678*s1_58;
  const double s1_320 = work.R_rear_axle_x_z*(264.4099770312949*work.R_rear_axle_x_z - s1_311);
  const double s1_321 = s1_310 - 0.02174045363192678*work.R_rear_axle_x_z;
  const double s1_322 = work.R_rear_axle_x_y*(45.96384415733562*work.R_rear_axle_x_y) + s1_320;
  work.s1_323 = s1_322 + work.R_rear_axle_aux5_x_x*s1_321;
  const double s1_324 = work.R_rear_axle_y_y*s1_314 + work.R_rear_axle_y_z*s1_316;
  work.s1_325 = s1_324 + work.R_rear_axle_aux5_y_x*s1_313;
  work.s1_326 = work.R_rear_axle_z_y*s1_318 + work.R_rear_axle_z_z*s1_319 + s1_58*s1_317;
  const double s1_327 = work.R_rear_axle_x_y*s1_314 + work.R_rear_axle_x_z*s1_316;
  work.s1_328 = s1_327 + work.R_rear_axle_aux5_x_x*s1_313;
  const double s1_329 = work.R_rear_axle_x_y*s1_318 + work.R_rear_axle_x_z*s1_319;
  work.s1_330 = s1_329 - work.R_rear_axle_aux5_x_x*s1_317;
  const double s1_331 = work.R_rear_axle_y_y*s1_318 + work.R_rear_axle_y_z*s1_319;
  work.s1_332 = s1_331 - work.R_rear_axle_aux5_y_x*s1_317;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s1_333 = 14.0*work.R_rear_axle_aux5_y_x;
  const double s1_334 = 22.0*work.R_rear_axle_y_y;
  const double s1_335 = 14.0*work.R_rear_axle_y_z;
  const double s1_336 = 14.0*s1_58;
  const double s1_337 = 22.0*work.R_rear_axle_z_y;
  const double s1_338 = 14.0*work.R_rear_axle_z_z;
  const double s1_339 = work.R_rear_axle_x_y*(22.0*work.R_rear_axle_x_y);
  const double s1_340 = work.R_rear_axle_aux5_x_x*(14.0*work.R_rear_axle_aux5_x_x);
  work.s1_341 = s1_339 + work.R_rear_axle_x_z*(14.0*work.R_rear_axle_x_z) + s1_340;
  const double s1_342 = work.R_rear_axle_y_y*s1_334 + work.R_rear_axle_y_z*s1_335;
  work.s1_343 = s1_342 + work.R_rear_axle_aux5_y_x*s1_333;
  work.s1_344 = work.R_rear_axle_z_y*s1_337 + work.R_rear_axle_z_z*s1_338 + s1_58*s1_336;
  const double s1_345 = work.R_rear_axle_x_y*s1_334 + work.R_rear_axle_x_z*s1_335;
  work.s1_346 = s1_345 + work.R_rear_axle_aux5_x_x*s1_333;
  const double s1_347 = work.R_rear_axle_x_y*s1_337 + work.R_rear_axle_x_z*s1_338;
  work.s1_348 = s1_347 - work.R_rear_axle_aux5_x_x*s1_336;
  const double s1_349 = work.R_rear_axle_y_y*s1_337 + work.R_rear_axle_y_z*s1_338;
  work.s1_350 = s1_349 - work.R_rear_axle_aux5_y_x*s1_336;
}

/// Part 2 of compute_outputs: step 1: poses, axes b, accumulated inertias MR (50); step 4:
/// velocities Z (36); step 7: accelerations Zdot and accumulated forces QR - PR (51), (52); step 9:
/// independent and all accelerations (63), (62).
[[gnu::noinline]] void compute_outputs_2(const State& state, const double* tau,
    OutputsWork& __restrict work) noexcept {
  // --- step 1: poses, axes b, accumulated inertias MR (50), continued ---
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double R_arb_rear_left_x_x = work.cosines[20];
  const double s1_351 = 0.16538461538461574*R_arb_rear_left_x_x - 3.3000000000000003;
  const double R_arb_rear_left_x_z = work.sines[20];
  const double s1_352 = 0.44999999999999996 + 0.16538461538461574*R_arb_rear_left_x_z;
  const double s1_353 = 0.012307692307692316*R_arb_rear_left_x_x;
  const double s1_354 = 0.15615384615384614*R_arb_rear_left_x_z;
  const double s1_355 = 0.012307692307692316*R_arb_rear_left_x_z;
  const double s1_356 = 0.23076923076923084*R_arb_rear_left_x_x;
  const double s1_357 = R_arb_rear_left_x_z*(0.23076923076923084*R_arb_rear_left_x_z);
  const double s1_358 = s1_357 + R_arb_rear_left_x_x*(0.15615384615384614*R_arb_rear_left_x_x);
  const double s1_359 = R_arb_rear_left_x_x*s1_356 + R_arb_rear_left_x_z*s1_354;
  const double s1_360 = R_arb_rear_left_x_z*s1_356 - R_arb_rear_left_x_x*s1_354;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double R_arb_rear_right_x_x = work.cosines[21];
  const double s1_361 = 0.16538461538461574*R_arb_rear_right_x_x - 3.3000000000000003;
  const double R_arb_rear_right_x_z = work.sines[21];
  const double s1_362 = 0.44999999999999996 + 0.16538461538461574*R_arb_rear_right_x_z;
  const double s1_363 = 0.012307692307692316*R_arb_rear_right_x_x;
  const double s1_364 = 0.15615384615384614*R_arb_rear_right_x_z;
  const double s1_365 = 0.012307692307692316*R_arb_rear_right_x_z;
  const double s1_366 = 0.23076923076923084*R_arb_rear_right_x_x;
  const double s1_367 = R_arb_rear_right_x_z*(0.23076923076923084*R_arb_rear_right_x_z);
  const double s1_368 = s1_367 + R_arb_rear_right_x_x*(0.15615384615384614*R_arb_rear_right_x_x);
  const double s1_369 = R_arb_rear_right_x_x*s1_366 + R_arb_rear_right_x_z*s1_364;
  const double s1_370 = R_arb_rear_right_x_z*s1_366 - R_arb_rear_right_x_x*s1_364;
  // arb_link_front_left
  const double s1_371 = 0.02999999999999997*work.R_carrier_left_x_z;
  const double s1_372 = 3.6 + 0.030000000000000027*work.s1_13 + s1_371;
  work.s1_373 = s1_372 + 0.1*work.R_carrier_left_x_x;
  const double s1_374 = work.r_carrier_left_aux1_y + 0.02999999999999997*work.R_carrier_left_y_z;
  const double s1_375 = 0.030000000000000027*work.R_carrier_left_aux2_y_y;
  work.s1_376 = s1_374 + 0.1*work.R_carrier_left_y_x - s1_375;
  const double s1_377 = work.r_carrier_left_aux1_z + 0.02999999999999997*work.R_carrier_left_z_z;
  const double s1_378 = 0.030000000000000027*work.R_carrier_left_aux2_z_y;
  work.s1_379 = s1_377 + 0.1*work.R_carrier_left_z_x - s1_378;
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s1_380 = 3.95 + 0.09999999999999998*R_arb_front_left_x_z;
  work.s1_381 = s1_380 - 0.24999999999999997*R_arb_front_left_x_x;
  const double s1_382 = 0.09999999999999998*R_arb_front_left_x_x - 0.5;
  work.s1_383 = s1_382 + 0.24999999999999997*R_arb_front_left_x_z;
  // arb_link_front_right
  const double s1_384 = 3.6 + 0.02999999999999997*work.R_carrier_right_x_z;
  work.s1_385 = s1_384 + 0.1*work.R_carrier_right_x_x - 0.030000000000000027*work.s1_40;
  const double s1_386 = 0.030000000000000027*work.R_carrier_right_aux2_y_y;
  const double s1_387 = 0.02999999999999997*work.R_carrier_right_y_z;
  const double s1_388 = work.r_carrier_right_aux1_y + s1_386 + s1_387;
  work.s1_389 = s1_388 + 0.1*work.R_carrier_right_y_x;
  const double s1_390 = 0.030000000000000027*work.R_carrier_right_aux2_z_y - work.s1_34;
  const double s1_391 = s1_390 + 0.02999999999999997*work.R_carrier_right_z_z;
  work.s1_392 = s1_391 + 0.1*work.R_carrier_right_z_x;
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s1_393 = 3.95 + 0.09999999999999998*R_arb_front_right_x_z;
  work.s1_394 = s1_393 - 0.24999999999999997*R_arb_front_right_x_x;
  const double s1_395 = 0.09999999999999998*R_arb_front_right_x_x - 0.5;
  work.s1_396 = s1_395 + 0.24999999999999997*R_arb_front_right_x_z;
  // drag_link
  const double R_bell_crank_x_x = work.cosines[16];
  work.s1_397 = 0.3*R_bell_crank_x_x;
  const double R_bell_crank_y_x = work.sines[16];
  work.s1_398 = 3.25 - 0.3*R_bell_crank_y_x;
  work.s1_399 = 4.4 - 0.21999999999999997*work.sines[15];
  work.s1_400 = 0.4 + 0.21999999999999997*work.cosines[15];
  // tie_rod_left
  const double s1_401 = 3.6 + 0.04999999999999993*work.s1_13 + 0.07*work.R_carrier_left_x_z;
  work.s1_402 = s1_401 - 0.22*work.R_carrier_left_x_x;
  const double s1_403 = work.r_carrier_left_aux1_y + 0.07*work.R_carrier_left_y_z;
  const double s1_404 = 0.04999999999999993*work.R_carrier_left_aux2_y_y;
  work.s1_405 = s1_403 - 0.22*work.R_carrier_left_y_x - s1_404;
  const double s1_406 = work.r_carrier_left_aux1_z + 0.07*work.R_carrier_left_z_z;
  const double s1_407 = 0.04999999999999993*work.R_carrier_left_aux2_z_y;
  work.s1_408 = s1_406 - 0.22*work.R_carrier_left_z_x - s1_407;
  const double s1_409 = 0.08*R_bell_crank_y_x;
  const double s1_410 = 0.20000000000000007*R_bell_crank_x_x;
  const double s1_411 = 0.08*R_bell_crank_x_x;
  const double s1_412 = 0.20000000000000007*R_bell_crank_y_x;
  work.s1_413 = s1_411 - s1_412;
  work.s1_414 = 3.25 - s1_409 - s1_410;
  // tie_rod_right
  const double s1_415 = 3.6 + 0.07*work.R_carrier_right_x_z - 0.22*work.R_carrier_right_x_x;
  work.s1_416 = s1_415 - 0.04999999999999993*work.s1_40;
  const double s1_417 = 0.04999999999999993*work.R_carrier_right_aux2_y_y;
  const double s1_418 = work.r_carrier_right_aux1_y + s1_417 + 0.07*work.R_carrier_right_y_z;
  work.s1_419 = s1_418 - 0.22*work.R_carrier_right_y_x;
  const double s1_420 = 0.04999999999999993*work.R_carrier_right_aux2_z_y - work.s1_34;
  work.s1_421 = s1_420 + 0.07*work.R_carrier_right_z_z - 0.22*work.R_carrier_right_z_x;
  work.s1_422 = s1_411 + s1_412;
  work.s1_423 = 3.25 + (s1_409 - s1_410);
  // long_rod_left
  const double s1_424 = 0.55*work.R_rear_axle_x_y;
  const double s1_425 = 0.04999999999999982*work.R_rear_axle_aux5_x_x;
  const double s1_426 = 0.55*work.R_rear_axle_y_y;
  const double s1_427 = 0.04999999999999982*work.R_rear_axle_aux5_y_x;
  const double s1_428 = 0.55*work.R_rear_axle_z_y;
  const double s1_58 = work.sines[18];
  const double s1_429 = 0.08000000000000002*work.R_rear_axle_z_z + 0.04999999999999982*s1_58;
  const double s1_430 = s1_425 - 0.08000000000000002*work.R_rear_axle_x_z;
  const double s1_431 = work.r_rear_axle_aux1_x + s1_430;
  work.s1_432 = s1_424 + s1_431;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s1_433 = z_rear_axle_ty + (s1_427 - 0.08000000000000002*work.R_rear_axle_y_z);
  work.s1_434 = s1_426 + s1_433;
  work.s1_435 = work.r_rear_axle_aux3_z + s1_428 - s1_429;
  // diag_rod_left
  const double s1_436 = 0.1*work.R_rear_axle_x_y;
  const double s1_437 = 0.1*work.R_rear_axle_y_y;
  const double s1_438 = 0.1*work.R_rear_axle_z_y;
  const double s1_439 = work.r_rear_axle_aux1_x + 0.25*work.R_rear_axle_x_z;
  work.s1_440 = s1_436 + s1_439;
  const double s1_441 = z_rear_axle_ty + 0.25*work.R_rear_axle_y_z;
  work.s1_442 = s1_437 + s1_441;
  const double s1_443 = work.r_rear_axle_aux3_z + 0.25*work.R_rear_axle_z_z;
  work.s1_444 = s1_438 + s1_443;
  // arb_link_rear_left
  const double s1_445 = 0.6*work.R_rear_axle_x_y;
  const double s1_446 = 0.35000000000000053*work.R_rear_axle_aux5_x_x;
  const double s1_447 = 0.15000000000000002*work.R_rear_axle_x_z + s1_446;
  const double s1_448 = 0.6*work.R_rear_axle_y_y;
  const double s1_449 = 0.35000000000000053*work.R_rear_axle_aux5_y_x;
  const double s1_450 = 0.15000000000000002*work.R_rear_axle_y_z + s1_449;
  const double s1_451 = 0.6*work.R_rear_axle_z_y;
  work.s1_452 = work.r_rear_axle_aux1_x + s1_445 - s1_447;
  work.s1_453 = z_rear_axle_ty + s1_448 - s1_450;
  const double s1_454 = 0.35000000000000053*s1_58 - 0.15000000000000002*work.R_rear_axle_z_z;
  const double s1_455 = work.r_rear_axle_aux3_z + s1_454;
  work.s1_456 = s1_451 + s1_455;
  work.s1_457 = 0.35000000000000053*R_arb_rear_left_x_x - 3.3000000000000003;
  work.s1_458 = 0.44999999999999996 + 0.35000000000000053*R_arb_rear_left_x_z;
  // long_rod_right
  work.s1_459 = s1_431 - s1_424;
  work.s1_460 = s1_433 - s1_426;
  work.s1_461 = work.r_rear_axle_aux3_z - s1_428 - s1_429;
  // diag_rod_right
  work.s1_462 = s1_439 - s1_436;
  work.s1_463 = s1_441 - s1_437;
  work.s1_464 = s1_443 - s1_438;
  // arb_link_rear_right
  work.s1_465 = work.r_rear_axle_aux1_x - s1_445 - s1_447;
  work.s1_466 = z_rear_axle_ty - s1_448 - s1_450;
  work.s1_467 = s1_455 - s1_451;
  work.s1_468 = 0.35000000000000053*R_arb_rear_right_x_x - 3.3000000000000003;
  work.s1_469 = 0.44999999999999996 + 0.35000000000000053*R_arb_rear_right_x_z;
  // operations: 397 add, 629 multiply, 44 sin cos

  // --- step 4: velocities Z (36) ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double zd_chassis_tx = state.zd[Coordinate::chassis_tx];
  const double zd_chassis_ty = state.zd[Coordinate::chassis_ty];
  const double s4_1 = zd_chassis_tx*work.R_chassis_aux5_x_x;
  const double zd_chassis_tz = state.zd[Coordinate::chassis_tz];
  const double s1_3 = work.sines[1];
  work.v_chassis_x = s4_1 + zd_chassis_ty*work.R_chassis_aux5_y_x - zd_chassis_tz*s1_3;
  const double s4_2 = zd_chassis_tx*work.R_chassis_x_y + zd_chassis_ty*work.R_chassis_y_y;
  work.v_chassis_y = s4_2 + zd_chassis_tz*work.R_chassis_z_y;
  const double s4_3 = zd_chassis_tx*work.R_chassis_x_z + zd_chassis_ty*work.R_chassis_y_z;
  work.v_chassis_z = s4_3 + zd_chassis_tz*work.R_chassis_z_z;
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  work.w_chassis_y = zd_chassis_rz*work.R_chassis_z_y + zd_chassis_ry*work.cosines[2];
  work.w_chassis_z = zd_chassis_rz*work.R_chassis_z_z - zd_chassis_ry*work.sines[2];
  const double zd_chassis_rx = state.zd[Coordinate::chassis_rx];
  work.w_chassis_x = zd_chassis_rx - zd_chassis_rz*s1_3;
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double v_lower_arm_left_y = work.v_chassis_y - 0.62*zd_lower_arm_left;
  const double v_lower_arm_left_z = work.v_chassis_z - 0.4*zd_lower_arm_left;
  work.w_lower_arm_left_x = zd_lower_arm_left + work.w_chassis_x;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  const double v_carrier_left_aux1_x = work.v_chassis_x +
      zd_carrier_left_rz*work.b_carrier_left_rz_x;
  const double v_carrier_left_aux1_y = v_lower_arm_left_y - zd_carrier_left_rz*work.s1_10;
  const double v_carrier_left_aux1_z = v_lower_arm_left_z - zd_carrier_left_rz*work.s1_11;
  const double w_carrier_left_aux1_y = work.w_chassis_y - zd_carrier_left_rz*work.sines[3];
  const double w_carrier_left_aux1_z = work.w_chassis_z + zd_carrier_left_rz*work.cosines[3];
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  const double v_carrier_left_aux2_x = v_carrier_left_aux1_x +
      zd_carrier_left_rx*work.b_carrier_left_rx_x;
  const double v_carrier_left_aux2_y = v_carrier_left_aux1_y +
      zd_carrier_left_rx*work.b_carrier_left_rx_y;
  const double v_carrier_left_aux2_z = v_carrier_left_aux1_z +
      zd_carrier_left_rx*work.b_carrier_left_rx_z;
  const double w_carrier_left_aux2_x = work.w_lower_arm_left_x + zd_carrier_left_rx*work.cosines[4];
  const double w_carrier_left_aux2_y = w_carrier_left_aux1_y +
      zd_carrier_left_rx*work.R_carrier_left_aux1_y_x;
  const double w_carrier_left_aux2_z = w_carrier_left_aux1_z +
      zd_carrier_left_rx*work.R_carrier_left_aux1_z_x;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  work.v_carrier_left_x = v_carrier_left_aux2_x + zd_carrier_left_ry*work.b_carrier_left_ry_x;
  work.v_carrier_left_y = v_carrier_left_aux2_y - zd_carrier_left_ry*work.s1_22;
  work.v_carrier_left_z = v_carrier_left_aux2_z + zd_carrier_left_ry*work.b_carrier_left_ry_z;
  work.w_carrier_left_x = w_carrier_left_aux2_x - zd_carrier_left_ry*work.s1_13;
  work.w_carrier_left_y = w_carrier_left_aux2_y + zd_carrier_left_ry*work.R_carrier_left_aux2_y_y;
  work.w_carrier_left_z = w_carrier_left_aux2_z + zd_carrier_left_ry*work.R_carrier_left_aux2_z_y;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double zd_wheel_front_left = state.zd[Coordinate::wheel_front_left];
  const double v_wheel_front_left_x = work.v_carrier_left_x +
      zd_wheel_front_left*work.b_wheel_front_left_x;
  const double v_wheel_front_left_y = work.v_carrier_left_y - zd_wheel_front_left*work.s1_30;
  const double v_wheel_front_left_z = work.v_carrier_left_z +
      zd_wheel_front_left*work.b_wheel_front_left_z;
  work.w_wheel_front_left_x = work.w_carrier_left_x - zd_wheel_front_left*work.s1_13;
  work.w_wheel_front_left_y = work.w_carrier_left_y +
      zd_wheel_front_left*work.R_carrier_left_aux2_y_y;
  work.w_wheel_front_left_z = work.w_carrier_left_z +
      zd_wheel_front_left*work.R_carrier_left_aux2_z_y;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  const double v_upper_arm_left_y = work.v_chassis_y - 0.28*zd_upper_arm_left;
  const double v_upper_arm_left_z = work.v_chassis_z - 0.5*zd_upper_arm_left;
  work.w_upper_arm_left_x = zd_upper_arm_left + work.w_chassis_x;
  // arb_front_left: arb_front_left, revolute, chassis
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  work.v_arb_front_left_x = work.v_chassis_x + 0.5*zd_arb_front_left;
  work.v_arb_front_left_z = work.v_chassis_z + 3.95*zd_arb_front_left;
  work.w_arb_front_left_y = zd_arb_front_left + work.w_chassis_y;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double v_lower_arm_right_y = work.v_chassis_y - 0.62*zd_lower_arm_right;
  const double v_lower_arm_right_z = work.v_chassis_z + 0.4*zd_lower_arm_right;
  work.w_lower_arm_right_x = zd_lower_arm_right + work.w_chassis_x;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  const double v_carrier_right_aux1_x = work.v_chassis_x +
      zd_carrier_right_rz*work.b_carrier_right_rz_x;
  const double v_carrier_right_aux1_y = v_lower_arm_right_y - zd_carrier_right_rz*work.s1_37;
  const double v_carrier_right_aux1_z = v_lower_arm_right_z - zd_carrier_right_rz*work.s1_38;
  const double w_carrier_right_aux1_y = work.w_chassis_y - zd_carrier_right_rz*work.sines[9];
  const double w_carrier_right_aux1_z = work.w_chassis_z + zd_carrier_right_rz*work.cosines[9];
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  const double v_carrier_right_aux2_x = v_carrier_right_aux1_x +
      zd_carrier_right_rx*work.b_carrier_right_rx_x;
  const double v_carrier_right_aux2_y = v_carrier_right_aux1_y - zd_carrier_right_rx*work.s1_44;
  const double v_carrier_right_aux2_z = v_carrier_right_aux1_z +
      zd_carrier_right_rx*work.b_carrier_right_rx_z;
  const double w_carrier_right_aux2_x = work.w_lower_arm_right_x +
      zd_carrier_right_rx*work.cosines[10];
  const double s4_4 = zd_carrier_right_rx*work.R_carrier_right_aux1_y_x;
  const double w_carrier_right_aux2_y = w_carrier_right_aux1_y + s4_4;
  const double s4_5 = zd_carrier_right_rx*work.R_carrier_right_aux1_z_x;
  const double w_carrier_right_aux2_z = w_carrier_right_aux1_z + s4_5;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  work.v_carrier_right_x = v_carrier_right_aux2_x + zd_carrier_right_ry*work.b_carrier_right_ry_x;
  work.v_carrier_right_y = v_carrier_right_aux2_y + zd_carrier_right_ry*work.b_carrier_right_ry_y;
  work.v_carrier_right_z = v_carrier_right_aux2_z + zd_carrier_right_ry*work.b_carrier_right_ry_z;
  work.w_carrier_right_x = w_carrier_right_aux2_x - zd_carrier_right_ry*work.s1_40;
  const double s4_6 = zd_carrier_right_ry*work.R_carrier_right_aux2_y_y;
  work.w_carrier_right_y = w_carrier_right_aux2_y + s4_6;
  const double s4_7 = zd_carrier_right_ry*work.R_carrier_right_aux2_z_y;
  work.w_carrier_right_z = w_carrier_right_aux2_z + s4_7;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double zd_wheel_front_right = state.zd[Coordinate::wheel_front_right];
  const double v_wheel_front_right_x = work.v_carrier_right_x +
      zd_wheel_front_right*work.b_wheel_front_right_x;
  const double v_wheel_front_right_y = work.v_carrier_right_y - zd_wheel_front_right*work.s1_56;
  const double v_wheel_front_right_z = work.v_carrier_right_z +
      zd_wheel_front_right*work.b_wheel_front_right_z;
  work.w_wheel_front_right_x = work.w_carrier_right_x - zd_wheel_front_right*work.s1_40;
  const double s4_8 = zd_wheel_front_right*work.R_carrier_right_aux2_y_y;
  work.w_wheel_front_right_y = work.w_carrier_right_y + s4_8;
  const double s4_9 = zd_wheel_front_right*work.R_carrier_right_aux2_z_y;
  work.w_wheel_front_right_z = work.w_carrier_right_z + s4_9;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  const double v_upper_arm_right_y = work.v_chassis_y - 0.28*zd_upper_arm_right;
  const double v_upper_arm_right_z = work.v_chassis_z + 0.5*zd_upper_arm_right;
  work.w_upper_arm_right_x = zd_upper_arm_right + work.w_chassis_x;
  // arb_front_right: arb_front_right, revolute, chassis
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  work.v_arb_front_right_x = work.v_chassis_x + 0.5*zd_arb_front_right;
  work.v_arb_front_right_z = work.v_chassis_z + 3.95*zd_arb_front_right;
  work.w_arb_front_right_y = zd_arb_front_right + work.w_chassis_y;
  // pitman_arm: pitman_arm, revolute, chassis
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double v_pitman_arm_x = work.v_chassis_x + 0.4*zd_pitman_arm;
  const double v_pitman_arm_z = work.v_chassis_z + 4.4*zd_pitman_arm;
  work.w_pitman_arm_y = zd_pitman_arm + work.w_chassis_y;
  // bell_crank: bell_crank, revolute, chassis
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double v_bell_crank_y = work.v_chassis_y - 3.25*zd_bell_crank;
  work.w_bell_crank_z = zd_bell_crank + work.w_chassis_z;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  const double v_rear_axle_aux1_x = state.zd[Coordinate::rear_axle_tx] + work.v_chassis_x;
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  const double v_rear_axle_aux2_y = state.zd[Coordinate::rear_axle_ty] + work.v_chassis_y;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double v_rear_axle_aux3_z = state.zd[Coordinate::rear_axle_tz] + work.v_chassis_z;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  const double v_rear_axle_aux4_x = v_rear_axle_aux1_x + z_rear_axle_ty*zd_rear_axle_rz;
  const double v_rear_axle_aux4_y = v_rear_axle_aux2_y - zd_rear_axle_rz*work.r_rear_axle_aux1_x;
  const double w_rear_axle_aux4_z = zd_rear_axle_rz + work.w_chassis_z;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  const double v_rear_axle_aux5_x = v_rear_axle_aux4_x - zd_rear_axle_ry*work.s1_59;
  const double v_rear_axle_aux5_y = v_rear_axle_aux4_y - zd_rear_axle_ry*work.s1_60;
  const double v_rear_axle_aux5_z = v_rear_axle_aux3_z + zd_rear_axle_ry*work.b_rear_axle_ry_z;
  const double w_rear_axle_aux5_x = work.w_chassis_x - zd_rear_axle_ry*work.sines[17];
  const double w_rear_axle_aux5_y = work.w_chassis_y + zd_rear_axle_ry*work.cosines[17];
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  work.v_rear_axle_x = v_rear_axle_aux5_x - zd_rear_axle_rx*work.s1_64;
  work.v_rear_axle_y = v_rear_axle_aux5_y + zd_rear_axle_rx*work.b_rear_axle_rx_y;
  work.v_rear_axle_z = v_rear_axle_aux5_z + zd_rear_axle_rx*work.b_rear_axle_rx_z;
  work.w_rear_axle_x = w_rear_axle_aux5_x + zd_rear_axle_rx*work.R_rear_axle_aux5_x_x;
  work.w_rear_axle_y = w_rear_axle_aux5_y + zd_rear_axle_rx*work.R_rear_axle_aux5_y_x;
  work.w_rear_axle_z = w_rear_axle_aux4_z - zd_rear_axle_rx*s1_58;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double zd_wheel_rear_left = state.zd[Coordinate::wheel_rear_left];
  const double v_wheel_rear_left_x = work.v_rear_axle_x +
      zd_wheel_rear_left*work.b_wheel_rear_left_x;
  const double v_wheel_rear_left_y = work.v_rear_axle_y +
      zd_wheel_rear_left*work.b_wheel_rear_left_y;
  const double v_wheel_rear_left_z = work.v_rear_axle_z +
      zd_wheel_rear_left*work.b_wheel_rear_left_z;
  work.w_wheel_rear_left_x = work.w_rear_axle_x + zd_wheel_rear_left*work.R_rear_axle_x_y;
  work.w_wheel_rear_left_y = work.w_rear_axle_y + zd_wheel_rear_left*work.R_rear_axle_y_y;
  work.w_wheel_rear_left_z = work.w_rear_axle_z + zd_wheel_rear_left*work.R_rear_axle_z_y;
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  work.v_arb_rear_left_x = work.v_chassis_x + 0.44999999999999996*zd_arb_rear_left;
  work.v_arb_rear_left_z = work.v_chassis_z - 3.3000000000000003*zd_arb_rear_left;
  work.w_arb_rear_left_y = zd_arb_rear_left + work.w_chassis_y;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double zd_wheel_rear_right = state.zd[Coordinate::wheel_rear_right];
  const double v_wheel_rear_right_x = work.v_rear_axle_x +
      zd_wheel_rear_right*work.b_wheel_rear_right_x;
  const double v_wheel_rear_right_y = work.v_rear_axle_y +
      zd_wheel_rear_right*work.b_wheel_rear_right_y;
  const double v_wheel_rear_right_z = work.v_rear_axle_z +
      zd_wheel_rear_right*work.b_wheel_rear_right_z;
  work.w_wheel_rear_right_x = work.w_rear_axle_x + zd_wheel_rear_right*work.R_rear_axle_x_y;
  work.w_wheel_rear_right_y = work.w_rear_axle_y + zd_wheel_rear_right*work.R_rear_axle_y_y;
  work.w_wheel_rear_right_z = work.w_rear_axle_z + zd_wheel_rear_right*work.R_rear_axle_z_y;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  work.v_arb_rear_right_x = work.v_chassis_x + 0.44999999999999996*zd_arb_rear_right;
  work.v_arb_rear_right_z = work.v_chassis_z - 3.3000000000000003*zd_arb_rear_right;
  work.w_arb_rear_right_y = zd_arb_rear_right + work.w_chassis_y;
  // operations: 113 add, 104 multiply

  // --- step 7: accelerations Zdot and accumulated forces QR - PR (51), (52) ---
  // chassis: chassis_rx, revolute, chassis_aux5
  work.s7_1 = 15014.70911391573*work.w_chassis_x - 22.575050285939653*work.w_chassis_z;
  work.s7_2 = 150070.8160441727*work.w_chassis_y;
  const double s7_3 = 145066.78026359034*work.w_chassis_z;
  work.s7_4 = s7_3 - 22.575050285939653*work.w_chassis_x;
  // lower_arm_left: lower_arm_left, revolute, chassis
  work.s7_5 = 0.6*work.w_lower_arm_left_x;
  work.s7_6 = work.s1_83*work.w_chassis_y + work.s1_85*work.w_chassis_z;
  work.s7_7 = work.s1_85*work.w_chassis_y + work.s1_84*work.w_chassis_z;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_8 = work.s1_130*work.w_carrier_left_y + work.s1_132*work.w_carrier_left_z;
  work.s7_9 = s7_8 + work.s1_124*work.w_carrier_left_x;
  const double s7_10 = work.s1_126*work.w_carrier_left_y + work.s1_134*work.w_carrier_left_z;
  work.s7_11 = s7_10 + work.s1_130*work.w_carrier_left_x;
  const double s7_12 = work.s1_134*work.w_carrier_left_y + work.s1_128*work.w_carrier_left_z;
  work.s7_13 = s7_12 + work.s1_132*work.w_carrier_left_x;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s7_14 = work.s1_149*work.w_wheel_front_left_y;
  const double s7_15 = s7_14 + work.s1_151*work.w_wheel_front_left_z;
  work.s7_16 = s7_15 + work.s1_143*work.w_wheel_front_left_x;
  const double s7_17 = work.s1_145*work.w_wheel_front_left_y;
  const double s7_18 = s7_17 + work.s1_153*work.w_wheel_front_left_z;
  work.s7_19 = s7_18 + work.s1_149*work.w_wheel_front_left_x;
  const double s7_20 = work.s1_153*work.w_wheel_front_left_y;
  const double s7_21 = s7_20 + work.s1_147*work.w_wheel_front_left_z;
  work.s7_22 = s7_21 + work.s1_151*work.w_wheel_front_left_x;
  // upper_arm_left: upper_arm_left, revolute, chassis
  work.s7_23 = 0.2*work.w_upper_arm_left_x;
  work.s7_24 = work.s1_161*work.w_chassis_y + work.s1_163*work.w_chassis_z;
  work.s7_25 = work.s1_163*work.w_chassis_y + work.s1_162*work.w_chassis_z;
  // arb_front_left: arb_front_left, revolute, chassis
  const double s7_26 = work.s1_170*work.w_arb_front_left_y + work.s1_180*work.w_chassis_z;
  work.s7_27 = s7_26 + work.s1_178*work.w_chassis_x;
  const double s7_28 = 0.1304*work.w_arb_front_left_y + work.s1_170*work.w_chassis_x;
  work.s7_29 = s7_28 - work.s1_174*work.w_chassis_z;
  const double s7_30 = work.s1_179*work.w_chassis_z + work.s1_180*work.w_chassis_x;
  work.s7_31 = s7_30 - work.s1_174*work.w_arb_front_left_y;
  // lower_arm_right: lower_arm_right, revolute, chassis
  work.s7_32 = 0.6*work.w_lower_arm_right_x;
  work.s7_33 = work.s1_188*work.w_chassis_y + work.s1_190*work.w_chassis_z;
  work.s7_34 = work.s1_190*work.w_chassis_y + work.s1_189*work.w_chassis_z;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_35 = work.s1_233*work.w_carrier_right_y + work.s1_235*work.w_carrier_right_z;
  work.s7_36 = s7_35 + work.s1_227*work.w_carrier_right_x;
  const double s7_37 = work.s1_229*work.w_carrier_right_y + work.s1_237*work.w_carrier_right_z;
  work.s7_38 = s7_37 + work.s1_233*work.w_carrier_right_x;
  const double s7_39 = work.s1_237*work.w_carrier_right_y + work.s1_231*work.w_carrier_right_z;
  work.s7_40 = s7_39 + work.s1_235*work.w_carrier_right_x;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s7_41 = work.s1_252*work.w_wheel_front_right_y;
  const double s7_42 = s7_41 + work.s1_254*work.w_wheel_front_right_z;
  work.s7_43 = s7_42 + work.s1_246*work.w_wheel_front_right_x;
  const double s7_44 = work.s1_248*work.w_wheel_front_right_y;
  const double s7_45 = s7_44 + work.s1_256*work.w_wheel_front_right_z;
  work.s7_46 = s7_45 + work.s1_252*work.w_wheel_front_right_x;
  const double s7_47 = work.s1_256*work.w_wheel_front_right_y;
  const double s7_48 = s7_47 + work.s1_250*work.w_wheel_front_right_z;
  work.s7_49 = s7_48 + work.s1_254*work.w_wheel_front_right_x;
  // upper_arm_right: upper_arm_right, revolute, chassis
  work.s7_50 = 0.2*work.w_upper_arm_right_x;
  work.s7_51 = work.s1_264*work.w_chassis_y + work.s1_266*work.w_chassis_z;
  work.s7_52 = work.s1_266*work.w_chassis_y + work.s1_265*work.w_chassis_z;
  // arb_front_right: arb_front_right, revolute, chassis
  const double s7_53 = work.s1_273*work.w_arb_front_right_y + work.s1_283*work.w_chassis_z;
  work.s7_54 = s7_53 + work.s1_281*work.w_chassis_x;
  const double s7_55 = 0.1304*work.w_arb_front_right_y + work.s1_277*work.w_chassis_z;
  work.s7_56 = s7_55 + work.s1_273*work.w_chassis_x;
  const double s7_57 = work.s1_277*work.w_arb_front_right_y + work.s1_282*work.w_chassis_z;
  work.s7_58 = s7_57 + work.s1_283*work.w_chassis_x;
  // pitman_arm: pitman_arm, revolute, chassis
  work.s7_59 = work.s1_291*work.w_chassis_z + work.s1_289*work.w_chassis_x;
  work.s7_60 = 0.0842*work.w_pitman_arm_y;
  work.s7_61 = work.s1_290*work.w_chassis_z + work.s1_291*work.w_chassis_x;
  // bell_crank: bell_crank, revolute, chassis
  work.s7_62 = work.s1_303*work.w_chassis_y + work.s1_301*work.w_chassis_x;
  work.s7_63 = work.s1_302*work.w_chassis_y + work.s1_303*work.w_chassis_x;
  work.s7_64 = 0.40412866666666675*work.w_bell_crank_z;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_65 = work.s1_328*work.w_rear_axle_y + work.s1_330*work.w_rear_axle_z;
  work.s7_66 = s7_65 + work.s1_323*work.w_rear_axle_x;
  const double s7_67 = work.s1_325*work.w_rear_axle_y + work.s1_332*work.w_rear_axle_z;
  work.s7_68 = s7_67 + work.s1_328*work.w_rear_axle_x;
  const double s7_69 = work.s1_332*work.w_rear_axle_y + work.s1_326*work.w_rear_axle_z;
  work.s7_70 = s7_69 + work.s1_330*work.w_rear_axle_x;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s7_71 = work.s1_346*work.w_wheel_rear_left_y;
  const double s7_72 = s7_71 + work.s1_348*work.w_wheel_rear_left_z;
  work.s7_73 = s7_72 + work.s1_341*work.w_wheel_rear_left_x;
  const double s7_74 = work.s1_343*work.w_wheel_rear_left_y;
  const double s7_75 = s7_74 + work.s1_350*work.w_wheel_rear_left_z;
  work.s7_76 = s7_75 + work.s1_346*work.w_wheel_rear_left_x;
  const double s7_77 = work.s1_350*work.w_wheel_rear_left_y;
  const double s7_78 = s7_77 + work.s1_344*work.w_wheel_rear_left_z;
  work.s7_79 = s7_78 + work.s1_348*work.w_wheel_rear_left_x;
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s7_80 = s1_360*work.w_chassis_z + s1_358*work.w_chassis_x;
  work.s7_81 = s7_80 - s1_353*work.w_arb_rear_left_y;
  const double s7_82 = 0.14461538461538465*work.w_arb_rear_left_y + s1_355*work.w_chassis_z;
  work.s7_83 = s7_82 - s1_353*work.w_chassis_x;
  const double s7_84 = s1_355*work.w_arb_rear_left_y + s1_359*work.w_chassis_z;
  work.s7_85 = s7_84 + s1_360*work.w_chassis_x;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s7_86 = work.s1_346*work.w_wheel_rear_right_y;
  const double s7_87 = s7_86 + work.s1_348*work.w_wheel_rear_right_z;
  work.s7_88 = s7_87 + work.s1_341*work.w_wheel_rear_right_x;
  const double s7_89 = work.s1_343*work.w_wheel_rear_right_y;
  const double s7_90 = s7_89 + work.s1_350*work.w_wheel_rear_right_z;
  work.s7_91 = s7_90 + work.s1_346*work.w_wheel_rear_right_x;
  const double s7_92 = work.s1_350*work.w_wheel_rear_right_y;
  const double s7_93 = s7_92 + work.s1_344*work.w_wheel_rear_right_z;
  work.s7_94 = s7_93 + work.s1_348*work.w_wheel_rear_right_x;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s7_95 = s1_363*work.w_arb_rear_right_y + s1_370*work.w_chassis_z;
  work.s7_96 = s7_95 + s1_368*work.w_chassis_x;
  const double s7_97 = 0.14461538461538465*work.w_arb_rear_right_y + s1_363*work.w_chassis_x;
  work.s7_98 = s7_97 - s1_365*work.w_chassis_z;
  const double s7_99 = s1_369*work.w_chassis_z + s1_370*work.w_chassis_x;
  work.s7_100 = s7_99 - s1_365*work.w_arb_rear_right_y;
  // operations: 80 add, 134 multiply

  // --- step 9: independent and all accelerations (63), (62) ---
  const double s9_1 = work.v_chassis_x + 0.24897456123052653*work.w_chassis_y;
  const double s9_2 = work.v_chassis_y - 0.24897456123052653*work.w_chassis_x;
  const double s9_3 = s9_2 - 0.0027607966870439754*work.w_chassis_z;
  const double s9_4 = work.v_chassis_z + 0.0027607966870439754*work.w_chassis_y;
  work.s9_5 = s9_3*s9_3 + s9_4*s9_4 + s9_1*s9_1;
  const double s9_6 = work.r_chassis_aux3_z + 0.24897456123052653*work.R_chassis_z_z;
  work.s9_7 = 9.81*(s9_6 + 0.0027607966870439754*s1_3);
  const double s9_8 = 3.6*work.w_chassis_z;
  const double s9_9 = 3.6*work.w_chassis_y;
  const double s9_10 = work.v_chassis_x + work.s1_79*work.w_chassis_y;
  work.s9_11 = s9_10 - work.s1_77*work.w_chassis_z;
  work.s9_12 = v_lower_arm_left_y + s9_8 - work.s1_79*work.w_lower_arm_left_x;
  work.s9_13 = v_lower_arm_left_z - s9_9 + work.s1_77*work.w_lower_arm_left_x;
  const double s9_14 = work.r_chassis_aux3_z - 3.6*s1_3;
  work.s9_15 = s9_14 + work.R_chassis_z_y*work.s1_77 + work.R_chassis_z_z*work.s1_79;
  const double s9_16 = work.v_carrier_left_x + work.s1_96*work.w_carrier_left_y;
  work.s9_17 = s9_16 - work.s1_92*work.w_carrier_left_z;
  const double s9_18 = work.v_carrier_left_y + work.s1_88*work.w_carrier_left_z;
  work.s9_19 = s9_18 - work.s1_96*work.w_carrier_left_x;
  const double s9_20 = work.v_carrier_left_z + work.s1_92*work.w_carrier_left_x;
  work.s9_21 = s9_20 - work.s1_88*work.w_carrier_left_y;
  const double s9_22 = work.r_chassis_aux3_z + work.R_chassis_z_y*work.s1_92;
  work.s9_23 = s9_22 + work.R_chassis_z_z*work.s1_96 - s1_3*work.s1_88;
  const double s9_24 = work.r_wheel_front_left_z*work.w_wheel_front_left_y;
  const double s9_25 = work.r_wheel_front_left_y*work.w_wheel_front_left_z;
  work.s9_26 = v_wheel_front_left_x + s9_24 - s9_25;
  const double s9_27 = work.r_wheel_front_left_x*work.w_wheel_front_left_z;
  const double s9_28 = work.r_wheel_front_left_z*work.w_wheel_front_left_x;
  work.s9_29 = v_wheel_front_left_y + s9_27 - s9_28;
  const double s9_30 = work.r_wheel_front_left_y*work.w_wheel_front_left_x;
  const double s9_31 = work.r_wheel_front_left_x*work.w_wheel_front_left_y;
  work.s9_32 = v_wheel_front_left_z + s9_30 - s9_31;
  const double s9_33 = work.r_chassis_aux3_z + work.R_chassis_z_y*work.r_wheel_front_left_y;
  const double s9_34 = s9_33 + work.R_chassis_z_z*work.r_wheel_front_left_z;
  work.s9_35 = s9_34 - s1_3*work.r_wheel_front_left_x;
  const double s9_36 = work.v_chassis_x + work.s1_157*work.w_chassis_y;
  work.s9_37 = s9_36 - work.s1_155*work.w_chassis_z;
  work.s9_38 = v_upper_arm_left_y + s9_8 - work.s1_157*work.w_upper_arm_left_x;
  work.s9_39 = v_upper_arm_left_z - s9_9 + work.s1_155*work.w_upper_arm_left_x;
  work.s9_40 = s9_14 + work.R_chassis_z_y*work.s1_155 + work.R_chassis_z_z*work.s1_157;
  const double s9_41 = 0.5169230769230769*work.w_chassis_z;
  const double s9_42 = 0.5169230769230769*work.w_chassis_x;
  work.s9_43 = work.v_arb_front_left_x - s9_41 + work.s1_167*work.w_arb_front_left_y;
  const double s9_44 = work.v_chassis_y + work.s1_165*work.w_chassis_z;
  work.s9_45 = s9_44 - work.s1_167*work.w_chassis_x;
  work.s9_46 = work.v_arb_front_left_z + s9_42 - work.s1_165*work.w_arb_front_left_y;
  const double s9_47 = 0.5169230769230769*work.R_chassis_z_y;
  const double s9_48 = work.r_chassis_aux3_z + s9_47 + work.R_chassis_z_z*work.s1_167;
  work.s9_49 = s9_48 - s1_3*work.s1_165;
  const double s9_50 = work.v_chassis_x - work.s1_182*work.w_chassis_z;
  work.s9_51 = s9_50 - work.s1_184*work.w_chassis_y;
  work.s9_52 = v_lower_arm_right_y + s9_8 + work.s1_184*work.w_lower_arm_right_x;
  work.s9_53 = v_lower_arm_right_z - s9_9 + work.s1_182*work.w_lower_arm_right_x;
  work.s9_54 = s9_14 + work.R_chassis_z_y*work.s1_182 - work.R_chassis_z_z*work.s1_184;
  const double s9_55 = work.v_carrier_right_x + work.s1_200*work.w_carrier_right_y;
  work.s9_56 = s9_55 - work.s1_197*work.w_carrier_right_z;
  const double s9_57 = work.v_carrier_right_y + work.s1_193*work.w_carrier_right_z;
  work.s9_58 = s9_57 - work.s1_200*work.w_carrier_right_x;
  const double s9_59 = work.v_carrier_right_z + work.s1_197*work.w_carrier_right_x;
  work.s9_60 = s9_59 - work.s1_193*work.w_carrier_right_y;
  const double s9_61 = work.r_chassis_aux3_z + work.R_chassis_z_y*work.s1_197;
  work.s9_62 = s9_61 + work.R_chassis_z_z*work.s1_200 - s1_3*work.s1_193;
  const double s9_63 = work.r_wheel_front_right_z*work.w_wheel_front_right_y;
  const double s9_64 = work.r_wheel_front_right_y*work.w_wheel_front_right_z;
  work.s9_65 = v_wheel_front_right_x + s9_63 - s9_64;
  const double s9_66 = work.r_wheel_front_right_x*work.w_wheel_front_right_z;
  const double s9_67 = work.r_wheel_front_right_z*work.w_wheel_front_right_x;
  work.s9_68 = v_wheel_front_right_y + s9_66 - s9_67;
  const double s9_69 = work.r_wheel_front_right_y*work.w_wheel_front_right_x;
  const double s9_70 = work.r_wheel_front_right_x*work.w_wheel_front_right_y;
  work.s9_71 = v_wheel_front_right_z + s9_69 - s9_70;
  const double s9_72 = work.r_chassis_aux3_z + work.R_chassis_z_y*work.r_wheel_front_right_y;
  const double s9_73 = s9_72 + work.R_chassis_z_z*work.r_wheel_front_right_z;
  work.s9_74 = s9_73 - s1_3*work.r_wheel_front_right_x;
  const double s9_75 = work.v_chassis_x - work.s1_258*work.w_chassis_z;
  work.s9_76 = s9_75 - work.s1_260*work.w_chassis_y;
  work.s9_77 = v_upper_arm_right_y + s9_8 + work.s1_260*work.w_upper_arm_right_x;
  work.s9_78 = v_upper_arm_right_z - s9_9 + work.s1_258*work.w_upper_arm_right_x;
  work.s9_79 = s9_14 + work.R_chassis_z_y*work.s1_258 - work.R_chassis_z_z*work.s1_260;
  work.s9_80 = work.v_arb_front_right_x + s9_41 + work.s1_270*work.w_arb_front_right_y;
  const double s9_81 = work.v_chassis_y + work.s1_268*work.w_chassis_z;
  work.s9_82 = s9_81 - work.s1_270*work.w_chassis_x;
  work.s9_83 = work.v_arb_front_right_z - s9_42 - work.s1_268*work.w_arb_front_right_y;
  const double s9_84 = work.r_chassis_aux3_z - s9_47 + work.R_chassis_z_z*work.s1_270;
  work.s9_85 = s9_84 - s1_3*work.s1_268;
  work.s9_86 = v_pitman_arm_x - 0.5*work.w_chassis_z;
  const double s9_87 = work.s9_86 - work.s1_285*work.w_pitman_arm_y;
  const double s9_88 = work.v_chassis_y + work.s1_285*work.w_chassis_x;
  const double s9_89 = s9_88 + work.s1_284*work.w_chassis_z;
  work.s9_90 = v_pitman_arm_z + 0.5*work.w_chassis_x;
  const double s9_91 = work.s9_90 - work.s1_284*work.w_pitman_arm_y;
  work.s9_92 = s9_89*s9_89 + s9_91*s9_91 + s9_87*s9_87;
  work.s9_93 = work.r_chassis_aux3_z + 0.5*work.R_chassis_z_y;
  work.s9_94 = 9.81*(work.s9_93 - work.R_chassis_z_z*work.s1_285 - s1_3*work.s1_284);
  work.s9_95 = 0.6*work.w_chassis_x;
  work.s9_96 = work.v_chassis_x - 0.6*work.w_chassis_y;
  const double s9_97 = work.s9_96 - work.s1_293*work.w_bell_crank_z;
  work.s9_98 = v_bell_crank_y + work.s9_95;
  const double s9_99 = work.s9_98 + work.s1_295*work.w_bell_crank_z;
  const double s9_100 = work.v_chassis_z + work.s1_293*work.w_chassis_x;
  const double s9_101 = s9_100 - work.s1_295*work.w_chassis_y;
  work.s9_102 = s9_99*s9_99 + s9_101*s9_101 + s9_97*s9_97;
  work.s9_103 = 0.6*work.R_chassis_z_z;
  work.s9_104 = work.r_chassis_aux3_z - work.s9_103;
  work.s9_105 = 9.81*(work.s9_104 + work.R_chassis_z_y*work.s1_293 - s1_3*work.s1_295);
  const double s9_106 = work.v_rear_axle_x + work.s1_309*work.w_rear_axle_y;
  const double s9_107 = s9_106 - work.s1_307*work.w_rear_axle_z;
  const double s9_108 = work.v_rear_axle_y + work.s1_305*work.w_rear_axle_z;
  const double s9_109 = s9_108 - work.s1_309*work.w_rear_axle_x;
  const double s9_110 = work.v_rear_axle_z + work.s1_307*work.w_rear_axle_x;
  const double s9_111 = s9_110 - work.s1_305*work.w_rear_axle_y;
  work.s9_112 = s9_109*s9_109 + s9_111*s9_111 + s9_107*s9_107;
  const double s9_113 = work.r_chassis_aux3_z + work.R_chassis_z_y*work.s1_307;
  work.s9_114 = 9.81*(s9_113 + work.R_chassis_z_z*work.s1_309 - s1_3*work.s1_305);
  const double s9_115 = v_wheel_rear_left_x + work.r_wheel_rear_left_z*work.w_wheel_rear_left_y;
  work.s9_116 = s9_115 - work.r_wheel_rear_left_y*work.w_wheel_rear_left_z;
  const double s9_117 = v_wheel_rear_left_y + work.r_wheel_rear_left_x*work.w_wheel_rear_left_z;
  work.s9_118 = s9_117 - work.r_wheel_rear_left_z*work.w_wheel_rear_left_x;
  const double s9_119 = v_wheel_rear_left_z + work.r_wheel_rear_left_y*work.w_wheel_rear_left_x;
  work.s9_120 = s9_119 - work.r_wheel_rear_left_x*work.w_wheel_rear_left_y;
  const double s9_121 = work.r_chassis_aux3_z + work.R_chassis_z_y*work.r_wheel_rear_left_y;
  const double s9_122 = s9_121 + work.R_chassis_z_z*work.r_wheel_rear_left_z;
  work.s9_123 = s9_122 - s1_3*work.r_wheel_rear_left_x;
  const double s9_124 = 0.5076923076923077*work.w_chassis_z;
  const double s9_125 = 0.5076923076923077*work.w_chassis_x;
  work.s9_126 = work.v_arb_rear_left_x - s9_124 - s1_352*work.w_arb_rear_left_y;
  work.s9_127 = work.v_chassis_y + s1_352*work.w_chassis_x + s1_351*work.w_chassis_z;
  work.s9_128 = work.v_arb_rear_left_z + s9_125 - s1_351*work.w_arb_rear_left_y;
  const double s9_129 = 0.5076923076923077*work.R_chassis_z_y;
  work.s9_130 = work.r_chassis_aux3_z + s9_129 - work.R_chassis_z_z*s1_352 - s1_3*s1_351;
  const double s9_131 = work.r_wheel_rear_right_z*work.w_wheel_rear_right_y;
  const double s9_132 = work.r_wheel_rear_right_y*work.w_wheel_rear_right_z;
  work.s9_133 = v_wheel_rear_right_x + s9_131 - s9_132;
  const double s9_134 = work.r_wheel_rear_right_x*work.w_wheel_rear_right_z;
  const double s9_135 = work.r_wheel_rear_right_z*work.w_wheel_rear_right_x;
  work.s9_136 = v_wheel_rear_right_y + s9_134 - s9_135;
  const double s9_137 = work.r_wheel_rear_right_y*work.w_wheel_rear_right_x;
  const double s9_138 = work.r_wheel_rear_right_x*work.w_wheel_rear_right_y;
  work.s9_139 = v_wheel_rear_right_z + s9_137 - s9_138;
  const double s9_140 = work.r_chassis_aux3_z + work.R_chassis_z_y*work.r_wheel_rear_right_y;
  const double s9_141 = s9_140 + work.R_chassis_z_z*work.r_wheel_rear_right_z;
  work.s9_142 = s9_141 - s1_3*work.r_wheel_rear_right_x;
  work.s9_143 = work.v_arb_rear_right_x + s9_124 - s1_362*work.w_arb_rear_right_y;
  work.s9_144 = work.v_chassis_y + s1_362*work.w_chassis_x + s1_361*work.w_chassis_z;
  work.s9_145 = work.v_arb_rear_right_z - s9_125 - s1_361*work.w_arb_rear_right_y;
  work.s9_146 = work.r_chassis_aux3_z - s9_129 - work.R_chassis_z_z*s1_362 - s1_3*s1_361;
  const double s9_147 = zd_chassis_tx*tau[Coordinate::chassis_tx];
  const double s9_148 = s9_147 + zd_chassis_ty*tau[Coordinate::chassis_ty];
  const double s9_149 = s9_148 + zd_chassis_tz*tau[Coordinate::chassis_tz];
  const double s9_150 = s9_149 + zd_chassis_rz*tau[Coordinate::chassis_rz];
  const double s9_151 = s9_150 + zd_chassis_ry*tau[Coordinate::chassis_ry];
  const double s9_152 = s9_151 + zd_chassis_rx*tau[Coordinate::chassis_rx];
  const double s9_153 = s9_152 + zd_lower_arm_left*tau[Coordinate::lower_arm_left];
  const double s9_154 = s9_153 + zd_carrier_left_rz*tau[Coordinate::carrier_left_rz];
  const double s9_155 = s9_154 + zd_carrier_left_rx*tau[Coordinate::carrier_left_rx];
  const double s9_156 = s9_155 + zd_carrier_left_ry*tau[Coordinate::carrier_left_ry];
  const double s9_157 = s9_156 + zd_wheel_front_left*tau[Coordinate::wheel_front_left];
  const double s9_158 = s9_157 + zd_upper_arm_left*tau[Coordinate::upper_arm_left];
  work.s9_159 = s9_158 + zd_arb_front_left*tau[Coordinate::arb_front_left];
}

/// Part 3 of compute_outputs: step 9: independent and all accelerations (63), (62).
[[gnu::noinline]] void compute_outputs_3(const State& state, const double* tau,
    OutputsWork& __restrict work, Outputs& __restrict result) noexcept {
  // --- step 9: independent and all accelerations (63), (62), continued ---
  const double s9_160 = state.zd[Coordinate::lower_arm_right]*tau[Coordinate::lower_arm_right];
  const double s9_161 = state.zd[Coordinate::carrier_right_rz]*tau[Coordinate::carrier_right_rz];
  const double s9_162 = state.zd[Coordinate::carrier_right_rx]*tau[Coordinate::carrier_right_rx];
  const double s9_163 = state.zd[Coordinate::carrier_right_ry]*tau[Coordinate::carrier_right_ry];
  const double s9_164 = state.zd[Coordinate::wheel_front_right]*tau[Coordinate::wheel_front_right];
  const double s9_165 = state.zd[Coordinate::upper_arm_right]*tau[Coordinate::upper_arm_right];
  const double s9_166 = state.zd[Coordinate::arb_front_right]*tau[Coordinate::arb_front_right];
  const double s9_167 = work.s9_159 + s9_160 + s9_161 + s9_162 + s9_163 + s9_164 + s9_165;
  const double s9_168 = state.zd[Coordinate::pitman_arm]*tau[Coordinate::pitman_arm];
  const double s9_169 = state.zd[Coordinate::bell_crank]*tau[Coordinate::bell_crank];
  const double s9_170 = state.zd[Coordinate::rear_axle_tx]*tau[Coordinate::rear_axle_tx];
  const double s9_171 = state.zd[Coordinate::rear_axle_ty]*tau[Coordinate::rear_axle_ty];
  const double s9_172 = state.zd[Coordinate::rear_axle_tz]*tau[Coordinate::rear_axle_tz];
  const double s9_173 = state.zd[Coordinate::rear_axle_rz]*tau[Coordinate::rear_axle_rz];
  const double s9_174 = s9_167 + s9_166 + s9_168 + s9_169 + s9_170 + s9_171 + s9_172 + s9_173;
  const double s9_175 = state.zd[Coordinate::rear_axle_ry]*tau[Coordinate::rear_axle_ry];
  const double s9_176 = state.zd[Coordinate::rear_axle_rx]*tau[Coordinate::rear_axle_rx];
  const double s9_177 = state.zd[Coordinate::wheel_rear_left]*tau[Coordinate::wheel_rear_left];
  const double s9_178 = state.zd[Coordinate::arb_rear_left]*tau[Coordinate::arb_rear_left];
  const double s9_179 = state.zd[Coordinate::wheel_rear_right]*tau[Coordinate::wheel_rear_right];
  const double s9_180 = state.zd[Coordinate::arb_rear_right]*tau[Coordinate::arb_rear_right];
  result.applied_power = s9_174 + s9_175 + s9_176 + s9_177 + s9_178 + s9_179 + s9_180;
  const double s9_181 = 0.72*work.w_chassis_z;
  const double s9_182 = 0.72*work.w_chassis_x;
  const double s9_183 = work.v_arb_front_left_x - s9_181 + work.s1_383*work.w_arb_front_left_y;
  const double s9_184 = work.v_chassis_y + work.s1_381*work.w_chassis_z;
  const double s9_185 = s9_184 - work.s1_383*work.w_chassis_x;
  const double s9_186 = work.v_arb_front_left_z + s9_182 - work.s1_381*work.w_arb_front_left_y;
  const double s9_187 = work.R_chassis_x_y*s9_185 + work.R_chassis_x_z*s9_186;
  const double s9_188 = work.R_chassis_y_y*s9_185 + work.R_chassis_y_z*s9_186;
  const double s1_3 = work.sines[1];
  const double s9_189 = work.v_carrier_left_x + work.s1_379*work.w_carrier_left_y;
  const double s9_190 = s9_189 - work.s1_376*work.w_carrier_left_z;
  const double s9_191 = work.v_carrier_left_y + work.s1_373*work.w_carrier_left_z;
  const double s9_192 = s9_191 - work.s1_379*work.w_carrier_left_x;
  const double s9_193 = work.v_carrier_left_z + work.s1_376*work.w_carrier_left_x;
  const double s9_194 = s9_193 - work.s1_373*work.w_carrier_left_y;
  const double s9_195 = work.R_chassis_x_y*s9_192 + work.R_chassis_x_z*s9_194;
  const double s9_196 = work.R_chassis_y_y*s9_192 + work.R_chassis_y_z*s9_194;
  const double s9_197 = 0.72*work.R_chassis_z_y;
  const double s9_198 = work.r_chassis_aux3_z + work.r_chassis_aux3_z;
  const double s9_199 = s9_197 + s9_198 + work.R_chassis_z_y*work.s1_376;
  const double s9_200 = work.R_chassis_z_z*(work.s1_379 + work.s1_383);
  const double s9_201 = work.v_arb_front_right_x + s9_181 + work.s1_396*work.w_arb_front_right_y;
  const double s9_202 = work.v_chassis_y + work.s1_394*work.w_chassis_z;
  const double s9_203 = s9_202 - work.s1_396*work.w_chassis_x;
  const double s9_204 = work.v_arb_front_right_z - s9_182 - work.s1_394*work.w_arb_front_right_y;
  const double s9_205 = work.R_chassis_x_y*s9_203 + work.R_chassis_x_z*s9_204;
  const double s9_206 = work.R_chassis_y_y*s9_203 + work.R_chassis_y_z*s9_204;
  const double s9_207 = work.v_carrier_right_x + work.s1_392*work.w_carrier_right_y;
  const double s9_208 = s9_207 - work.s1_389*work.w_carrier_right_z;
  const double s9_209 = work.v_carrier_right_y + work.s1_385*work.w_carrier_right_z;
  const double s9_210 = s9_209 - work.s1_392*work.w_carrier_right_x;
  const double s9_211 = work.v_carrier_right_z + work.s1_389*work.w_carrier_right_x;
  const double s9_212 = s9_211 - work.s1_385*work.w_carrier_right_y;
  const double s9_213 = work.R_chassis_x_y*s9_210 + work.R_chassis_x_z*s9_212;
  const double s9_214 = work.R_chassis_y_y*s9_210 + work.R_chassis_y_z*s9_212;
  const double s9_215 = s9_198 - s9_197 + work.R_chassis_z_y*work.s1_389;
  const double s9_216 = work.R_chassis_z_z*(work.s1_392 + work.s1_396);
  const double s9_217 = work.s9_86 - work.s1_400*work.w_pitman_arm_y;
  const double s9_218 = work.v_chassis_y + work.s1_400*work.w_chassis_x;
  const double s9_219 = s9_218 + work.s1_399*work.w_chassis_z;
  const double s9_220 = work.s9_90 - work.s1_399*work.w_pitman_arm_y;
  const double s9_221 = work.R_chassis_x_y*s9_219 + work.R_chassis_x_z*s9_220;
  const double s9_222 = work.R_chassis_y_y*s9_219 + work.R_chassis_y_z*s9_220;
  const double s9_223 = work.s9_96 - work.s1_397*work.w_bell_crank_z;
  const double s9_224 = work.s9_98 + work.s1_398*work.w_bell_crank_z;
  const double s9_225 = work.v_chassis_z + work.s1_397*work.w_chassis_x;
  const double s9_226 = s9_225 - work.s1_398*work.w_chassis_y;
  const double s9_227 = work.R_chassis_x_y*s9_224 + work.R_chassis_x_z*s9_226;
  const double s9_228 = work.R_chassis_y_y*s9_224 + work.R_chassis_y_z*s9_226;
  const double s9_229 = s9_222 + work.R_chassis_aux5_y_x*s9_217;
  const double s9_230 = work.R_chassis_z_y*s9_219 + work.R_chassis_z_z*s9_220 - s1_3*s9_217;
  const double s9_231 = work.R_chassis_z_y*s9_224 + work.R_chassis_z_z*s9_226 - s1_3*s9_223;
  const double s9_232 = s9_221 + work.R_chassis_aux5_x_x*s9_217;
  const double s9_233 = s9_229*(s9_228 + work.R_chassis_aux5_y_x*s9_223) + s9_230*s9_231;
  const double s9_234 = work.s9_93 + work.s9_104 + work.R_chassis_z_y*work.s1_397;
  const double s9_235 = s9_234 - work.R_chassis_z_z*work.s1_400;
  const double s9_236 = work.s9_96 - work.s1_413*work.w_bell_crank_z;
  const double s9_237 = work.s9_98 + work.s1_414*work.w_bell_crank_z;
  const double s9_238 = work.v_chassis_z + work.s1_413*work.w_chassis_x;
  const double s9_239 = s9_238 - work.s1_414*work.w_chassis_y;
  const double s9_240 = work.R_chassis_x_y*s9_237 + work.R_chassis_x_z*s9_239;
  const double s9_241 = work.R_chassis_y_y*s9_237 + work.R_chassis_y_z*s9_239;
  const double s9_242 = work.v_carrier_left_x + work.s1_408*work.w_carrier_left_y;
  const double s9_243 = s9_242 - work.s1_405*work.w_carrier_left_z;
  const double s9_244 = work.v_carrier_left_y + work.s1_402*work.w_carrier_left_z;
  const double s9_245 = s9_244 - work.s1_408*work.w_carrier_left_x;
  const double s9_246 = work.v_carrier_left_z + work.s1_405*work.w_carrier_left_x;
  const double s9_247 = s9_246 - work.s1_402*work.w_carrier_left_y;
  const double s9_248 = work.R_chassis_x_y*s9_245 + work.R_chassis_x_z*s9_247;
  const double s9_249 = work.R_chassis_y_y*s9_245 + work.R_chassis_y_z*s9_247;
  const double s9_250 = s9_198 - work.s9_103;
  const double s9_251 = s9_250 + work.R_chassis_z_z*work.s1_408;
  const double s9_252 = work.R_chassis_z_y*(work.s1_405 + work.s1_413);
  const double s9_253 = work.s9_96 + work.s1_422*work.w_bell_crank_z;
  const double s9_254 = work.s9_98 + work.s1_423*work.w_bell_crank_z;
  const double s9_255 = work.v_chassis_z - work.s1_423*work.w_chassis_y;
  const double s9_256 = s9_255 - work.s1_422*work.w_chassis_x;
  const double s9_257 = work.R_chassis_x_y*s9_254 + work.R_chassis_x_z*s9_256;
  const double s9_258 = work.R_chassis_y_y*s9_254 + work.R_chassis_y_z*s9_256;
  const double s9_259 = work.v_carrier_right_x + work.s1_421*work.w_carrier_right_y;
  const double s9_260 = s9_259 - work.s1_419*work.w_carrier_right_z;
  const double s9_261 = work.v_carrier_right_y + work.s1_416*work.w_carrier_right_z;
  const double s9_262 = s9_261 - work.s1_421*work.w_carrier_right_x;
  const double s9_263 = work.v_carrier_right_z + work.s1_419*work.w_carrier_right_x;
  const double s9_264 = s9_263 - work.s1_416*work.w_carrier_right_y;
  const double s9_265 = work.R_chassis_x_y*s9_262 + work.R_chassis_x_z*s9_264;
  const double s9_266 = work.R_chassis_y_y*s9_262 + work.R_chassis_y_z*s9_264;
  const double s9_267 = s9_250 + work.R_chassis_z_z*work.s1_421;
  const double s9_268 = work.R_chassis_z_y*(work.s1_419 - work.s1_422);
  const double s9_269 = 0.55*work.w_chassis_z;
  const double s9_270 = 0.55*work.w_chassis_y;
  const double s9_271 = 0.55*work.w_chassis_x;
  const double s9_272 = work.v_chassis_x - s9_269 - s9_270;
  const double s9_273 = work.v_chassis_y + s9_271 - 1.6*work.w_chassis_z;
  const double s9_274 = work.v_chassis_z + 1.6*work.w_chassis_y;
  const double s9_275 = s9_271 + s9_274;
  const double s9_276 = work.R_chassis_x_y*s9_273;
  const double s9_277 = work.R_chassis_y_y*s9_273;
  const double s9_278 = work.R_chassis_z_y*s9_273;
  const double s9_279 = work.v_rear_axle_x + work.s1_435*work.w_rear_axle_y;
  const double s9_280 = s9_279 - work.s1_434*work.w_rear_axle_z;
  const double s9_281 = work.v_rear_axle_y + work.s1_432*work.w_rear_axle_z;
  const double s9_282 = s9_281 - work.s1_435*work.w_rear_axle_x;
  const double s9_283 = work.v_rear_axle_z + work.s1_434*work.w_rear_axle_x;
  const double s9_284 = s9_283 - work.s1_432*work.w_rear_axle_y;
  const double s9_285 = work.R_chassis_x_y*s9_282 + work.R_chassis_x_z*s9_284;
  const double s9_286 = work.R_chassis_y_y*s9_282 + work.R_chassis_y_z*s9_284;
  const double s9_287 = 0.55*work.R_chassis_z_y;
  const double s9_288 = s9_198 + (1.6*s1_3 - 0.55*work.R_chassis_z_z);
  const double s9_289 = s9_287 + s9_288 + work.R_chassis_z_y*work.s1_434;
  const double s9_290 = 0.4*work.w_chassis_z;
  const double s9_291 = 0.15000000000000002*work.w_chassis_y;
  const double s9_292 = 0.4*work.w_chassis_x;
  const double s9_293 = work.v_chassis_x - s9_290 - s9_291;
  const double s9_294 = work.v_chassis_y + 0.15000000000000002*work.w_chassis_x;
  const double s9_295 = s9_294 - 1.6999999999999997*work.w_chassis_z;
  const double s9_296 = work.v_chassis_z + 1.6999999999999997*work.w_chassis_y;
  const double s9_297 = s9_292 + s9_296;
  const double s9_298 = work.R_chassis_x_y*s9_295;
  const double s9_299 = work.R_chassis_y_y*s9_295;
  const double s9_300 = work.R_chassis_z_y*s9_295;
  const double s9_301 = work.v_rear_axle_x + work.s1_444*work.w_rear_axle_y;
  const double s9_302 = s9_301 - work.s1_442*work.w_rear_axle_z;
  const double s9_303 = work.v_rear_axle_y + work.s1_440*work.w_rear_axle_z;
  const double s9_304 = s9_303 - work.s1_444*work.w_rear_axle_x;
  const double s9_305 = work.v_rear_axle_z + work.s1_442*work.w_rear_axle_x;
  const double s9_306 = s9_305 - work.s1_440*work.w_rear_axle_y;
  const double s9_307 = work.R_chassis_x_y*s9_304 + work.R_chassis_x_z*s9_306;
  const double s9_308 = work.R_chassis_y_y*s9_304 + work.R_chassis_y_z*s9_306;
  const double s9_309 = 0.4*work.R_chassis_z_y;
  const double s9_310 = 1.6999999999999997*s1_3 - 0.15000000000000002*work.R_chassis_z_z;
  const double s9_311 = s9_198 + s9_310;
  const double s9_312 = s9_309 + s9_311 + work.R_chassis_z_y*work.s1_442;
  const double s9_313 = 0.6*work.w_chassis_z;
  const double s9_314 = work.v_arb_rear_left_x - s9_313 - work.s1_458*work.w_arb_rear_left_y;
  const double s9_315 = work.v_chassis_y + work.s1_458*work.w_chassis_x;
  const double s9_316 = s9_315 + work.s1_457*work.w_chassis_z;
  const double s9_317 = work.v_arb_rear_left_z + work.s9_95 - work.s1_457*work.w_arb_rear_left_y;
  const double s9_318 = work.R_chassis_x_y*s9_316 + work.R_chassis_x_z*s9_317;
  const double s9_319 = work.R_chassis_y_y*s9_316 + work.R_chassis_y_z*s9_317;
  const double s9_320 = work.v_rear_axle_x + work.s1_456*work.w_rear_axle_y;
  const double s9_321 = s9_320 - work.s1_453*work.w_rear_axle_z;
  const double s9_322 = work.v_rear_axle_y + work.s1_452*work.w_rear_axle_z;
  const double s9_323 = s9_322 - work.s1_456*work.w_rear_axle_x;
  const double s9_324 = work.v_rear_axle_z + work.s1_453*work.w_rear_axle_x;
  const double s9_325 = s9_324 - work.s1_452*work.w_rear_axle_y;
  const double s9_326 = work.R_chassis_x_y*s9_323 + work.R_chassis_x_z*s9_325;
  const double s9_327 = work.R_chassis_y_y*s9_323 + work.R_chassis_y_z*s9_325;
  const double s9_328 = 0.6*work.R_chassis_z_y;
  const double s9_329 = s9_198 + s9_328 + work.R_chassis_z_y*work.s1_453;
  const double s9_330 = work.R_chassis_z_z*(work.s1_456 - work.s1_458);
  const double s9_331 = work.v_chassis_x + s9_269 - s9_270;
  const double s9_332 = s9_274 - s9_271;
  const double s9_333 = work.v_rear_axle_x + work.s1_461*work.w_rear_axle_y;
  const double s9_334 = s9_333 - work.s1_460*work.w_rear_axle_z;
  const double s9_335 = work.v_rear_axle_y + work.s1_459*work.w_rear_axle_z;
  const double s9_336 = s9_335 - work.s1_461*work.w_rear_axle_x;
  const double s9_337 = work.v_rear_axle_z + work.s1_460*work.w_rear_axle_x;
  const double s9_338 = s9_337 - work.s1_459*work.w_rear_axle_y;
  const double s9_339 = work.R_chassis_x_y*s9_336 + work.R_chassis_x_z*s9_338;
  const double s9_340 = work.R_chassis_y_y*s9_336 + work.R_chassis_y_z*s9_338;
  const double s9_341 = s9_288 - s9_287 + work.R_chassis_z_y*work.s1_460;
  const double s9_342 = work.v_chassis_x + s9_290 - s9_291;
  const double s9_343 = s9_296 - s9_292;
  const double s9_344 = work.v_rear_axle_x + work.s1_464*work.w_rear_axle_y;
  const double s9_345 = s9_344 - work.s1_463*work.w_rear_axle_z;
  const double s9_346 = work.v_rear_axle_y + work.s1_462*work.w_rear_axle_z;
  const double s9_347 = s9_346 - work.s1_464*work.w_rear_axle_x;
  const double s9_348 = work.v_rear_axle_z + work.s1_463*work.w_rear_axle_x;
  const double s9_349 = s9_348 - work.s1_462*work.w_rear_axle_y;
  const double s9_350 = work.R_chassis_x_y*s9_347 + work.R_chassis_x_z*s9_349;
  const double s9_351 = work.R_chassis_y_y*s9_347 + work.R_chassis_y_z*s9_349;
  const double s9_352 = s9_311 - s9_309 + work.R_chassis_z_y*work.s1_463;
  const double s9_353 = work.v_arb_rear_right_x + s9_313 - work.s1_469*work.w_arb_rear_right_y;
  const double s9_354 = work.v_chassis_y + work.s1_469*work.w_chassis_x;
  const double s9_355 = s9_354 + work.s1_468*work.w_chassis_z;
  const double s9_356 = work.v_arb_rear_right_z - work.s9_95;
  const double s9_357 = s9_356 - work.s1_468*work.w_arb_rear_right_y;
  const double s9_358 = work.R_chassis_x_y*s9_355 + work.R_chassis_x_z*s9_357;
  const double s9_359 = work.R_chassis_y_y*s9_355 + work.R_chassis_y_z*s9_357;
  const double s9_360 = work.v_rear_axle_x + work.s1_467*work.w_rear_axle_y;
  const double s9_361 = s9_360 - work.s1_466*work.w_rear_axle_z;
  const double s9_362 = work.v_rear_axle_y + work.s1_465*work.w_rear_axle_z;
  const double s9_363 = s9_362 - work.s1_467*work.w_rear_axle_x;
  const double s9_364 = work.v_rear_axle_z + work.s1_466*work.w_rear_axle_x;
  const double s9_365 = s9_364 - work.s1_465*work.w_rear_axle_y;
  const double s9_366 = work.R_chassis_x_y*s9_363 + work.R_chassis_x_z*s9_365;
  const double s9_367 = work.R_chassis_y_y*s9_363 + work.R_chassis_y_z*s9_365;
  const double s9_368 = work.s7_34 + (work.s7_31 + (work.s7_25 + (work.s7_4 + work.s7_7)));
  const double s9_369 = work.s7_85 + (work.s7_61 + (work.s7_58 + (work.s7_52 + s9_368)));
  const double s9_370 = work.s7_62 + (work.s7_59 + (work.s7_54 + (work.s7_1 + work.s7_27)));
  const double s9_371 = work.s7_51 + (work.s7_33 + (work.s7_24 + (work.s7_2 + work.s7_6)));
  const double s9_372 = work.s9_144*work.s9_144 + work.s9_145*work.s9_145;
  const double s9_373 = s9_372 + work.s9_143*work.s9_143 + work.s9_127*work.s9_127;
  const double s9_374 = s9_373 + work.s9_128*work.s9_128 + work.s9_126*work.s9_126;
  const double s9_375 = s9_374 + work.s9_45*work.s9_45 + work.s9_46*work.s9_46;
  const double s9_376 = s9_375 + work.s9_43*work.s9_43 + work.s9_82*work.s9_82;
  const double s9_377 = s9_359 + work.R_chassis_aux5_y_x*s9_353;
  const double s9_378 = work.R_chassis_z_y*s9_355 + work.R_chassis_z_z*s9_357 - s1_3*s9_353;
  const double s9_379 = work.R_chassis_z_y*s9_363 + work.R_chassis_z_z*s9_365 - s1_3*s9_361;
  const double s9_380 = s9_358 + work.R_chassis_aux5_x_x*s9_353;
  const double s9_381 = s9_377*(s9_367 + work.R_chassis_aux5_y_x*s9_361) + s9_378*s9_379;
  const double s9_382 = s9_319 + work.R_chassis_aux5_y_x*s9_314;
  const double s9_383 = s9_381 + s9_380*(s9_366 + work.R_chassis_aux5_x_x*s9_361);
  const double s9_384 = work.R_chassis_z_y*s9_316 + work.R_chassis_z_z*s9_317 - s1_3*s9_314;
  const double s9_385 = work.R_chassis_z_y*s9_323 + work.R_chassis_z_z*s9_325 - s1_3*s9_321;
  const double s9_386 = s9_383 + s9_382*(s9_327 + work.R_chassis_aux5_y_x*s9_321);
  const double s9_387 = s9_318 + work.R_chassis_aux5_x_x*s9_314;
  const double s9_388 = s9_387*(s9_326 + work.R_chassis_aux5_x_x*s9_321);
  const double s9_389 = s9_188 + work.R_chassis_aux5_y_x*s9_183;
  const double s9_390 = s9_389*(s9_196 + work.R_chassis_aux5_y_x*s9_190);
  const double s9_391 = work.R_chassis_z_y*s9_185 + work.R_chassis_z_z*s9_186 - s1_3*s9_183;
  const double s9_392 = work.R_chassis_z_y*s9_192 + work.R_chassis_z_z*s9_194 - s1_3*s9_190;
  const double s9_393 = s9_187 + work.R_chassis_aux5_x_x*s9_183;
  const double s9_394 = s9_386 + s9_384*s9_385 + s9_388 + s9_390 + s9_391*s9_392;
  const double s9_395 = s9_206 + work.R_chassis_aux5_y_x*s9_201;
  const double s9_396 = s9_394 + s9_393*(s9_195 + work.R_chassis_aux5_x_x*s9_190);
  const double s9_397 = work.R_chassis_z_y*s9_203 + work.R_chassis_z_z*s9_204 - s1_3*s9_201;
  const double s9_398 = work.R_chassis_z_y*s9_210 + work.R_chassis_z_z*s9_212 - s1_3*s9_208;
  const double s9_399 = s9_396 + s9_395*(s9_214 + work.R_chassis_aux5_y_x*s9_208);
  const double s9_400 = s9_205 + work.R_chassis_aux5_x_x*s9_201;
  const double s9_401 = s9_400*(s9_213 + work.R_chassis_aux5_x_x*s9_208);
  const double s9_402 = work.s9_12*work.s9_12 + work.s9_13*work.s9_13 + work.s9_11*work.s9_11;
  const double s9_403 = s9_402 + work.s9_52*work.s9_52 + work.s9_53*work.s9_53;
  const double s9_404 = work.s9_19*work.s9_19 + work.s9_21*work.s9_21 + work.s9_17*work.s9_17;
  const double s9_405 = s9_404 + work.s9_58*work.s9_58 + work.s9_60*work.s9_60;
  const double s9_406 = s9_277 + work.R_chassis_y_z*s9_275 + work.R_chassis_aux5_y_x*s9_272;
  const double s9_407 = work.R_chassis_z_y*s9_282 + work.R_chassis_z_z*s9_284 - s1_3*s9_280;
  const double s9_408 = (s9_278 + work.R_chassis_z_z*s9_275 - s1_3*s9_272)*s9_407;
  const double s9_409 = s9_276 + work.R_chassis_x_z*s9_275 + work.R_chassis_aux5_x_x*s9_272;
  const double s9_410 = s9_406*(s9_286 + work.R_chassis_aux5_y_x*s9_280) + s9_408;
  const double s9_411 = s9_277 + work.R_chassis_y_z*s9_332 + work.R_chassis_aux5_y_x*s9_331;
  const double s9_412 = s9_410 + s9_409*(s9_285 + work.R_chassis_aux5_x_x*s9_280);
  const double s9_413 = work.R_chassis_z_y*s9_336 + work.R_chassis_z_z*s9_338 - s1_3*s9_334;
  const double s9_414 = s9_412 + s9_411*(s9_340 + work.R_chassis_aux5_y_x*s9_334);
  const double s9_415 = s9_276 + work.R_chassis_x_z*s9_332 + work.R_chassis_aux5_x_x*s9_331;
  const double s9_416 = s9_414 + (s9_278 + work.R_chassis_z_z*s9_332 - s1_3*s9_331)*s9_413;
  const double s9_417 = work.s9_29*work.s9_29 + work.s9_32*work.s9_32 + work.s9_26*work.s9_26;
  const double s9_418 = s9_417 + work.s9_68*work.s9_68 + work.s9_71*work.s9_71;
  const double s9_419 = work.s9_38*work.s9_38 + work.s9_39*work.s9_39 + work.s9_37*work.s9_37;
  const double s9_420 = s9_419 + work.s9_77*work.s9_77 + work.s9_78*work.s9_78;
  const double s9_421 = work.s9_118*work.s9_118 + work.s9_120*work.s9_120;
  const double s9_422 = s9_421 + work.s9_116*work.s9_116 + work.s9_136*work.s9_136;
  const double s9_423 = s9_241 + work.R_chassis_aux5_y_x*s9_236;
  const double s9_424 = work.R_chassis_z_y*s9_237 + work.R_chassis_z_z*s9_239 - s1_3*s9_236;
  const double s9_425 = work.R_chassis_z_y*s9_245 + work.R_chassis_z_z*s9_247 - s1_3*s9_243;
  const double s9_426 = s9_240 + work.R_chassis_aux5_x_x*s9_236;
  const double s9_427 = s9_423*(s9_249 + work.R_chassis_aux5_y_x*s9_243) + s9_424*s9_425;
  const double s9_428 = s9_258 + work.R_chassis_aux5_y_x*s9_253;
  const double s9_429 = s9_427 + s9_426*(s9_248 + work.R_chassis_aux5_x_x*s9_243);
  const double s9_430 = work.R_chassis_z_y*s9_254 + work.R_chassis_z_z*s9_256 - s1_3*s9_253;
  const double s9_431 = work.R_chassis_z_y*s9_262 + work.R_chassis_z_z*s9_264 - s1_3*s9_260;
  const double s9_432 = s9_429 + s9_428*(s9_266 + work.R_chassis_aux5_y_x*s9_260);
  const double s9_433 = s9_257 + work.R_chassis_aux5_x_x*s9_253;
  const double s9_434 = s9_433*(s9_265 + work.R_chassis_aux5_x_x*s9_260);
  const double s9_435 = s9_299 + work.R_chassis_y_z*s9_297 + work.R_chassis_aux5_y_x*s9_293;
  const double s9_436 = work.R_chassis_z_y*s9_304 + work.R_chassis_z_z*s9_306 - s1_3*s9_302;
  const double s9_437 = (s9_300 + work.R_chassis_z_z*s9_297 - s1_3*s9_293)*s9_436;
  const double s9_438 = s9_298 + work.R_chassis_x_z*s9_297 + work.R_chassis_aux5_x_x*s9_293;
  const double s9_439 = s9_435*(s9_308 + work.R_chassis_aux5_y_x*s9_302) + s9_437;
  const double s9_440 = s9_299 + work.R_chassis_y_z*s9_343 + work.R_chassis_aux5_y_x*s9_342;
  const double s9_441 = s9_439 + s9_438*(s9_307 + work.R_chassis_aux5_x_x*s9_302);
  const double s9_442 = work.R_chassis_z_y*s9_347 + work.R_chassis_z_z*s9_349 - s1_3*s9_345;
  const double s9_443 = s9_441 + s9_440*(s9_351 + work.R_chassis_aux5_y_x*s9_345);
  const double s9_444 = s9_298 + work.R_chassis_x_z*s9_343 + work.R_chassis_aux5_x_x*s9_342;
  const double s9_445 = s9_443 + (s9_300 + work.R_chassis_z_z*s9_343 - s1_3*s9_342)*s9_442;
  const double s9_446 = work.w_wheel_rear_right_y*work.s7_91;
  const double s9_447 = work.w_arb_rear_right_y*work.s7_98 + s9_446;
  const double s9_448 = s9_447 + work.w_wheel_rear_right_z*work.s7_94;
  const double s9_449 = s9_448 + work.w_wheel_rear_right_x*work.s7_88;
  const double s9_450 = s9_449 + work.w_arb_rear_left_y*work.s7_83;
  const double s9_451 = s9_450 + work.w_wheel_rear_left_y*work.s7_76;
  const double s9_452 = s9_451 + work.w_wheel_rear_left_z*work.s7_79;
  const double s9_453 = s9_452 + work.w_wheel_rear_left_x*work.s7_73;
  const double s9_454 = s9_453 + work.w_rear_axle_y*work.s7_68 + work.w_rear_axle_z*work.s7_70;
  const double s9_455 = s9_454 + work.w_rear_axle_x*work.s7_66 + work.w_bell_crank_z*work.s7_64;
  const double s9_456 = s9_455 + work.w_pitman_arm_y*work.s7_60;
  const double s9_457 = s9_456 + work.w_arb_front_right_y*work.s7_56;
  const double s9_458 = s9_457 + work.w_upper_arm_right_x*work.s7_50;
  const double s9_459 = s9_458 + work.w_wheel_front_right_y*work.s7_46;
  const double s9_460 = s9_459 + work.w_wheel_front_right_z*work.s7_49;
  const double s9_461 = s9_460 + work.w_wheel_front_right_x*work.s7_43;
  const double s9_462 = s9_461 + work.w_carrier_right_y*work.s7_38;
  const double s9_463 = s9_462 + work.w_carrier_right_z*work.s7_40;
  const double s9_464 = s9_463 + work.w_carrier_right_x*work.s7_36;
  const double s9_465 = s9_464 + work.w_lower_arm_right_x*work.s7_32;
  const double s9_466 = s9_465 + work.w_arb_front_left_y*work.s7_29;
  const double s9_467 = s9_466 + work.w_upper_arm_left_x*work.s7_23;
  const double s9_468 = s9_467 + work.w_wheel_front_left_y*work.s7_19;
  const double s9_469 = s9_468 + work.w_wheel_front_left_z*work.s7_22;
  const double s9_470 = s9_469 + work.w_wheel_front_left_x*work.s7_16;
  const double s9_471 = s9_470 + work.w_carrier_left_y*work.s7_11;
  const double s9_472 = s9_471 + work.w_carrier_left_z*work.s7_13;
  const double s9_473 = s9_472 + work.w_carrier_left_x*work.s7_9;
  const double s9_474 = s9_473 + work.w_lower_arm_left_x*work.s7_5;
  const double s9_475 = s9_474 + 13522.666666666668*work.s9_5 + 9.0*work.s9_92;
  const double s9_476 = 3.0*(s9_233 + s9_232*(s9_227 + work.R_chassis_aux5_x_x*s9_223));
  const double s9_477 = s9_475 + 16.666666666666668*work.s9_102 + 774.0*work.s9_112 + s9_476;
  const double s9_478 = work.w_chassis_x*(work.s7_96 + (work.s7_81 + s9_370));
  const double s9_479 = s9_477 + work.w_chassis_z*(work.s7_100 + s9_369) + s9_478;
  const double s9_480 = s9_376 + work.s9_83*work.s9_83 + work.s9_80*work.s9_80;
  const double s9_481 = s9_479 + work.w_chassis_y*(work.s7_63 + s9_371);
  const double s9_482 = 0.6666666666666666*(s9_399 + s9_397*s9_398 + s9_401);
  const double s9_483 = s9_481 + 8.666666666666666*s9_480 + s9_482;
  const double s9_484 = s9_483 + 25.0*(s9_403 + work.s9_51*work.s9_51);
  const double s9_485 = 6.0*(s9_416 + s9_415*(s9_339 + work.R_chassis_aux5_x_x*s9_334));
  const double s9_486 = s9_484 + 113.0*(s9_405 + work.s9_56*work.s9_56) + s9_485;
  const double s9_487 = s9_486 + 105.0*(s9_418 + work.s9_65*work.s9_65);
  const double s9_488 = 200.0*(s9_422 + work.s9_139*work.s9_139 + work.s9_133*work.s9_133);
  const double s9_489 = s9_487 + 15.0*(s9_420 + work.s9_76*work.s9_76) + s9_488;
  const double s9_490 = s9_445 + s9_444*(s9_350 + work.R_chassis_aux5_x_x*s9_345);
  const double s9_491 = s9_489 + 2.3333333333333335*(s9_432 + s9_430*s9_431 + s9_434);
  const double s9_492 = s9_198 - s9_328 + work.R_chassis_z_y*work.s1_466;
  const double s9_493 = work.R_chassis_z_z*(work.s1_467 - work.s1_469);
  const double s9_494 = s9_329 - s1_3*(work.s1_452 + work.s1_457) + s9_330;
  const double s9_495 = s9_494 + (s9_492 - s1_3*(work.s1_465 + work.s1_468) + s9_493);
  const double s9_496 = s9_199 - s1_3*(work.s1_373 + work.s1_381) + s9_200 + s9_495;
  const double s9_497 = s9_251 - s1_3*(work.s1_402 + work.s1_414) + s9_252;
  const double s9_498 = s9_289 + work.R_chassis_z_z*work.s1_435 - s1_3*work.s1_432;
  const double s9_499 = s9_498 + (s9_341 + work.R_chassis_z_z*work.s1_461 - s1_3*work.s1_459);
  const double s9_500 = s9_312 + work.R_chassis_z_z*work.s1_444 - s1_3*work.s1_440;
  const double s9_501 = s9_500 + (s9_352 + work.R_chassis_z_z*work.s1_464 - s1_3*work.s1_462);
  const double s9_502 = 13522.666666666668*work.s9_7 + 9.0*work.s9_94;
  const double s9_503 = s9_502 + 16.666666666666668*work.s9_105 + 774.0*work.s9_114;
  const double s9_504 = 9.81*(work.s9_85 + (work.s9_49 + (work.s9_130 + work.s9_146)));
  const double s9_505 = s9_503 + 1.5*(9.81*(s9_235 - s1_3*(work.s1_398 + work.s1_399)));
  const double s9_506 = 9.81*(s9_215 - s1_3*(work.s1_385 + work.s1_394) + s9_216 + s9_496);
  const double s9_507 = s9_505 + 8.666666666666666*s9_504 + 0.3333333333333333*s9_506;
  const double s9_508 = s9_507 + 25.0*(9.81*(work.s9_15 + work.s9_54));
  const double s9_509 = s9_508 + 113.0*(9.81*(work.s9_23 + work.s9_62));
  const double s9_510 = s9_509 + 105.0*(9.81*(work.s9_35 + work.s9_74));
  const double s9_511 = s9_510 + 15.0*(9.81*(work.s9_40 + work.s9_79));
  const double s9_512 = 9.81*(s9_497 + (s9_267 - s1_3*(work.s1_416 + work.s1_423) + s9_268));
  const double s9_513 = s9_511 + 200.0*(9.81*(work.s9_123 + work.s9_142));
  const double s9_514 = s9_513 + 1.1666666666666667*s9_512 + 3.0*(9.81*s9_499);
  result.potential_energy = s9_514 + 2.6666666666666665*(9.81*s9_501);
  result.kinetic_energy = 0.5*(s9_491 + 5.333333333333333*s9_490);
  // operations: 666 add, 682 multiply
}

/// Outputs, energies and power, at given accelerations.
void compute_outputs(const Parameters& /*parameters*/, const Inputs& /*inputs*/, const State& state,
    const double* tau, const Derivative& /*derivative*/, Outputs& __restrict result) noexcept {
  OutputsWork work;
  compute_outputs_1(state, work);
  compute_outputs_2(state, tau, work);
  compute_outputs_3(state, tau, work, result);
}


/// What the runtime's algorithms need to know of this model; see mbgen/solver.hpp.
struct System {
  using Parameters = coach_mechanism::Parameters;
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
  static constexpr double Parameters::*kParameterMember[] = {
      nullptr};
  static constexpr double Inputs::*kInputMember[] = {
      nullptr};
  static constexpr unsigned char kDriven[] = {
      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  static constexpr unsigned char kRedundant[] = {
      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  static constexpr int kDriveCoordinate[] = {
      0};
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

mbgen::Status assemble(const Parameters& parameters, const Inputs& inputs, State& state) noexcept {
  return mbgen::project_state<System>(parameters, inputs, state);
}

mbgen::Status accelerations(const Parameters& parameters, const Inputs& inputs, const State& state,
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

mbgen::Status step_rk4(const Parameters& parameters, const Inputs& inputs, State& state, double h) noexcept {
  return mbgen::step_rk4(Dynamics{parameters, inputs}, state, h);
}

mbgen::Status step_abm4(const Parameters& parameters, const Inputs& inputs, State& state, History& history,
                        double h) noexcept {
  return mbgen::step_abm4(Dynamics{parameters, inputs}, state, history, h);
}

mbgen::Status accelerations_in_motion(const Parameters& parameters, const Inputs& inputs, const State& state, double h,
                                      Derivative& derivative) noexcept {
  return mbgen::without_notice(mbgen::rates_in_motion(Dynamics{parameters, inputs}, state, h, derivative));
}

mbgen::Status outputs(const Parameters& parameters, const Inputs& inputs, const State& state,
                      const double (&tau)[kCoordinates], const Derivative& derivative,
                      Outputs& values) noexcept {
  const mbgen::Status status = mbgen::solver_detail::check_arguments<System>(parameters, inputs, state, tau);
  if (status.ok()) compute_outputs(parameters, inputs, state, tau, derivative, values);
  return status;
}

mbgen::Status multipliers(const Parameters& parameters, const Inputs& inputs, const State& state,
                          const double (&tau)[kCoordinates], const Derivative& derivative,
                          Multipliers& values) noexcept {
  return mbgen::solve_multipliers<System>(parameters, inputs, state, tau, derivative, values);
}

mbgen::Status closure_residual(const Parameters& parameters, const Inputs& inputs, const State& state,
                               ClosureResidual& residual) noexcept {
  return mbgen::closure_residuals<System>(parameters, inputs, state, residual);
}

const char* describe(mbgen::Status status) noexcept {
  return mbgen::name_of(status, {kCoordinateNames, kCoordinates}, {kLoopBlockNames, kLoopBlocks},
                        {kInputNames, kInputs}, {kParameterNames, kParameters},
                        {kAuxiliaryStateNames, kAuxiliaryStates});
}

}  // namespace coach_mechanism
