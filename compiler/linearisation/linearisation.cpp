#include "compiler/linearisation/linearisation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/linearisation/bristles.hpp"
#include "compiler/linearisation/groups.hpp"
#include "compiler/linearisation/position_states.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/solver/layout.hpp"
#include "mbgen/blocks.hpp"

namespace mbgen {
namespace {

/// Values of an operating point, by the groups of the programs' inputs.
Groups known_at(const Model& model, const Topology& topology, const OperatingPoint& point) {
  Groups known = {{Array::z, point.z},
                  {Array::zd, point.zd},
                  {Array::x, point.x},
                  {Array::t, {point.t}},
                  {Array::tau, std::vector<double>(static_cast<std::size_t>(topology.size()), 0.0)},
                  {Array::in, point.inputs},
                  {Array::par, {}},
                  {Array::charts, std::vector<double>(topology.balls.size(), 0.0)}};
  for (const Parameter& parameter : model.parameters) {
    if (parameter.tunable) known[Array::par].push_back(parameter.value);
  }
  return known;
}

/// Index of a loop block that is ill-conditioned with its frozen partition.
std::optional<int> singular_block(const Groups& results) {
  const auto pivots = results.find(Array::pivot);
  if (pivots == results.end()) return {};
  for (std::size_t b = 0; b < pivots->second.size(); ++b) {
    if (!(pivots->second[b] >= kPivotThreshold<double>)) return static_cast<int>(b);
  }
  return {};
}

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// Derivatives at one point along any direction.
class Derivatives {
 public:
  Derivatives(const DirectionalPrograms& programs, Groups known, int outputs)
      : programs_(programs), groups_(programs.groups), known_(std::move(known)), outputs_(outputs) {}

  /// Computes the accelerations and the other inputs of the outputs. Result: a loop block that is singular here.
  std::optional<int> solve() {
    known_[Array::seed] = std::vector<double>(static_cast<std::size_t>(direction_size(groups_)), 0.0);
    if (programs_.has_closure) {
      if (const auto block = singular_block(evaluate(programs_.closure, known_))) return block;
    }
    const Groups solution = evaluate(programs_.accelerations, known_);
    if (const auto block = singular_block(solution)) return block;
    known_[Array::zdd] = solution.at(Array::zdd);
    known_[Array::xd] = group_of(solution, Array::xd, size_of(Array::x));
    if (!programs_.has_multipliers) return {};
    const Groups forces = evaluate(programs_.multipliers, known_);
    for (const Array name : {Array::lambda, Array::drive}) known_[name] = group_of(forces, name, size_of(name));
    return {};
  }

  /// Derivative of the closed positions by each position: a column per coordinate, from the Newton step of the closure;
  /// at the solution it does not depend on the dependent positions.
  Eigen::MatrixXd closing() {
    const int n = size_of(Array::z);
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(n, n);
    if (!programs_.has_closure || n == 0) return columns;
    std::vector<Groups> directions;
    for (int i = 0; i < n; ++i) directions.push_back(unit_direction(Array::z, i));
    const std::vector<Groups> moved = run(programs_.closure, directions);
    for (int i = 0; i < n; ++i)
      columns.col(i) = vector_of(group_of(moved[static_cast<std::size_t>(i)], derivative_of(Array::dz), n));
    return columns;
  }

  /// Unit direction of one entry of a group.
  Groups unit_direction(SlotGroup group, int index) const {
    Groups direction;
    for (const DirectionGroup& part : groups_) direction[part.group].assign(static_cast<std::size_t>(part.size), 0.0);
    direction[group][static_cast<std::size_t>(index)] = 1;
    return direction;
  }

