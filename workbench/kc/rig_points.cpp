// States of balance on the rig, and their derivatives.

#include <algorithm>
#include <cmath>

#include "compiler/algebra/dense.hpp"
#include "compiler/analysis/choice_at.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "mbgen/blocks.hpp"
#include "mbgen/solver/newton.hpp"
#include "workbench/kc/rig.hpp"

namespace mbgen::kc {
namespace {

using StateKind = LinearState::Kind;

/// Values of the model's inputs for inputs of the rig.
std::vector<double> model_inputs(const Rig& rig, const RigInputs& imposed) {
  std::vector<double> inputs = rig.start_inputs;
  for (std::size_t i = 0; i < imposed.size(); ++i) {
    if (rig.inputs[i] >= 0) inputs[static_cast<std::size_t>(rig.inputs[i])] += imposed[i];
  }
  return inputs;
}

/// Derivatives of the free positions and auxiliary states by the inputs without accelerations: with A and B of the
/// linear system and zero velocities, A_p p + A_x x + B u = 0 in the rows of accelerations and auxiliary rates.
Eigen::MatrixXd response(const LinearSystem& system) {
  std::vector<Eigen::Index> unknown, rows;
  for (std::size_t i = 0; i < system.states.size(); ++i) {
    if (system.states[i].kind != StateKind::velocity) unknown.push_back(static_cast<Eigen::Index>(i));
    if (system.states[i].kind != StateKind::position) rows.push_back(static_cast<Eigen::Index>(i));
  }
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(system.A.rows(), system.B.cols());
  if (unknown.empty()) return result;
  Eigen::MatrixXd matrix = system.A(rows, unknown);
  // Columns of one size: positions are angles, lengths and states of any unit.
  const Eigen::VectorXd size = matrix.colwise().norm().transpose().cwiseMax(1e-300);
  matrix = matrix * size.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd load = system.B(rows, Eigen::all);
  for (Eigen::Index j = 0; j < load.cols(); ++j) {
    const Eigen::VectorXd scaled = least_squares(matrix, load.col(j), kIndifferentShare);
    for (std::size_t k = 0; k < unknown.size(); ++k)
      result(unknown[k], j) = -scaled[static_cast<Eigen::Index>(k)] / size[static_cast<Eigen::Index>(k)];
  }
  return result;
}

}  // namespace

Status find_point(const Rig& rig, const RigInputs& imposed, const GenericState& near, RigPoint& point) {
  const Compilation& c = rig.compilation;
  GenericSolver solver(c.model, c.topology, c.analysis);
  point = {imposed, near, model_inputs(rig, imposed), {}, {}};
  solver.set_inputs(point.inputs);
  if (const Status status = solver.equilibrium(point.state); !status.ok()) return status;
  const std::vector<double> no_forces(point.state.z.size(), 0.0);
  GenericDerivative rates;
  if (const Status status = solver.accelerations(point.state, no_forces, rates); !status.ok()) return status;
  point.values = solver.outputs(point.state, no_forces, rates).y;
  return {};
}

std::optional<Diagnostic> add_slopes(const Rig& rig, RigPoint& point) {
  const GenericState& state = point.state;
  const Result<LinearSystem> found =
      linearise_by_any_choice(rig.compilation, {state.z, state.zd, state.x, state.t, point.inputs});
  if (!found) return found.problems().front();
  const LinearSystem& system = *found;
  const Eigen::MatrixXd all = system.C * response(system) + system.D;
  point.slopes = Eigen::MatrixXd::Zero(all.rows(), kRigInputs);
  for (int i = 0; i < kRigInputs; ++i) {
    if (rig.inputs[static_cast<std::size_t>(i)] >= 0)
      point.slopes.col(i) = all.col(rig.inputs[static_cast<std::size_t>(i)]);
  }
  return {};
}

void choose_at(Rig& rig, const GenericState& state) {
  const Compilation& c = rig.compilation;
  if (weakest_pivot(c.model, c.topology, c.analysis, state.z) >= kPivotThreshold<double>) return;
  if (!has_rates(rig)) {
    std::optional<Analysis> anew = chosen_at(c.model, c.topology, c.analysis, state.z);
    if (anew) rig.compilation.analysis = std::move(*anew);
  } else if (std::optional<Compilation> anew = chosen_at(c, state.z)) {
    rig.compilation = std::move(*anew);
  }
}

}  // namespace mbgen::kc
