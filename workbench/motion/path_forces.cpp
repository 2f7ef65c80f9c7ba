#include "workbench/motion/path_forces.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <utility>

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/element_access.hpp"
#include "compiler/text/user_error.hpp"
#include "mbgen/sampling.hpp"
#include "runtime/generic/generic.hpp"
#include "workbench/describe/names.hpp"
#include "workbench/host/files.hpp"
#include "workbench/motion/inverse_motion.hpp"

namespace mbgen {
namespace {

/// Rows of a table along a path, which are kept until the last one is known.
constexpr double kMostRows = 5e6;

constexpr const char* kActuatorColumn = "actuator.";
constexpr const char* kBeyond = "beyond_limit";
/// Parts of the way from the start of the model to the start of a path.
constexpr int kApproach = 64;
/// Error of auxiliary states in a step along a path, of their magnitudes; shortest step, s.
constexpr double kStateError = 1e-7, kShortestStep = 1e-10;
/// Limits of the change of this step, and the part of the step that its error allows.
constexpr double kLeastChange = 0.2, kMostChange = 5, kSafety = 0.9;

std::vector<CoordinateTarget> targets_at(const std::vector<int>& coordinates, const std::vector<Course>& courses,
                                         double t) {
  std::vector<CoordinateTarget> targets;
  for (std::size_t i = 0; i < coordinates.size(); ++i) targets.push_back({coordinates[i], courses[i].at(t), 1, true});
  return targets;
}

/// Follows a path with the loops of a mechanism closed.
class PathFollower {
 public:
  PathFollower(const PathOfCoordinates& path, const Engine& engine, const Compilation& compilation,
               const InputsOverTime& inputs)
      : path_(path),
        engine_(engine),
        compilation_(compilation),
        inputs_(inputs),
        poses_(compilation.model, compilation.topology, compilation.analysis) {
    for (const AuxiliaryState& state : auxiliary_states(compilation.model)) magnitudes_.push_back(magnitude_of(state));
    for (const SampledValue& value : compilation.model.sampled) periods_.push_back(value.period);
  }

  /// Moves a state to the start of the path, part by part of the way.
  void approach(GenericState& state) {
    state.t = path_.start;
    poses_.set_inputs(inputs_.at(state.t));
    std::fill(state.zd.begin(), state.zd.end(), 0.0);
    const GenericState from = state;
    for (int part = 1; part <= kApproach; ++part) {
      std::vector<CoordinateTarget> targets = targets_at(path_.coordinates, path_.positions, path_.start);
      for (CoordinateTarget& target : targets) {
        const double begin = from.z[static_cast<std::size_t>(target.coordinate)];
        target.value = begin + (target.value - begin) * part / kApproach;
      }
      if (const Status status = poses_.assemble(state, targets); !status.ok())
        stop(describe(compilation_, status), state.t);
    }
    if (periods_.empty()) return;
    motion_at(state);
    sample(state);
  }

  /// Moves a state along the path to an instant: its auxiliary states change at their rates in the motion of the path,
  /// and sampled values are set at their instants.
  void advance(GenericState& state, double t) {
    if (magnitudes_.empty()) return;
    while (t - state.t > same_instant(t)) {
      const double next = next_instant(periods_.data(), static_cast<int>(periods_.size()), state.t);
      integrate(state, std::min(t, next));
      if (next <= t) sample(state);
    }
  }

  /// Coordinates, all outputs, and how far forces are beyond their limits, at an instant; `state` belongs to an instant
  /// shortly before.
  std::vector<double> row_at(double t, GenericState& state) {
    state.t = t;
    const auto [at, motion] = motion_at(state);
    GenericOutputs outputs;
    const Status status = engine_.outputs(at, motion.derivative, outputs);
    if (!status.ok()) stop(describe(compilation_, status), t);
    const int side = poses_.side_of_actuators(state);
    if (side * side_ < 0) stop("actuators pass a singular position between the row before and the one", t);
    side_ = side;
    std::vector<double> row = state.z;
    row.insert(row.end(), outputs.y.begin(), outputs.y.end());
    const std::vector<double> beyond = beyond_limits(compilation_.model, motion.force);
    for (std::size_t i = 0; i < beyond.size(); ++i)
      if (compilation_.model.actuators[i].limit) row.push_back(beyond[i]);
    return row;
  }

 private:
  /// The state of the path at an instant, and its forces, which become inputs.
  struct ForcedState {
    LoadedState at;
    InverseMotion motion;
  };

