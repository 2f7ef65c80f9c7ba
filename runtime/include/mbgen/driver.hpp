#pragma once
// The table through which mbgen drives a compiled solver that it loaded: plain functions over plain double arrays.

#include "mbgen/solver/step_clock.hpp"
#include "mbgen/status.hpp"

namespace mbgen {

/// Layout of SolverTable; a loaded library with another number was made by another mbgen.
constexpr int kSolverTableLayout = 9;

/// Sizes and functions of one generated solver. Arrays, all in SI units and in the order of the model:
///   parameters  the tunable ones                 inputs   all of them
///   state       z[n] zd[n] x[nx] t charts[balls] derivative   zdd[n] xd[nx]
///   tau         n generalised joint forces beside the forces of the model
/// Number: double, or numbers with derivatives (tangents.hpp). Every function is re-entrant, allocates nothing and
/// leaves its results untouched unless the status is ok. Steps give notices.
template <class Number>
struct SolverTableOf {
  int layout;            ///< kSolverTableLayout
  const char* model;     ///< name of the model
  const char* hash;      ///< content hash of the model, 16 hex digits
  int coordinates;       ///< n
  int auxiliary_states;  ///< nx
  int state_size;        ///< 2 n + nx + 1 and the number of balls with charts
  int derivative_size;   ///< n + nx
  int parameters;
  int inputs;
  int outputs;
  int multipliers;        ///< one per closure equation
  int drives;             ///< one per motion
  int closure_equations;  ///< position residuals
  int loop_blocks;
  long history_bytes;  ///< size of the buffer that start_abm4 and step_abm4 work on, aligned as a Number

  const double* default_parameters;
  const double* default_inputs;

  /// All accelerations at a state.
  Status (*accelerations)(const Number* parameters, const Number* inputs, const Number* state, const Number* tau,
                          Number* derivative) noexcept;

  /// Closes the loops by Newton from the state as a guess, sets driven coordinates, makes the velocities consistent.
  Status (*project)(const Number* parameters, const Number* inputs, Number* state) noexcept;

  /// One step of h seconds, with projection at its end; tau is zero.
  Status (*step_rk4)(const Number* parameters, const Number* inputs, Number* state, double h) noexcept;

  /// Empties a history: the next steps start up by Runge-Kutta.
  void (*start_abm4)(void* history) noexcept;
  Status (*step_abm4)(const Number* parameters, const Number* inputs, Number* state, void* history, double h) noexcept;

  /// One linearly implicit step; null in a solver without it.
  Status (*step_rosenbrock)(const Number* parameters, const Number* inputs, Number* state, double h) noexcept;

  /// Accelerations of a state that steps of h seconds led to; tau is zero.
  Status (*accelerations_in_motion)(const Number* parameters, const Number* inputs, const Number* state, double h,
                                    Number* derivative) noexcept;

  /// Sets the sampled values that are due at the start of a step of h seconds, as steps do, or with h = 0 the values
  /// due at the time of the state; any: whether there are such. Null without sampled values.
  Status (*sample)(const Number* parameters, const Number* inputs, Number* state, double h, bool* any) noexcept;

  /// Outputs y[outputs] and energy[3]: kinetic (J), potential of gravity (J), power of the other applied forces (W).
  Status (*output_values)(const Number* parameters, const Number* inputs, const Number* state, const Number* tau,
                          const Number* derivative, Number* y, Number* energy) noexcept;

  /// Multipliers lambda[multipliers] and generalised driving forces drive[drives].
  Status (*multiplier_values)(const Number* parameters, const Number* inputs, const Number* state, const Number* tau,
                              const Number* derivative, Number* lambda, Number* drive) noexcept;

  int actuators;  ///< with inverse dynamics, 0 for a solver without; the functions of it are null then

  /// Forces force[actuators] for the accelerations of the independent coordinates in `derivative`, whose zdd become all
  /// accelerations.
  Status (*actuator_forces)(const Number* parameters, const Number* inputs, const Number* state, const Number* tau,
                            Number* derivative, Number* force) noexcept;

  /// Position residuals Phi and velocity residuals Phi_z zd, closure_equations of each, block after block.
  Status (*residuals)(const Number* parameters, const Number* inputs, const Number* state, Number* position,
                      Number* velocity) noexcept;

  /// Name of the coordinate or loop block that a status names, "" when it names none.
  const char* (*describe)(Status status) noexcept;

  /// Evaluates accelerations at each of `count` states (state after state, tau after tau), `repetitions` times, for
  /// the caller's clock. Result: evaluations that were not ok. Sixteen states are in turn, so that each evaluation
  /// meets data that the one before did not.
  long long (*time_accelerations)(const Number* parameters, const Number* inputs, const Number* states,
                                  const Number* taus, int count, int repetitions) noexcept;

  /// Ticks spent in each of the nine steps of the paper's tables over the same evaluations, ticks[kSteps]; null in a
  /// driver without step clock. The steps belong to the frozen partition.
  void (*step_ticks)(const Number* parameters, const Number* inputs, const Number* states, const Number* taus,
                     int count, int repetitions, long long* ticks) noexcept;

  int lanes;  ///< instances of a batch, 0 for a solver without batch interface; the functions that follow are null then

  /// All accelerations of `lanes` states (state after state, tau after tau). Results of a state are untouched unless
  /// its status is ok.
  void (*batch_accelerations)(const Number* parameters, const Number* inputs, const Number* states, const Number* taus,
                              Number* derivatives, Status* statuses) noexcept;

  /// Forces of the actuators at `lanes` states, likewise: derivatives (in and out) and forces state after state.
  void (*batch_actuator_forces)(const Number* parameters, const Number* inputs, const Number* states,
                                const Number* taus, Number* derivatives, Number* forces, Status* statuses) noexcept;

  /// As time_accelerations, batch after batch; the last one is filled up with the last state.
  long long (*time_batch_accelerations)(const Number* parameters, const Number* inputs, const Number* states,
                                        const Number* taus, int count, int repetitions) noexcept;

  /// Closes the loops while the coordinates with a flag of 1 are held, see assemble_holding of a solver with
  /// derivatives; null in other solvers.
  Status (*project_holding)(const Number* parameters, const Number* inputs, const unsigned char* held,
                            Number* state) noexcept;

  bool regular_only;  ///< whether calls may fail with kNotRegular, see solver/regular.hpp
};

using SolverTable = SolverTableOf<double>;

}  // namespace mbgen

/// The only symbol that a compiled driver exports.
extern "C" const mbgen::SolverTable* mbgen_solver_table();
