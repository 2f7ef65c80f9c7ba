// coach_mechanism, content hash f103c08ed05488f2
// Made by `mbgen generate coach_mechanism.json`, mbgen 0.1.0. Change the model, not this file.
#pragma once

#include "mbgen/integrators.hpp"
#include "mbgen/status.hpp"

/// Specialised solver of the multibody system "coach_mechanism". SI units, angles in radians.
/// Every function is re-entrant, allocates nothing, does a bounded amount of work and leaves its result
/// untouched unless its status is ok.
namespace coach_mechanism {

constexpr const char* kModel = "coach_mechanism";
constexpr const char* kHash = "f103c08ed05488f2";

constexpr int kCoordinates = 32;
constexpr int kAuxiliaryStates = 0;
constexpr int kBodies = 19;
constexpr int kInputs = 0;
constexpr int kOutputs = 0;
constexpr int kParameters = 0;
constexpr int kLoopBlocks = 2;
constexpr int kClosureEquations = 17;
constexpr int kMotions = 0;

/// Coordinates, in the order of z, zd, zdd and tau.
struct Coordinate {
  enum Index : int {
      chassis_tx, chassis_ty, chassis_tz, chassis_rz, chassis_ry, chassis_rx, lower_arm_left,
      carrier_left_rz, carrier_left_rx, carrier_left_ry, wheel_front_left, upper_arm_left,
      arb_front_left, lower_arm_right, carrier_right_rz, carrier_right_rx, carrier_right_ry,
      wheel_front_right, upper_arm_right, arb_front_right, pitman_arm, bell_crank, rear_axle_tx,
      rear_axle_ty, rear_axle_tz, rear_axle_rz, rear_axle_ry, rear_axle_rx, wheel_rear_left,
      arb_rear_left, wheel_rear_right, arb_rear_right};
};

/// Bodies of the model.
struct Body {
  enum Index : int {
      ground, chassis, lower_arm_left, carrier_left, wheel_front_left, upper_arm_left,
      arb_front_left, lower_arm_right, carrier_right, wheel_front_right, upper_arm_right,
      arb_front_right, pitman_arm, bell_crank, rear_axle, wheel_rear_left, arb_rear_left,
      wheel_rear_right, arb_rear_right};
};

/// Inputs, in the order of the model.
struct Input {
  enum Index : int {};
};

/// Outputs, in the order of the model.
struct Output {
  enum Index : int {};
};

/// Tunable parameters, in the order of the model; the others are folded into the code.
struct Parameter {
  enum Index : int {};
};

/// Groups of loops that share joints, each by the name of its first loop.
struct LoopBlock {
  enum Index : int {upper_ball_left, long_rod_left};
};

/// Names and units, indexed by the enumerations above.
inline constexpr const char* const kCoordinateNames[] = {
    "chassis_tx", "chassis_ty", "chassis_tz", "chassis_rz", "chassis_ry", "chassis_rx",
    "lower_arm_left", "carrier_left_rz", "carrier_left_rx", "carrier_left_ry", "wheel_front_left",
    "upper_arm_left", "arb_front_left", "lower_arm_right", "carrier_right_rz", "carrier_right_rx",
    "carrier_right_ry", "wheel_front_right", "upper_arm_right", "arb_front_right", "pitman_arm",
    "bell_crank", "rear_axle_tx", "rear_axle_ty", "rear_axle_tz", "rear_axle_rz", "rear_axle_ry",
    "rear_axle_rx", "wheel_rear_left", "arb_rear_left", "wheel_rear_right", "arb_rear_right"};
inline constexpr const char* const kCoordinateUnits[] = {
    "m", "m", "m", "rad", "rad", "rad", "rad", "rad", "rad", "rad", "rad", "rad", "rad", "rad",
    "rad", "rad", "rad", "rad", "rad", "rad", "rad", "rad", "m", "m", "m", "rad", "rad", "rad",
    "rad", "rad", "rad", "rad"};
inline constexpr const char* const kAuxiliaryStateNames[] = {
    ""};
inline constexpr const char* const kBodyNames[] = {
    "ground", "chassis", "lower_arm_left", "carrier_left", "wheel_front_left", "upper_arm_left",
    "arb_front_left", "lower_arm_right", "carrier_right", "wheel_front_right", "upper_arm_right",
    "arb_front_right", "pitman_arm", "bell_crank", "rear_axle", "wheel_rear_left", "arb_rear_left",
    "wheel_rear_right", "arb_rear_right"};
inline constexpr const char* const kInputNames[] = {
    ""};
inline constexpr const char* const kInputUnits[] = {
    ""};
inline constexpr const char* const kOutputNames[] = {
    ""};
inline constexpr const char* const kOutputUnits[] = {
    ""};
inline constexpr const char* const kParameterNames[] = {
    ""};
inline constexpr const char* const kParameterUnits[] = {
    ""};
inline constexpr const char* const kLoopBlockNames[] = {
    "upper_ball_left, upper_ball_right, arb_link_front_left, arb_link_front_right, drag_link, tie_rod_left, tie_rod_right",
    "long_rod_left, diag_rod_left, arb_link_rear_left, long_rod_right, diag_rod_right, arb_link_rear_right"};

/// Tunable parameters with the values of the model.
struct Parameters {
};

/// Argument type of the functions: no constants follow from the parameters.
using Tuned = Parameters;

/// Inputs with their defaults. They are constant during a step.
struct Inputs {
};

/// Everything that changes in time. Start from `State state = initial_state();`.
struct State {
  double z[kCoordinates];  ///< coordinates: rad or m, see kCoordinateUnits
  double zd[kCoordinates];  ///< their velocities
  double x[1];  ///< auxiliary states, see kAuxiliaryStateNames
  double t;  ///< s
  /// Charts of balls, changed by steps: where one is 1, z and zd of its ball are angles and rates of another
  /// chart, see in_users_angles. Put 0 there where you write angles of the model.
  double charts[4] = {};
};

/// Rates of a state that are not in the state itself.
struct Derivative {
  double zdd[kCoordinates];  ///< accelerations
  double xd[1];  ///< rates of the auxiliary states
};

/// Outputs of the model, and the terms of its energy balance.
struct Outputs {
  double kinetic_energy;  ///< J
  double potential_energy;  ///< J, of gravity
  double applied_power;  ///< W, of all applied forces but gravity
};

/// Forces of the constraints.
struct Multipliers {
  double lambda[17];  ///< of each closure equation, loop after loop
  double drive[1];  ///< generalised driving force of each motion: N m or N
};

/// How far the loops are from being closed, equation by equation, block after block.
struct ClosureResidual {
  double position[17];  ///< Phi: m, 1 for directions
  double velocity[17];  ///< Phi_z zd, the same per second
  double largest_position;  ///< largest absolute value
  double largest_velocity;
};

/// The state that the model starts from: its "initial" with loops closed and velocities consistent,
/// worked out by mbgen at the default parameters and inputs. At others assemble it; a static
/// equilibrium is then not looked for again.
State initial_state() noexcept;

/// Closes all loops by Newton from the state as a guess, sets driven coordinates to their motions
/// and makes the velocities consistent. Independent coordinates keep their positions and
/// velocities.
/// Fails: not_a_number, loop_not_closed, loop_singular.
mbgen::Status assemble(const Tuned& parameters, const Inputs& inputs, State& state) noexcept;

/// The state in the angles of the model, every chart 0; with its accelerations, where they are given. At
/// the pole of a ball its rates are finite and mean nothing: go on with the state itself.
State in_users_angles(const State& state) noexcept;
State in_users_angles(const State& state, Derivative& derivative) noexcept;

/// All accelerations at a consistent state. tau: generalised joint forces (N m or N) beside the
/// forces of the model.
/// Fails: not_a_number, loop_singular, no_inertia.
mbgen::Status accelerations(const Tuned& parameters, const Inputs& inputs, const State& state,
                            const double (&tau)[kCoordinates], Derivative& derivative) noexcept;

/// One step of h seconds by the classical Runge-Kutta method, then assembly. A status that is ok may
/// be a notice: chosen_again, near_singular, singular_met, turned_far.
/// Fails: as both, and step_invalid; loop_not_closed also when assembly would jump.
mbgen::Status step_rk4(const Tuned& parameters, const Inputs& inputs, State& state, double h) noexcept;

/// The solver at constant parameters and inputs as an integrator sees it: without joint forces from
/// outside.
struct Dynamics {
  using State = coach_mechanism::State;
  using Derivative = coach_mechanism::Derivative;
  const Tuned& parameters;
  const Inputs& inputs;
  mbgen::Status derivative(const State& state, Derivative& derivative) const noexcept;
  bool leaves_charts(const State& state) const noexcept;
  bool settle_charts(State& state) const noexcept;
  void change_charts(const State& from, const State& to, double (&z)[kCoordinates],
                     double (&zd)[kCoordinates], double (&zdd)[kCoordinates]) const noexcept;
  mbgen::Status project(State& state) const noexcept;
  mbgen::Status project_nearest(State& state) const noexcept;
  mbgen::Status project(State& state, int& closures) const noexcept;
  mbgen::Status project_nearest(State& state, int& closures) const noexcept;
  mbgen::Status project_crossing(State& state, double& clearance, int& closures) const noexcept;
  int changed_side(const State& from, const State& to) const noexcept;
  mbgen::Status watch_way(const State& from, const State& to, double h,
                          const mbgen::WayLimits& limits) const noexcept;
  using Passage = mbgen::Passage<double, kCoordinates, kLoopBlocks, 58>;
  mbgen::Status rates_near(const State& state, Derivative& derivative) const noexcept;
  mbgen::Status look_across(const State& state, double h, Passage& passage) const noexcept;
  bool close_across(Passage& passage, State& state) const noexcept;
  mbgen::Status rates_across(const Passage& passage, const State& state, Derivative& derivative) const noexcept;
};

/// Accelerations of a state that steps of h seconds led to, without joint forces from outside: at a
/// singular position the accelerations of the motion through it.
/// Fails: as accelerations.
mbgen::Status accelerations_in_motion(const Tuned& parameters, const Inputs& inputs, const State& state, double h,
                                      Derivative& derivative) noexcept;

/// Rates of the last steps for step_abm4. Start with `History history{};`, and again when state or inputs were
/// changed from outside.
using History = mbgen::AbmHistory<Dynamics>;

/// One step of h seconds by Adams-Bashforth-Moulton of order four with two evaluations, started up
/// by Runge-Kutta, then assembly.
/// Gives notices and fails as step_rk4.
mbgen::Status step_abm4(const Tuned& parameters, const Inputs& inputs, State& state, History& history,
                        double h) noexcept;

/// Outputs, energies and power at a state and its accelerations. An output that is not finite is
/// given as it is.
/// Fails: not_a_number for the arguments.
mbgen::Status outputs(const Tuned& parameters, const Inputs& inputs, const State& state,
                      const double (&tau)[kCoordinates], const Derivative& derivative,
                      Outputs& values) noexcept;

/// Forces of the constraints at a state and its accelerations. Of redundant equations only the sum
/// of their effects is unique; those left out of the frozen path get zero.
/// Fails: not_a_number, loop_singular.
mbgen::Status multipliers(const Tuned& parameters, const Inputs& inputs, const State& state,
                          const double (&tau)[kCoordinates], const Derivative& derivative,
                          Multipliers& values) noexcept;

/// Closure residuals of a state. Fails: not_a_number for the arguments.
mbgen::Status closure_residual(const Tuned& parameters, const Inputs& inputs, const State& state,
                               ClosureResidual& residual) noexcept;

/// Name of the coordinate, loops, input, parameter or auxiliary state that a status names, "" when it
/// names none. See mbgen::text for its code.
const char* describe(mbgen::Status status) noexcept;

}  // namespace coach_mechanism
