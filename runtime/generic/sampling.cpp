#include "mbgen/sampling.hpp"

#include "compiler/formulation/reaction_loads.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/element_access.hpp"
#include "runtime/generic/equations.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {

Status GenericSolver::take_loads(const GenericState& state, std::vector<double>& loads) const {
  const std::vector<double> no_tau(state.z.size(), 0.0);
  GenericDerivative rates;
  if (const Status status = accelerations(state, no_tau, rates); !status.ok()) return status;
  System<double>& system = equations_->system(state);
  const Solved s = equations_->solved(system, no_tau, rates.zdd);
  const std::vector<double> drive = equations_->driving_forces(system, s);
  loads = reaction_loads(system, {s.prepared.kinematics, s.prepared.velocities, s.accelerations, s.forces, rates.zdd,
                                  s.multipliers, drive});
  return {};
}

Status GenericSolver::set_friction_loads(GenericState& state) const {
  const Model& model = equations_->model;
  if (!takes_reactions(model)) return {};
  std::vector<double> loads;
  const Status status = take_loads(state, loads);
  if (!status.ok()) return status;
  GenericState pressed = state;
  const auto first = static_cast<std::size_t>(first_sampled_value(model));
  each_friction(model, [&](const FrictionLaw& friction) {
    if (friction.load >= 0) pressed.x[first + friction.load] = loads[friction.load];
  });
  const Status finite = equations_->check_arguments(pressed, {});
  if (finite.ok()) state = std::move(pressed);
  return finite;
}

Status GenericSolver::sample(GenericState& state, double h, bool& any) const {
  const Model& model = equations_->model;
  any = false;
  if (model.sampled.empty()) return {};
  Status status = equations_->check_arguments(state, {});
  if (!status.ok()) return status;
  const int held_count = held_state_count(model), first = first_sampled_value(model);
  const int count = static_cast<int>(model.sampled.size());
  std::vector<double> periods, due(model.sampled.size()), loads;
  for (const SampledValue& value : model.sampled) periods.push_back(value.period);
  status = find_due(periods.data(), count, first, state.t, h, due.data(), any);
  if (!status.ok() || !any) return status;
  System<double>& system = equations_->system(state);
  if (takes_reactions(model)) {
    status = take_loads(state, loads);
  } else {
    const Kinematics<double> k = kinematics(system);
    see_values(system, k, velocities(system, k));
  }
  if (!status.ok()) return status;
  return take_held(sampled_states(system, due, loads).data(), held_count, first, state.x.data());
}

}  // namespace mbgen
