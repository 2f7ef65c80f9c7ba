#include "workbench/motion/path_forces.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "compiler/model/element_access.hpp"
#include "compiler/text/user_error.hpp"
#include "runtime/generic/generic.hpp"
#include "workbench/describe/names.hpp"
#include "workbench/host/files.hpp"
#include "workbench/motion/inverse_motion.hpp"

namespace mbgen {
namespace {

/// Rows of a table along a path, which are kept until the last one is known.
constexpr double kMostRows = 5e6;

constexpr const char* kActuatorColumn = "actuator.";
/// Parts of the way from the start of the model to the start of a path.
constexpr int kApproach = 64;

[[noreturn]] void stop(const Compilation& compilation, Status status, double t) {
  throw UserError(fmt::format("--path: {} at t = {:.10g} s\n", describe(compilation, status), t));
}

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
        poses_(compilation.model, compilation.topology, compilation.analysis) {}

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
      if (const Status status = poses_.assemble(state, targets); !status.ok()) stop(compilation_, status, state.t);
    }
  }

  /// Coordinates, then all outputs at an instant; `state` belongs to an instant shortly before.
  std::vector<double> row_at(double t, GenericState& state) {
    std::vector<double> given_inputs = inputs_.at(t);
    poses_.set_inputs(given_inputs);
    state.t = t;
    std::fill(state.zd.begin(), state.zd.end(), 0.0);
    Status status = poses_.assemble(state, targets_at(path_.coordinates, path_.positions, t));
    if (status.ok()) status = poses_.assemble_velocities(state, targets_at(path_.coordinates, path_.rates, t));
    if (!status.ok()) stop(compilation_, status, t);
    std::vector<double> given(state.z.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < path_.coordinates.size(); ++i)
      given[static_cast<std::size_t>(path_.coordinates[i])] = path_.accelerations[i].at(t);
    const LoadedState at{state, std::vector<double>(state.z.size(), 0.0)};
    GenericDerivative derivative{{}, std::vector<double>(state.x.size(), 0.0)};
    std::vector<double> force;
    engine_.set_inputs(given_inputs);
    status = actuator_forces(engine_, compilation_, at, given, derivative, force);
    for (std::size_t i = 0; i < force.size(); ++i)
      if (const int input = compilation_.model.actuators[i].input; input >= 0)
        given_inputs[static_cast<std::size_t>(input)] = force[i];
    engine_.set_inputs(given_inputs);
    GenericOutputs outputs;
    if (status.ok()) status = engine_.outputs(at, derivative, outputs);
    if (!status.ok()) stop(compilation_, status, t);
    const int side = poses_.side_of_actuators(state);
    if (side * side_ < 0)
      throw UserError(fmt::format("--path: actuators pass a singular position shortly before t = {:.10g} s\n", t));
    side_ = side;
    std::vector<double> row = state.z;
    row.insert(row.end(), outputs.y.begin(), outputs.y.end());
    return row;
  }

 private:
  const PathOfCoordinates& path_;
  const Engine& engine_;
  const Compilation& compilation_;
  const InputsOverTime& inputs_;
  GenericSolver poses_;
  int side_ = 0;  ///< of the row before, see GenericSolver::side_of_actuators
};

}  // namespace

PathOfCoordinates read_path(const std::string& path, const Compilation& compilation) {
  const Results table = expect(read_results(read_text(path), path));
  if (const std::string& unit = table.columns[0].heading.unit; !unit.empty() && unit != "s")
    throw UserError(fmt::format("{}: column \"t\" is in {}, must be in s\n", path, unit));
  constexpr std::size_t kLeastRows = 3;
  if (table.rows() < kLeastRows)
    throw UserError(fmt::format("{}: a path has at least {} rows, found {}\n", path, kLeastRows, table.rows()));
  PathOfCoordinates result;
  const std::vector<double>& t = table.columns[0].values;
  result.start = t.front();
  result.end = t.back();
  for (std::size_t c = 1; c < table.columns.size(); ++c) {
    const Heading& heading = table.columns[c].heading;
    const int coordinate = find_coordinate(compilation.topology, heading.name);
    if (coordinate < 0) {
      const std::vector<std::string> known = coordinate_names(compilation.topology);
      const std::string hint = did_you_mean(heading.name, {known.begin(), known.end()});
      throw UserError(fmt::format("{}: the model has no coordinate \"{}\"{}{}\n", path, heading.name,
                                  hint.empty() ? "" : "; ", hint));
    }
    if (compilation.analysis.driven[static_cast<std::size_t>(coordinate)])
      throw UserError(
          fmt::format("{}: coordinate \"{}\" has a motion, which moves it\n  hint: leave out the column, or "
                      "the motion\n",
                      path, heading.name));
    const char* unit = unit_of(compilation.topology.bodies[static_cast<std::size_t>(coordinate)].kind);
    if (!heading.unit.empty() && heading.unit != unit)
      throw UserError(
          fmt::format("{}: column \"{}\" is in {}, the coordinate in {}\n", path, heading.name, heading.unit, unit));
    result.coordinates.push_back(coordinate);
    result.positions.push_back(cubic_spline(t, table.columns[c].values));
    result.rates.push_back(derivative(result.positions.back()));
    result.accelerations.push_back(derivative(result.rates.back()));
  }
  if (result.coordinates.empty()) throw UserError(fmt::format("{}: a path has columns of coordinates\n", path));
  return result;
}

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
                     const InputsOverTime& inputs, GenericState start, double step) {
  const double length = path.end - path.start, wanted = std::ceil(length / step - 1e-9);
  if (!(wanted <= kMostRows))
    throw UserError(
        fmt::format("--step: {:g} s gives more rows along {:g} s than the {:g} that are kept in memory; take a "
                    "longer step\n",
                    step, length, kMostRows));
  Results table;
  table.columns.push_back({{"t", "s"}, {}});
  for (const TreeBody& body : compilation.topology.bodies)
    table.columns.push_back({{body.coordinate, unit_of(body.kind)}, {}});
  for (const Output& output : compilation.model.outputs) table.columns.push_back({{output.name, output.unit}, {}});
  PathFollower follower(path, engine, compilation, inputs);
  follower.approach(start);
  const long steps = std::max(1L, std::lround(wanted));
  for (long i = 0; i <= steps; ++i) {
    const double t = path.start + length * static_cast<double>(i) / static_cast<double>(steps);
    const std::vector<double> row = follower.row_at(t, start);
    table.columns[0].values.push_back(t);
    for (std::size_t c = 0; c < row.size(); ++c) table.columns[c + 1].values.push_back(row[c]);
  }
  return table;
}

std::string forces_text(const Results& table) {
  std::string text = fmt::format("  {:<32} {:>13} {:>13} {:>13}\n", "actuators", "smallest", "largest", "r.m.s.");
  for (const Column& column : table.columns) {
    if (!column.heading.name.starts_with(kActuatorColumn)) continue;
    const auto [smallest, largest] = std::minmax_element(column.values.begin(), column.values.end());
    double squares = 0;
    for (const double value : column.values) squares += value * value;
    text += fmt::format("  {:<32} {:>13.6g} {:>13.6g} {:>13.6g}\n",
                        heading_text(column.heading).substr(std::string_view(kActuatorColumn).size()), *smallest,
                        *largest, std::sqrt(squares / static_cast<double>(column.values.size())));
  }
  return text;
}

}  // namespace mbgen