  /// Completes directions of states or inputs by their rates: groups z, zd, zdd, xd, y.
  void complete(const PositionStates& positions, std::vector<Groups>& directions) {
    if (directions.empty()) return;
    const auto take = [&](const std::vector<Groups>& found, SlotGroup group, SlotGroup from, int size) {
      for (std::size_t i = 0; i < found.size(); ++i)
        directions[i][group] = group_of(found[i], derivative_of(from), size);
    };
    if (programs_.has_closure) {
      close(positions, directions);
      take(run(programs_.closure, directions), Array::zd, Array::zd, size_of(Array::z));
    }
    const std::vector<Groups> rates = run(programs_.accelerations, directions);
    take(rates, Array::zdd, Array::zdd, size_of(Array::z));
    if (programs_.has_multipliers) {
      const std::vector<Groups> forces = run(programs_.multipliers, directions);
      for (const Array name : {Array::lambda, Array::drive}) take(forces, name, name, size_of(name));
    }
    const std::vector<Groups> outputs = run(programs_.outputs, directions);
    take(rates, Array::xd, Array::xd, size_of(Array::x));
    take(outputs, Array::y, Array::y, outputs_);
  }

  /// The point itself: groups zd, zdd, xd and others.
  const Groups& known() const { return known_; }

 private:
  /// Closes the loops along directions of positions, with the given positions of states.
  void close(const PositionStates& positions, std::vector<Groups>& directions) {
    const std::vector<Groups> found = run(programs_.closure, directions);
    for (std::size_t d = 0; d < directions.size(); ++d) {
      std::vector<double>& z = directions[d][Array::z];
      const std::vector<double> given = z, moved = group_of(found[d], derivative_of(Array::dz), size_of(Array::z));
      for (std::size_t i = 0; i < moved.size(); ++i) z[i] += moved[i];
      for (Eigen::Index j = 0; j < positions.along.cols(); ++j) {
        const auto state = static_cast<std::size_t>(positions.coordinates[static_cast<std::size_t>(j)]);
        const double by = given[state] - z[state];
        for (std::size_t i = 0; i < z.size(); ++i) z[i] += by * positions.along(static_cast<Eigen::Index>(i), j);
      }
    }
  }

  int size_of(SlotGroup group) const {
    const auto found = std::find_if(groups_.begin(), groups_.end(), [&](const auto& g) { return g.group == group; });
    return found->size;
  }

  std::vector<Groups> run(const Program& program, const std::vector<Groups>& directions) const {
    std::vector<std::vector<double>> seeds;
    seeds.reserve(directions.size());
    for (const Groups& direction : directions) seeds.push_back(joined(groups_, direction));
    return evaluate(program, known_, Array::seed, seeds);
  }