  /// Closes the loops of a state on the path at its time, and finds the forces.
  ForcedState motion_at(GenericState& state) {
    const double t = state.t;
    std::vector<double> given_inputs = inputs_.at(t);
    poses_.set_inputs(given_inputs);
    std::fill(state.zd.begin(), state.zd.end(), 0.0);
    Status status = poses_.assemble(state, targets_at(path_.coordinates, path_.positions, t));
    if (status.ok()) status = poses_.assemble_velocities(state, targets_at(path_.coordinates, path_.rates, t));
    if (!status.ok()) stop(describe(compilation_, status), t);
    std::vector<double> given(state.z.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < path_.coordinates.size(); ++i)
      given[static_cast<std::size_t>(path_.coordinates[i])] = path_.accelerations[i].at(t);
    ForcedState forced{{state, std::vector<double>(state.z.size(), 0.0)}, {}};
    engine_.set_inputs(given_inputs);
    forced.motion = actuator_forces(engine_, compilation_, given_inputs, forced.at, given);
    if (!forced.motion.ok()) stop(describe(compilation_, forced.motion), t, hint_of(forced.motion));
    for (std::size_t i = 0; i < forced.motion.force.size(); ++i)
      if (const int input = compilation_.model.actuators[i].input; input >= 0)
        given_inputs[static_cast<std::size_t>(input)] = forced.motion.force[i];
    engine_.set_inputs(given_inputs);
    poses_.set_inputs(given_inputs);
    return forced;
  }

  /// Sets the sampled values that are due. Requires: motion_at the state, whose forces are inputs.
  void sample(GenericState& state) {
    bool any = false;
    if (const Status status = poses_.sample(state, 0, any); !status.ok()) stop(describe(compilation_, status), state.t);
  }

  /// Rates of the auxiliary states on the path, `step` seconds after a state, whose own have changed by so much.
  std::vector<double> rates(const GenericState& from, double step, const std::vector<double>& change) {
    GenericState state = from;
    state.t += step;
    for (std::size_t i = 0; i < change.size(); ++i) state.x[i] += change[i];
    const ForcedState forced = motion_at(state);
    GenericDerivative derivative;
    if (const Status status = poses_.accelerations(state, forced.at.tau, derivative); !status.ok())
      stop(describe(compilation_, status), state.t);
    derivative.xd.resize(state.x.size(), 0.0);
    return derivative.xd;
  }

  /// Steps of variable length to an instant, and motion_at it. Source: P. Bogacki, L. F. Shampine, "A 3(2) pair of
  /// Runge-Kutta formulas", Appl. Math. Lett. 2(4), 1989.
  void integrate(GenericState& state, double end) {
    double step = end - state.t;
    const auto sum = [](double h, std::initializer_list<std::pair<double, const std::vector<double>*>> terms) {
      std::vector<double> result(terms.begin()->second->size(), 0.0);
      for (const auto& [weight, slope] : terms)
        for (std::size_t i = 0; i < result.size(); ++i) result[i] += h * weight * (*slope)[i];
      return result;
    };
    std::vector<double> k1 = rates(state, 0, {});  // of each next step the last stage of the one before
    for (bool is_last = false; !is_last;) {
      const double left = end - state.t;
      is_last = step >= left;
      const double h = is_last ? left : step;
      const std::vector<double> k2 = rates(state, h / 2, sum(h, {{1.0 / 2, &k1}}));
      const std::vector<double> k3 = rates(state, 3 * h / 4, sum(h, {{3.0 / 4, &k2}}));
      const std::vector<double> change = sum(h, {{2.0 / 9, &k1}, {1.0 / 3, &k2}, {4.0 / 9, &k3}});
      std::vector<double> k4 = rates(state, h, change);
      const std::vector<double> error = sum(h, {{-5.0 / 72, &k1}, {1.0 / 12, &k2}, {1.0 / 9, &k3}, {-1.0 / 8, &k4}});
      double share = 0;
      for (std::size_t i = 0; i < error.size(); ++i)
        share = std::max(share, std::abs(error[i]) / (kStateError * std::max(magnitudes_[i], std::abs(state.x[i]))));
      if (share > 1 && h < kShortestStep) stop("auxiliary states change too fast", state.t);
      step = h * std::clamp(kSafety * std::pow(std::max(share, 1e-12), -1.0 / 3), kLeastChange, kMostChange);
      if (share > 1) {
        is_last = false;
        continue;
      }
      for (std::size_t i = 0; i < change.size(); ++i) state.x[i] += change[i];
      state.t = is_last ? end : state.t + h;
      k1 = std::move(k4);
    }
    motion_at(state);
  }

  [[noreturn]] void stop(const std::string& what, double t, const std::string& hint = "") const {
    throw UserError(fmt::format("{}: {} at t = {:.10g} s\n{}", path_.file.empty() ? "simulate --inverse" : path_.file,
                                what, t, hint.empty() ? "" : fmt::format("  hint: {}\n", hint)));
  }

