// The linear equations of an implicit step, at numbers.

#include "compiler/formulation/implicit/implicit.hpp"

#include "mbgen/blocks.hpp"
#include "runtime/generic/equations.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {

Status GenericSolver::tangents(const GenericState& state, double g, GenericTangents& tangents) const {
  tangents.equations = nullptr;
  if (const Status status = equations_->check_arguments(state, {}); !status.ok()) return status;
  const Analysis& analysis = equations_->analysis;
  WatchedEquations<double> watched = implicit_equations(equations_->system(state), analysis.blocks, analysis.driven, g);
  for (std::size_t b = 0; b < watched.quality.size(); ++b)
    if (analysis.blocks[b].rank > 0 && !(watched.quality[b] >= kPivotThreshold<double>))
      return {Code::chosen_again, static_cast<int>(b)};
  const std::vector<int> free = free_coordinates(equations_->topology, analysis);
  for (std::size_t q = 0; q < free.size(); ++q)
    if (!(watched.pivot[q] > 0)) return {Code::implicit_singular, free[q]};
  for (std::size_t i = 0; i < watched.state_pivot.size(); ++i)
    if (!(watched.state_pivot[i] > 0))
      return {Code::implicit_state_grows, first_user_state(equations_->model) + static_cast<int>(i)};
  tangents.equations = std::make_shared<ImplicitEquations<double>>(std::move(watched.equations));
  return {};
}

GenericDerivative GenericSolver::changes(const GenericTangents& tangents, double g, const std::vector<double>& zd,
                                         const GenericDerivative& rates) const {
  if (tangents.equations == nullptr) {
    GenericDerivative explicit_ones = rates;
    for (double& value : explicit_ones.zdd) value *= g;
    for (double& value : explicit_ones.xd) value *= g;
    return explicit_ones;
  }
  const std::vector<int> free = free_coordinates(equations_->topology, equations_->analysis);
  ImplicitRates<double> changes =
      implicit_changes<double>(equations_->topology, free, *tangents.equations, g, {zd, rates.zdd, rates.xd});
  return {std::move(changes.zdd), std::move(changes.xd)};
}

}  // namespace mbgen
