#include "compiler/cli/initial_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/cli/engine.hpp"
#include "compiler/cli/options.hpp"
#include "compiler/cli/user_error.hpp"
#include "compiler/model/evaluate.hpp"

namespace mbgen::cli {
namespace {

/// A value counts as kept when the closures moved it less than this (rad, m or per second, relative above 1).
constexpr double kKept = 1e-9;
/// Values that describe a closed position with a few digits each may be moved by this much.
constexpr double kRounding = 1e-3;
/// Largest change of a coordinate between two positions that are closed one after the other (rad or m).
constexpr double kAssemblyStep = 0.05;

/// A value that was asked of a coordinate.
struct Wish {
  int coordinate = -1;
  CoordinateReference reference;
  double value = 0;
  Where where;
};

std::vector<Wish> wishes_of(const Compilation& compilation, const std::vector<InitialValue>& values) {
  std::vector<Wish> wishes;
  for (const InitialValue& value : values) {
    const int coordinate = tree_coordinate(compilation.topology, value.coordinate);
    if (coordinate < 0) {
      throw UserError(
          Diagnostics{{value.where, "initial value of a joint that was cut", "mark it \"cut\": false", ""}});
    }
    wishes.push_back({coordinate, value.coordinate, value.value, value.where});
  }
  return wishes;
}

/// The first wish that the values do not keep, or null.
const Wish* first_broken(const std::vector<Wish>& wishes, const std::vector<double>& values, double tolerance) {
  for (const Wish& wish : wishes) {
    const double distance = std::abs(values[wish.coordinate] - wish.value);
    if (!(distance <= tolerance * std::max(1.0, std::abs(wish.value)))) return &wish;
  }
  return nullptr;
}

void require(Status status, const Compilation& compilation, const char* action) {
  if (!status.ok()) {
    throw UserError(fmt::format("initial state: cannot {}: {}\n", action, describe(compilation, status)));
  }
}

/// z(t) = start + rate * t as an expression of the model.
Quantity ramp(Model& model, double start, double rate) {
  using Kind = ExpressionNode::Kind;
  Expression expression;
  const auto push = [&expression](Kind kind, Function function, double number, int first, int second) {
    ExpressionNode node;
    node.kind = kind;
    node.function = function;
    node.number = number;
    node.first = first;
    node.second = second;
    expression.nodes.push_back(node);
  };
  push(Kind::number, Function::add, start, -1, -1);
  push(Kind::number, Function::add, rate, -1, -1);
  push(Kind::time, Function::add, 0, -1, -1);
  push(Kind::call, Function::multiply, 0, 1, 2);
  push(Kind::call, Function::add, 0, 0, 3);
  expression.text = fmt::format("{} + {} * t", start, rate);
  model.expressions.push_back(expression);
  Quantity quantity(start);
  quantity.expression = static_cast<int>(model.expressions.size()) - 1;
  return quantity;
}

/// A solver of the same mechanism whose wished coordinates are driven from `start` at the rate of the wish; the
/// model's own motions stay at `start`. Empty when so many driven coordinates contradict the closures.
std::optional<GenericSolver> driven_solver(const Compilation& compilation, const std::vector<Wish>& wishes,
                                           const std::vector<double>& start, const std::vector<double>& rate) {
  Model model = compilation.model;
  for (Motion& motion : model.motions) {
    const int coordinate = tree_coordinate(compilation.topology, motion.joint);
    motion.position = ramp(model, start[coordinate], rate[coordinate]);
  }
  for (const Wish& wish : wishes) {
    const auto drives_it = [&](const Motion& motion) { return motion.joint == wish.reference; };
    if (std::any_of(model.motions.begin(), model.motions.end(), drives_it)) continue;
    Motion motion;
    motion.name = "initial value of " + compilation.topology.bodies[wish.coordinate].coordinate;
    motion.where = wish.where;
    motion.joint = wish.reference;
    motion.position = ramp(model, start[wish.coordinate], rate[wish.coordinate]);
    model.motions.push_back(motion);
  }
  const Result<Analysis> analysis = analyse(model, compilation.topology);
  if (!analysis) return std::nullopt;
  return GenericSolver(model, compilation.topology, *analysis);
}

/// What motions look at when the run starts.
struct StartEnvironment {
  const Model& model;
  const std::vector<double>& inputs;
  double parameter(int index) const { return model.parameters[index].value; }
  double input(int index) const { return inputs[index]; }
  double time() const { return 0; }
  double position(const CoordinateReference&) const { return 0; }
  double velocity(const CoordinateReference&) const { return 0; }
  double local(int) const { return 0; }
};

/// Moves the wished and the driven coordinates from zero to their values in small steps, the loops closed at each.
/// Result: the state at the end, empty when the wishes leave no freedom for that.
std::optional<GenericState> assemble_by_driving(const Compilation& compilation, const std::vector<double>& inputs,
                                                const std::vector<Wish>& wishes) {
  GenericState state = reference_state(compilation);
  std::vector<double> rate(state.z.size(), 0.0);
  const StartEnvironment environment{compilation.model, inputs};
  for (const Motion& motion : compilation.model.motions) {
    rate[tree_coordinate(compilation.topology, motion.joint)] =
        evaluate<double>(motion.position, compilation.model.expressions, environment);
  }
  for (const Wish& wish : wishes) rate[wish.coordinate] = wish.value;
  const std::optional<GenericSolver> solver = driven_solver(compilation, wishes, state.z, rate);
  if (!solver) return std::nullopt;
  const int steps = std::max(1, static_cast<int>(std::ceil(largest_absolute(rate) / kAssemblyStep)));
  for (int k = 1; k <= steps; ++k) {
    state.t = static_cast<double>(k) / steps;
    require(solver->project(state), compilation, "move the joints to the asked positions");
  }
  state.t = 0;
  std::fill(state.zd.begin(), state.zd.end(), 0.0);
  return state;
}

[[noreturn]] void contradiction(const Compilation& compilation, const Wish& wish, double found, const char* what) {
  const std::string& name = compilation.topology.bodies[wish.coordinate].coordinate;
  const bool is_driven = compilation.analysis.driven[wish.coordinate];
  throw UserError(Diagnostics{
      is_driven ? Diagnostic{wish.where,
                             fmt::format("initial {} of {} contradicts its motion, {} asked, the motion gives {}", what,
                                         name, wish.value, found),
                             "remove it: a driven coordinate starts where its motion is", ""}
                : Diagnostic{wish.where,
                             fmt::format("initial {} of {} contradicts the closures, {} asked, {} closes", what, name,
                                         wish.value, found),
                             "give as many values as there are degrees of freedom, or consistent ones", ""}});
}

/// Closed positions with the wishes kept.
GenericState assemble(const Compilation& compilation, const GenericSolver& solver, const std::vector<double>& inputs,
                      const std::vector<Wish>& wishes, bool only_a_guess) {
  GenericState state = reference_state(compilation);
  for (const Wish& wish : wishes) state.z[wish.coordinate] = wish.value;
  const Status status = solver.project(state);
  const Wish* broken = status.ok() ? first_broken(wishes, state.z, kKept) : nullptr;
  if (status.ok() && (only_a_guess || broken == nullptr)) return state;

  std::optional<GenericState> driven = assemble_by_driving(compilation, inputs, wishes);
  if (driven) {
    require(solver.project(*driven), compilation, "close the loops");
    state = *driven;
  } else {
    require(status, compilation, "close the loops");
  }
  broken = first_broken(wishes, state.z, kRounding);
  if (broken != nullptr) contradiction(compilation, *broken, state.z[broken->coordinate], "position");
  return state;
}

/// Consistent velocities with the wishes kept, at the positions of `state`.
void set_velocities(const Compilation& compilation, const GenericSolver& solver, const std::vector<Wish>& wishes,
                    GenericState& state) {
  GenericState simple = state;
  for (const Wish& wish : wishes) simple.zd[wish.coordinate] = wish.value;
  require(solver.project(simple), compilation, "close the loops");
  const Wish* broken = first_broken(wishes, simple.zd, kKept);
  if (broken != nullptr) {
    std::vector<double> rate = simple.zd;
    for (const Wish& wish : wishes) rate[wish.coordinate] = wish.value;
    const std::optional<GenericSolver> driven = driven_solver(compilation, wishes, simple.z, rate);
    if (driven) require(driven->project(simple), compilation, "give the joints the asked velocities");
    broken = first_broken(wishes, simple.zd, kRounding);
    if (broken != nullptr) contradiction(compilation, *broken, simple.zd[broken->coordinate], "velocity");
  }
  state = simple;
}

}  // namespace

GenericState initial_state(const Compilation& compilation, const std::vector<double>& inputs) {
  const Initial& initial = compilation.model.initial;
  GenericSolver solver(compilation.model, compilation.topology, compilation.analysis);
  solver.set_inputs(inputs);
  GenericState state =
      assemble(compilation, solver, inputs, wishes_of(compilation, initial.positions), initial.equilibrium);
  if (initial.equilibrium) {
    require(solver.equilibrium(state), compilation, "find the static equilibrium");
  }
  set_velocities(compilation, solver, wishes_of(compilation, initial.velocities), state);
  return state;
}

InitialState default_initial_state(const Compilation& compilation) {
  GenericState state = initial_state(compilation, input_values(compilation.model, {}));
  return {std::move(state.z), std::move(state.zd), std::move(state.x)};
}

}  // namespace mbgen::cli
