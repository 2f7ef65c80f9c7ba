#pragma once
// A motion from a state, step by step, with facts for its summary.

#include <functional>
#include <vector>

#include "workbench/engines/engine.hpp"
#include "workbench/motion/inputs_over_time.hpp"

namespace mbgen {

struct SimulationSettings {
  long steps = 0;
  double step = 0;                   ///< s
  bool has_multipliers = false;      ///< the samples are to have them
  bool is_error_controlled = false;  ///< the engine chooses its own steps inside of these
  /// Whether a point is to be a sample; none: all are. Where some are not, they are stepped over, and the summary has
  /// no energies. Requires: no control.
  std::function<bool(long step)> is_sample = {};
  std::function<bool()> is_stopped = {};  ///< asked after every point: whether somebody wants the motion to end there
};

/// One point of the motion.
struct Sample {
  long step = 0;               ///< 0 at the start
  GenericState state;          ///< in the angles of the model
  GenericState moving;         ///< the same as the steps have it, in the charts of its balls
  std::vector<double> inputs;  ///< of the model, at its time
  GenericOutputs outputs;
  Residuals residuals;
  std::vector<double> multipliers;  ///< in the order of Topology::loops, where the settings ask for them
};

/// Smallest, largest and last value of one output.
struct Range {
  double smallest = 0, largest = 0, last = 0;
};

/// Energy along the motion. In a correct solution, kinetic + potential energy changes by the work of the applied
/// forces.
struct EnergyBalance {
  double change = 0;  ///< J, of kinetic energy and potential energy of gravity
  double work = 0;    ///< J, of all other applied forces and drives, integrated by Simpson's rule
  /// J, largest of |change|, |work| and kinetic energy along the motion, or the exchanged energy (ExchangeMeter)
  double scale = 0;
  double net = 0;    ///< J, largest of |change| and |work| along the way
  double level = 0;  ///< J, largest kinetic + potential energy along the way, as the model counts it
  double error() const { return change - work; }
  double relative_error() const { return scale > 0 ? error() / scale : 0; }
};

/// Number of passages of singular positions that are listed with their times.
constexpr std::size_t kSingularTimes = 10;

/// Events at one loop block, by the notices of the steps.
struct BlockEvents {
  long chosen_again = 0;               ///< steps with another choice of coordinates, not near a singular position
  long near_singular = 0;              ///< steps near a singular position, those through one too
  long singular_met = 0;               ///< singular positions that were passed
  std::vector<double> singular_times;  ///< s, of the first kSingularTimes of them
};

/// Relative difference of energies that is due to rounding.
constexpr double kRoundedEnergy = 1e-9;
/// Speed of a body at rest due to rounding, rad/s or m/s.
constexpr double kAtRest = 1e-9;

struct SimulationSummary {
  long steps = 0;             ///< that succeeded
  double end_time = 0;        ///< s, of the last good state
  double solver_seconds = 0;  ///< wall time inside the integrator
  double wall_seconds = 0;    ///< wall time of everything
  Residuals largest;          ///< over all points
  EnergyBalance energy;
  std::vector<Range> outputs;
  std::vector<Range> inputs;        ///< as applied at the points
  double largest_velocity = 0;      ///< of all coordinates, rad/s or m/s
  int fastest = -1;                 ///< the coordinate that had it
  GenericState last;                ///< the last good state
  std::vector<BlockEvents> blocks;  ///< per loop block, as far as anything was met
  long parted_steps = 0;            ///< that were made in parts, see step_motion
  double first_parted = 0;          ///< s, the end of the first of them
  Status status;                    ///< of the step that failed, or ok
  bool is_stopped = false;          ///< before its end, as the settings say
  /// Whether energy beyond rounding was exchanged: otherwise the relative error of the balance has no meaning.
  bool exchanges_energy() const { return energy.scale > kRoundedEnergy * energy.level && largest_velocity > kAtRest; }
  /// For a failed step: a shorter one, s, with which the motion continues from the last good state; 0 if none was
  /// found.
  double passable_step = 0;
};

/// One step of h seconds to the time `end`, with its given inputs and the inputs at its end. Where laws of time have an
/// instant in the step or at its ends, and where a held input jumps in it, the step is made in parts, each on one side
/// of the instant; a model with sampled values is stepped as a whole. in_parts: whether it was made in parts. The state
/// is unchanged on failure.
Status step_motion(const Engine& engine, const InputsOverTime& inputs, double h, double end, GenericState& state,
                   bool& in_parts);

/// Sets the courses of inputs from a point of the motion on, before the step that starts there. Result: false to end
/// the motion at this point.
using InputControl = std::function<bool(const Sample&, InputsOverTime&)>;

/// Steps the engine from `state`; the time of point k is the start plus k times the step. on_sample receives every
/// point, including the start. If inputs change, the state is projected after each step with the inputs of its time.
/// When a step fails, the motion ends at the last good state, and the summary has the reason. control, if given, is
/// called at every point.
SimulationSummary simulate(const Engine& engine, const GenericState& state, const InputsOverTime& inputs,
                           const SimulationSettings& settings, const std::function<void(const Sample&)>& on_sample,
                           const InputControl& control = {});

}  // namespace mbgen
