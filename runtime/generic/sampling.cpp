#include "mbgen/sampling.hpp"

#include "compiler/model/auxiliary_states.hpp"
#include "runtime/generic/equations.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {

Status GenericSolver::sample(GenericState& state, double h, bool& any) const {
  const Model& model = equations_->model;
  any = false;
  if (model.sampled.empty()) return {};
  Status status = equations_->check_arguments(state, {});
  if (!status.ok()) return status;
  const int held_count = held_state_count(model), first = auxiliary_state_count(model) - held_count;
  const int count = static_cast<int>(model.sampled.size());
  std::vector<double> periods, due(model.sampled.size());
  for (const SampledValue& value : model.sampled) periods.push_back(value.period);
  status = find_due(periods.data(), count, first, state.t, h, due.data(), any);
  if (!status.ok() || !any) return status;
  System<double>& system = equations_->system(state);
  const Kinematics<double> k = kinematics(system);
  see_states_and_lengths(system, k, velocities(system, k));
  return take_held(sampled_states(system, due).data(), held_count, first, state.x.data());
}

}  // namespace mbgen