  const PathOfCoordinates& path_;
  const Engine& engine_;
  const Compilation& compilation_;
  const InputsOverTime& inputs_;
  GenericSolver poses_;
  std::vector<double> magnitudes_, periods_;  ///< of the auxiliary states, and of the sampled values, s
  int side_ = 0;                              ///< of the row before, see GenericSolver::side_of_actuators
};

}  // namespace

void add_actuator_outputs(Model& model) {
  for (std::size_t i = 0; i < model.actuators.size(); ++i)
    for (const char* quantity : {"force", "speed", "power"}) {
      const ElementOutput source = output_of<Actuator>(quantity, i);
      model.outputs.push_back({fmt::format("{}{}.{}", kActuatorColumn, model.actuators[i].name, quantity),
                               {},
                               unit_of(model, source),
                               source});
    }
}

Results forces_along(const PathOfCoordinates& path, const Engine& engine, const Compilation& compilation,
                     const InputsOverTime& inputs, GenericState start, const RowsOfPath& rows) {
  const double length = path.end - path.start, wanted = std::ceil(length / rows.step - 1e-9);
  if (!(wanted <= kMostRows))
    throw UserError(
        fmt::format("--step: {:g} s gives more rows along {:g} s than the {:g} that are kept in memory; take a "
                    "longer step\n",
                    rows.step, length, kMostRows));
  Results table;
  table.columns.push_back({{"t", "s"}, {}});
  for (const TreeBody& body : compilation.topology.bodies)
    table.columns.push_back({{body.coordinate, unit_of(body.kind)}, {}});
  for (const Output& output : compilation.model.outputs) table.columns.push_back({{output.name, output.unit}, {}});
  for (const Actuator& actuator : compilation.model.actuators)
    if (actuator.limit)
      table.columns.push_back({{fmt::format("{}{}.{}", kActuatorColumn, actuator.name, kBeyond),
                                compilation.model.inputs[static_cast<std::size_t>(actuator.input)].unit},
                               {}});
  PathFollower follower(path, engine, compilation, inputs);
  follower.approach(start);
  const long steps = std::max(1L, std::lround(wanted));
  for (long i = 0; i <= steps; ++i) {
    const double t = path.start + length * static_cast<double>(i) / static_cast<double>(steps);
    follower.advance(start, t);
    const std::vector<double> row = follower.row_at(t, start);
    if (i % rows.every != 0 && i != steps) continue;
    table.columns[0].values.push_back(t);
    for (std::size_t c = 0; c < row.size(); ++c) table.columns[c + 1].values.push_back(row[c]);
  }
  return table;
}

std::vector<ColumnOfActuators> columns_of_actuators(const Results& table) {
  std::vector<ColumnOfActuators> found;
  for (const Column& column : table.columns) {
    if (!column.heading.name.starts_with(kActuatorColumn)) continue;
    const auto [smallest, largest] = std::minmax_element(column.values.begin(), column.values.end());
    double squares = 0;
    for (const double value : column.values) squares += value * value;
    found.push_back({{column.heading.name.substr(std::string_view(kActuatorColumn).size()), column.heading.unit},
                     *smallest,
                     *largest,
                     std::sqrt(squares / static_cast<double>(column.values.size()))});
  }
  return found;
}

std::string forces_text(const Results& table) {
  std::string text = fmt::format("  {:<32} {:>13} {:>13} {:>13}\n", "actuators", "smallest", "largest", "r.m.s.");
  for (const ColumnOfActuators& column : columns_of_actuators(table))
    text += fmt::format("  {:<32} {:>13.6g} {:>13.6g} {:>13.6g}\n", heading_text(column.heading), column.smallest,
                        column.largest, column.root_mean_square);
  return text;
}

std::vector<std::string> limits_passed(const Model& model, const Results& table) {
  std::vector<std::string> lines;
  for (const Actuator& actuator : model.actuators) {
    const std::string name = fmt::format("{}{}.{}", kActuatorColumn, actuator.name, kBeyond);
    for (const Column& column : table.columns) {
      if (column.heading.name != name) continue;
      const auto rows = std::ranges::count_if(column.values, [](double value) { return value > 0; });
      const auto first = std::ranges::find_if(column.values, [](double value) { return value > 0; });
      if (rows == 0) continue;
      lines.push_back(
          fmt::format("actuator {}: its force is beyond the limit of {:g} {} by up to {:.6g} {}, in {} of {} "
                      "rows, first at t = {:.10g} s",
                      actuator.name, *actuator.limit, column.heading.unit, *std::ranges::max_element(column.values),
                      column.heading.unit, rows, column.values.size(),
                      table.columns[0].values[static_cast<std::size_t>(first - column.values.begin())]));
    }
  }
  return lines;
}

}  // namespace mbgen
