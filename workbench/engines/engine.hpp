#pragma once
// An engine: the equations of one model ready to be evaluated and stepped, by any implementation.

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/compile.hpp"
#include "mbgen/solver/step_clock.hpp"
#include "mbgen/status.hpp"
#include "runtime/generic/generic.hpp"
#include "runtime/judges/cartesian.hpp"

namespace mbgen {

/// A state and the joint forces that act in it.
struct LoadedState {
  GenericState state;
  std::vector<double> tau;  ///< per coordinate, N or N m
};

/// Largest absolute closure residuals of a state.
struct Residuals {
  double position = 0;  ///< m or 1
  double velocity = 0;  ///< m/s or 1/s
};

/// The functions of one model. Arrays in the order of the model. Not for use by several threads at once.
struct Engine {
  std::string name;             ///< as on the command line
  std::string form;             ///< of the equations, for tables
  std::string linear_algebra;   ///< library behind it, "" for code of its own
  int batch = 1;                ///< states that one call for accelerations takes
  bool follows_motion = false;  ///< its steps carry more than a state: nobody steps beside the motion

  /// Balls of the model whose charts steps change, for settle_charts and in_users_angles; none of a judge, whose states
  /// are in the angles of the model.
  std::vector<Ball> balls;

  /// All accelerations. The derivative keeps its values unless the status is ok.
  std::function<Status(const LoadedState&, GenericDerivative&)> accelerations;
  /// Closes the loops, sets the driven coordinates, makes velocities consistent. The state is unchanged on failure.
  std::function<Status(GenericState&)> project;
  /// One step of h seconds of the chosen integrator, projected; the only function that gives notices. The state is
  /// unchanged on failure.
  /// Requires: each call continues where the one before ended (a multistep method remembers).
  std::function<Status(GenericState&, double h)> step;
  /// Accelerations of a state that steps of h seconds led to, without joint forces: at a singular position those of the
  /// motion through it. The derivative keeps its values unless the status is ok.
  std::function<Status(const GenericState&, double h, GenericDerivative&)> accelerations_in_motion;
  /// Sets the sampled values that are due at the start of a step of h seconds, as steps do, or with h = 0 the values
  /// due at the time of the state; any: whether there are such. The state is unchanged on failure. Empty function
  /// without sampled values.
  std::function<Status(GenericState&, double h, bool& any)> sample;
  /// Sets the reactions that press frictions at the start, of engines that find reactions by equations of their own; of
  /// others an empty function.
  std::function<Status(GenericState&)> set_friction_loads;
  /// Multipliers in the order of Topology::loops and their equations.
  std::function<Status(const LoadedState&, const GenericDerivative&, std::vector<double>& lambda)> multipliers;
  /// Generalised driving force of each motion, N or N m: its product with the rate of the coordinate is the power that
  /// the drive puts into the system.
  std::function<Status(const LoadedState&, const GenericDerivative&, std::vector<double>& drive)> driving_forces;
  std::function<Status(const LoadedState&, const GenericDerivative&, GenericOutputs&)> outputs;
  /// Forces of the actuators for the accelerations of the independent coordinates in the derivative, whose zdd become
  /// all accelerations; both are unchanged on failure. Empty function without has_inverse_dynamics.
  std::function<Status(const LoadedState&, GenericDerivative&, std::vector<double>& force)> inverse_dynamics;
  /// Action of each joint of the model, then of each rod, on its `to` body: force (N) and moment (N m) about the
  /// joint's point on that body, global axes. Empty function where nobody asked.
  std::function<Status(const LoadedState&, const GenericDerivative&, std::vector<std::array<double, 6>>& wrenches)>
      reactions;
  std::function<Status(const GenericState&, Residuals&)> residuals;
  /// Values of all inputs from now on; a step begins with them and advances the inputs that have derivatives. A
  /// multistep method starts up anew.
  std::function<void(const std::vector<double>&)> set_inputs;
  /// Evaluates the accelerations of every state, `repetitions` times over. Result: how many evaluations failed.
  std::function<long long(const std::vector<LoadedState>&, int repetitions)> time_accelerations;
  /// Shares of the nine steps of the paper's tables in the time of one evaluation, over the same calls; empty function
  /// where the engine has no such steps.
  std::function<std::array<double, kSteps>(const std::vector<LoadedState>&, int repetitions)> step_shares;
  /// Wall time, s, that calls have spent so far on compiling and loading a solver; empty where none does.
  std::function<double()> loading_seconds;
};

/// Purpose of a compiled solver.
enum class SolverUse {
  running,       ///< everything but the purposes below: without lanes compiled in less time, a few percent slower
  timing,        ///< compiled as the emitted CMakeLists.txt compiles it
  timing_steps,  ///< likewise, and with Engine::step_shares
  derivatives,   ///< the solver with derivatives, for load_tangents; no Engine has it
  regular,       ///< running, of regular positions alone, see load_regular_solver; of no choice of an Engine
};

/// Which engine, and how.
struct EngineChoice {
  std::string name = "generated";
  SolverSettings::Integrator integrator = SolverSettings::Integrator::rk4;
  GenericAlgebra algebra;                                   ///< of the generic engine
  Stabilisation stabilisation = Stabilisation::projection;  ///< of the Cartesian engines
  SolverUse use = SolverUse::running;
  std::optional<Form> form = {};  ///< of the generated engine, none for the shorter one
  int lanes = 0;                  ///< of the generated engine: accelerations in batches of so many, 0 for one by one
  bool use_cache = true;          ///< keep compiled solvers for the next time
};

/// Names of the engines there are.
const std::vector<std::string>& engine_names();

/// Fails: UserError with the names there are, for another one.
void require_engine(const std::string& name);

/// Whether an engine is one of the Cartesian judges, which integrate by rk4 and have a stabilisation; the others work
/// in relative coordinates and integrate by every integrator.
bool is_cartesian(const std::string& name);

/// The engine of this name. Fails: UserError for a name that is unknown, or when the solver cannot be compiled.
Engine make_engine(const Compilation& compilation, const EngineChoice& choice);

/// The un-specialised algorithm of runtime/generic.
Engine make_generic_engine(const Compilation& compilation, const EngineChoice& choice);

/// The specialised solver: emitted, compiled, loaded. Fails: UserError, see load_solver.
Engine make_generated_engine(const Compilation& compilation, const EngineChoice& choice);

/// A Cartesian judge, see docs/method/judges.md.
Engine make_cartesian_engine(const Compilation& compilation, const EngineChoice& choice, CartesianMethod method);

/// Words for a status, with the names of its loops or coordinates: "loop not closed: rod_left, tip".
std::string describe(const Compilation& compilation, Status status);

}  // namespace mbgen
