// pulled_wheel, content hash b0d917ec774bd98f
// Made by `mbgen generate pulled_wheel.json`, mbgen 0.1.0. Change the model, not this file.
#pragma once

#include "mbgen/integrators.hpp"
#include "mbgen/status.hpp"

/// Specialised solver of the multibody system "pulled_wheel". SI units, angles in radians.
/// Every function is re-entrant, allocates nothing, does a bounded amount of work and leaves its result
/// untouched unless its status is ok.
namespace pulled_wheel {

constexpr const char* kModel = "pulled_wheel";
constexpr const char* kHash = "b0d917ec774bd98f";

constexpr int kCoordinates = 4;
constexpr int kAuxiliaryStates = 2;
constexpr int kBodies = 6;
constexpr int kInputs = 0;
constexpr int kOutputs = 4;
constexpr int kParameters = 2;
constexpr int kLoopBlocks = 1;
constexpr int kClosureEquations = 1;
constexpr int kMotions = 1;

/// Coordinates, in the order of z, zd, zdd and tau.
struct Coordinate {
  enum Index : int {pull, lower, ball, wheel};
};

/// Bodies of the model.
struct Body {
  enum Index : int {ground, carriage, arm, knuckle, ballast, wheel};
};

/// Inputs, in the order of the model.
struct Input {
  enum Index : int {};
};

/// Outputs, in the order of the model.
struct Output {
  enum Index : int {load, wheel_speed, hub_height, spring_force};
};

/// Tunable parameters, in the order of the model; the others are folded into the code.
struct Parameter {
  enum Index : int {k, ballast};
};

/// Groups of loops that share joints, each by the name of its first loop.
struct LoopBlock {
  enum Index : int {upper};
};

/// Names and units, indexed by the enumerations above.
inline constexpr const char* const kCoordinateNames[] = {
    "pull", "lower", "ball", "wheel"};
inline constexpr const char* const kCoordinateUnits[] = {
    "m", "rad", "rad", "rad"};
inline constexpr const char* const kAuxiliaryStateNames[] = {
    "tyre_u", "tyre_v"};
inline constexpr const char* const kBodyNames[] = {
    "ground", "carriage", "arm", "knuckle", "ballast", "wheel"};
inline constexpr const char* const kInputNames[] = {
    ""};
inline constexpr const char* const kInputUnits[] = {
    ""};
inline constexpr const char* const kOutputNames[] = {
    "load", "wheel_speed", "hub_height", "spring_force"};
inline constexpr const char* const kOutputUnits[] = {
    "N", "rad/s", "m", "N"};
inline constexpr const char* const kParameterNames[] = {
    "k", "ballast"};
inline constexpr const char* const kParameterUnits[] = {
    "N/m", "kg"};
inline constexpr const char* const kLoopBlockNames[] = {
    "upper"};

/// Tunable parameters with the values of the model.
struct Parameters {
  double k = 24000.0;  ///< N/m
  double ballast = 6.0;  ///< kg
};

/// Tunable parameters with the 7 constants that follow from them. Functions take plain Parameters
/// as well, and then work these out each time: keep one of these, and assign Parameters to it where
/// they change, at the boundary of a step. Among them: [1] m_knuckle, [3] c_knuckle_z, [4]
/// m_knuckle_2, [5] I_knuckle_yy.
struct Tuned : Parameters {
  double derived[7];
  Tuned() noexcept : Tuned(Parameters{}) {}
  Tuned(const Parameters& parameters) noexcept;
};

/// Inputs with their defaults. They are constant during a step.
struct Inputs {
};

/// Everything that changes in time. Start from `State state = initial_state();`.
struct State {
  double z[kCoordinates];  ///< coordinates: rad or m, see kCoordinateUnits
  double zd[kCoordinates];  ///< their velocities
  double x[2];  ///< auxiliary states, see kAuxiliaryStateNames
  double t;  ///< s
};

/// Rates of a state that are not in the state itself.
struct Derivative {
  double zdd[kCoordinates];  ///< accelerations
  double xd[2];  ///< rates of the auxiliary states
};

/// Outputs of the model, and the terms of its energy balance.
struct Outputs {
  double load;  ///< N
  double wheel_speed;  ///< rad/s
  double hub_height;  ///< m
  double spring_force;  ///< N
  double kinetic_energy;  ///< J
  double potential_energy;  ///< J, of gravity
  double applied_power;  ///< W, of all applied forces but gravity
};

/// Forces of the constraints.
struct Multipliers {
  double lambda[1];  ///< of each closure equation, loop after loop
  double drive[1];  ///< generalised driving force of each motion: N m or N
};

/// How far the loops are from being closed, equation by equation, block after block.
struct ClosureResidual {
  double position[1];  ///< Phi: m, 1 for directions
  double velocity[1];  ///< Phi_z zd, the same per second
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
  using State = pulled_wheel::State;
  using Derivative = pulled_wheel::Derivative;
  const Tuned& parameters;
  const Inputs& inputs;
  mbgen::Status derivative(const State& state, Derivative& derivative) const noexcept;
  mbgen::Status project(State& state) const noexcept;
  mbgen::Status project_nearest(State& state) const noexcept;
  mbgen::Status project(State& state, int& closures) const noexcept;
  mbgen::Status project_nearest(State& state, int& closures) const noexcept;
  mbgen::Status project_crossing(State& state, double& clearance, int& closures) const noexcept;
  int changed_side(const State& from, const State& to) const noexcept;
  mbgen::Status watch_way(const State& from, const State& to, double h,
                          const mbgen::WayLimits& limits) const noexcept;
  using Passage = mbgen::Passage<double, kCoordinates, kLoopBlocks, 2>;
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

}  // namespace pulled_wheel