  const DirectionalPrograms& programs_;
  const std::vector<DirectionGroup>& groups_;
  Groups known_;
  int outputs_;
};

std::vector<LinearState> states_of(const Model& model, const std::vector<int>& positions,
                                   const std::vector<int>& velocities) {
  std::vector<LinearState> states;
  for (const int coordinate : positions) states.push_back({LinearState::Kind::position, coordinate});
  for (const int coordinate : velocities) states.push_back({LinearState::Kind::velocity, coordinate});
  const int moving = auxiliary_state_count(model) - held_state_count(model);
  for (int i = 0; i < moving; ++i) states.push_back({LinearState::Kind::auxiliary, i});
  return states;
}

/// Rates of the states, selected from all rates.
Eigen::VectorXd rates_of(const std::vector<LinearState>& states, const Groups& rates) {
  constexpr Array kRates[] = {Array::zd, Array::zdd, Array::xd};
  Eigen::VectorXd result(static_cast<Eigen::Index>(states.size()));
  for (std::size_t i = 0; i < states.size(); ++i) {
    const std::vector<double>& group = rates.at(kRates[static_cast<int>(states[i].kind)]);
    result[static_cast<Eigen::Index>(i)] = group[static_cast<std::size_t>(states[i].index)];
  }
  return result;
}

Diagnostic problem(const Model& model, std::string message, std::string hint) {
  return {Where{model.file, 0, 0, ""}, std::move(message), std::move(hint), ""};
}

Diagnostic singular(const Model& model, const Loop& loop) {
  return problem(model, "cannot be linearised here: loop " + quoted(loop.name) + " is singular at this position",
                 "linearise at a position near by");
}

/// Problem of a ball joint with angles near their pole, none if there is no such joint.
std::optional<Diagnostic> near_pole(const Model& model, const Topology& topology, const OperatingPoint& point) {
  for (const Ball& ball : topology.balls) {
    if (!leaves_chart(ball, 0.0, point.z.data())) continue;
    const int joint = topology.bodies[static_cast<std::size_t>(ball.coordinate[0])].joint;
    return problem(
        model,
        "cannot be linearised here: the angles of joint " + quoted(model.joints[static_cast<std::size_t>(joint)].name) +
            " are near their pole",
        "give the joint another \"sequence\", or linearise at a position in which its second angle is small");
  }
  return {};
}

}  // namespace

DirectionalPrograms directional_programs(const Model& model, const Topology& topology, const Analysis& analysis,
                                         const Programs& programs) {
  using enum Array;
  DirectionalPrograms all;
  all.groups = direction_of(solver_layout(model, topology, analysis), {z, zd, x, in, zdd, lambda, drive});
  const auto along = [&](const Program& program) { return differentiate(program, seeds_of(program, all.groups)); };
  all.has_closure = !programs.closure.outputs.empty();
  all.has_multipliers = !programs.multipliers.outputs.empty();
  if (all.has_closure) all.closure = along(programs.closure);
  all.accelerations = along(programs.accelerations);
  if (all.has_multipliers) all.multipliers = along(programs.multipliers);
  all.outputs = along(programs.outputs);
  return all;
}

Result<LinearSystem> linearise(const Model& model, const Topology& topology, const Analysis& analysis,
                               const DirectionalPrograms& programs, const OperatingPoint& point) {
  if (const auto pole = near_pole(model, topology, point)) return *pole;
  using enum Array;
  const SolverLayout layout = solver_layout(model, topology, analysis);
  const int outputs = layout.outputs, inputs = layout.inputs;
  Derivatives derivatives(programs, known_at(model, topology, point), outputs);
  if (const std::optional<int> block = derivatives.solve())
    return singular(model, topology.loops[topology.blocks[static_cast<std::size_t>(*block)].loops.front()]);

  PositionStates positions{free_coordinates(topology, analysis), {}};
  const std::vector<int> velocities = positions.coordinates;
  if (const Loop* rolling = rolling_loop(topology)) {
    std::optional<PositionStates> found = position_states(topology, analysis, derivatives.closing());
    if (!found) return singular(model, *rolling);
    positions = std::move(*found);
  }
  LinearSystem system;
  system.states = states_of(model, positions.coordinates, velocities);
  const auto size = static_cast<Eigen::Index>(system.states.size());
  system.A.resize(size, size);
  system.B.resize(size, inputs);
  system.C.resize(outputs, size);
  system.D.resize(outputs, inputs);
  system.coordinates.resize(layout.coordinates, size);
  system.drift = rates_of(system.states, derivatives.known());
  constexpr Array kGroups[] = {Array::z, Array::zd, Array::x};
  std::vector<Groups> directions;
  for (const LinearState& state : system.states)
    directions.push_back(derivatives.unit_direction(kGroups[static_cast<int>(state.kind)], state.index));
  for (int j = 0; j < inputs; ++j) directions.push_back(derivatives.unit_direction(Array::in, j));
  derivatives.complete(positions, directions);
  for (Eigen::Index j = 0; j < size; ++j) {
    const Groups& rates = directions[static_cast<std::size_t>(j)];
    system.A.col(j) = rates_of(system.states, rates);
    system.C.col(j) = vector_of(rates.at(Array::y));
    system.coordinates.col(j) = vector_of(rates.at(Array::z));
  }
  for (Eigen::Index j = 0; j < inputs; ++j) {
    const Groups& rates = directions[static_cast<std::size_t>(size + j)];
    system.B.col(j) = rates_of(system.states, rates);
    system.D.col(j) = vector_of(rates.at(Array::y));
  }
  release_bristles(model, topology, point, system);
  const bool is_finite = system.A.allFinite() && system.B.allFinite() && system.C.allFinite() && system.D.allFinite();
  if (is_finite) return system;
  return problem(model, "cannot be linearised here: a derivative is not finite",
                 "a law may have a corner or a pole at this state; linearise beside it");
}

}  // namespace mbgen
