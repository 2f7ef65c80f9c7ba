// The derivatives of a motion's start.

#include <fmt/format.h>

#include <algorithm>

#include "compiler/algebra/dense.hpp"
#include "compiler/analysis/held_start.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/sensitivity/tangent_engine.hpp"

namespace mbgen {
namespace {

using Memory = TangentEngine::Memory;
using Numbers = std::vector<TangentNumber>;

/// Singular values below this share of the largest leave an equilibrium undetermined.
constexpr double kUndetermined = 1e-10;
/// Part of an imbalance that no motion of an equilibrium removes.
constexpr double kUnbalanced = 1e-6;

void require(const Compilation& compilation, Status status) {
  if (!status.ok())
    throw UserError(
        fmt::format("sensitivities: the start cannot be differentiated: {}\n", describe(compilation, status)));
}

/// Closes the loops of `state` while the given coordinates are held, see held_at_start.
void hold(const Compilation& compilation, const TangentTable& table, const TangentPass& pass,
          const std::vector<InitialValue>& given, const char* what, Numbers& state) {
  const auto held = held_at_start(compilation.topology, compilation.analysis, given);
  const Status status =
      held ? table.project_holding(pass.parameters.data(), pass.inputs.data(), held->data(), state.data())
           : Status{Code::loop_singular, -1};
  if (status.code == Code::loop_singular)
    throw UserError(
        fmt::format("sensitivities: the {} of \"initial\" do not tell which coordinates are held when a parameter "
                    "changes: the start is the "
                    "nearest one to them\n"
                    "  hint: give as many as the loops leave free, or mark as many with \"locked\": true\n",
                    what));
  require(compilation, status);
}

/// The start without derivatives.
Numbers plain_state(const GenericState& start, const TangentTable& table, bool at_rest) {
  Numbers numbers(start.z.begin(), start.z.end());
  for (const double rate : start.zd) numbers.emplace_back(at_rest ? 0.0 : rate);
  numbers.insert(numbers.end(), start.x.begin(), start.x.end());
  numbers.emplace_back(start.t);
  numbers.insert(numbers.end(), start.charts.begin(), start.charts.end());
  numbers.resize(static_cast<std::size_t>(table.state_size), 0.0);
  return numbers;
}

/// A static equilibrium: its unknowns, places in a state, are the independent coordinates and the auxiliary states, its
/// equations their accelerations and rates.
struct Equilibrium {
  const Compilation& compilation;
  const TangentTable& table;
  std::vector<std::size_t> unknowns;   ///< places in a state
  std::vector<std::size_t> equations;  ///< places in a derivative

  Equilibrium(const Compilation& of, const TangentTable& with) : compilation(of), table(with) {
    const auto coordinates = static_cast<std::size_t>(table.coordinates);
    for (const int i : free_coordinates(compilation.topology, compilation.analysis)) {
      unknowns.push_back(static_cast<std::size_t>(i));
      equations.push_back(static_cast<std::size_t>(i));
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(table.auxiliary_states); ++k) {
      unknowns.push_back(2 * coordinates + k);
      equations.push_back(coordinates + k);
    }
  }

  /// The equations at a state whose loops are closed on the way.
  Eigen::MatrixXd slopes(const Numbers& parameters, const Numbers& inputs, Numbers& state) const {
    const Numbers tau(static_cast<std::size_t>(table.coordinates), 0.0);
    Numbers rates(static_cast<std::size_t>(table.derivative_size), 0.0);
    require(compilation, table.project(parameters.data(), inputs.data(), state.data()));
    require(compilation, table.accelerations(parameters.data(), inputs.data(), state.data(), tau.data(), rates.data()));
    Eigen::MatrixXd found(static_cast<Eigen::Index>(equations.size()), kDirections);
    for (std::size_t e = 0; e < equations.size(); ++e)
      for (int k = 0; k < kDirections; ++k) found(static_cast<Eigen::Index>(e), k) = rates[equations[e]].tangent[k];
    return found;
  }

  /// Derivatives of the equations by the unknowns.
  Eigen::MatrixXd jacobian(const Numbers& parameters, const Numbers& inputs, const Numbers& at) const {
    const auto count = static_cast<Eigen::Index>(unknowns.size());
    Eigen::MatrixXd matrix(count, count);
    for (Eigen::Index first = 0; first < count; first += kDirections) {
      const Eigen::Index together = std::min<Eigen::Index>(kDirections, count - first);
      Numbers state = at;
      for (Eigen::Index k = 0; k < together; ++k) state[unknowns[static_cast<std::size_t>(first + k)]].tangent[k] = 1;
      matrix.middleCols(first, together) = slopes(parameters, inputs, state).leftCols(together);
    }
    return matrix;
  }
};

/// Gives a state at a static equilibrium the derivatives of the equilibrium. Source: implicit function theorem.
void follow_equilibrium(const Equilibrium& rest, const TangentPass& pass, Numbers& state) {
  Numbers constants = pass.parameters;
  for (TangentNumber& number : constants) number = number.value;
  const Numbers at = state;
  const Eigen::MatrixXd jacobian = rest.jacobian(constants, pass.inputs, at);
  const Eigen::MatrixXd moved = rest.slopes(pass.parameters, pass.inputs, state);
  state = at;
  for (int k = 0; k < kDirections; ++k) {
    const Eigen::VectorXd by = least_squares(jacobian, -moved.col(k), kUndetermined);
    if (!((jacobian * by + moved.col(k)).norm() <= kUnbalanced * moved.col(k).norm()))
      throw UserError(
          "sensitivities: the static equilibrium of the start is not determined: a direction without stiffness moves "
          "with a parameter\n");
    for (std::size_t u = 0; u < rest.unknowns.size(); ++u)
      state[rest.unknowns[u]].tangent[k] = by[static_cast<Eigen::Index>(u)];
  }
  require(rest.compilation, rest.table.project(pass.parameters.data(), pass.inputs.data(), state.data()));
}

}  // namespace

void start_motion(const Compilation& compilation, const GenericState& start, TangentEngine& engine) {
  if (!engine.memory) return;
  const TangentTable& table = *engine.memory->table;
  const Initial& initial = compilation.model.initial;
  const Equilibrium rest(compilation, table);
  for (TangentPass& pass : engine.memory->passes) {
    Numbers state = plain_state(start, table, initial.equilibrium);
    if (initial.equilibrium) {
      follow_equilibrium(rest, pass, state);
    } else {
      hold(compilation, table, pass, initial.positions, "positions", state);
    }
    for (std::size_t i = 0; i < start.zd.size(); ++i) state[start.z.size() + i] = start.zd[i];
    hold(compilation, table, pass, initial.velocities, "velocities", state);
    std::size_t place = 0;
    for (const std::vector<double>* part : {&start.z, &start.zd})
      for (const double value : *part) state[place++].value = value;
    pass.after = pass.before = state;
  }
}

}  // namespace mbgen
