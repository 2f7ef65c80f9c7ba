#pragma once
// The user's states: values for expressions, lengths of springs for expressions, and rates.

#include <cstddef>
#include <set>

#include "compiler/formulation/elements/force_work.hpp"
#include "compiler/model/auxiliary_states.hpp"

namespace mbgen {
namespace detail {

/// Numbers of the springs, air springs and rods with their length or rate in an expression of the model.
inline std::set<int> lengths_looked_at(const Model& model) {
  using Kind = ExpressionNode::Kind;
  std::set<int> looked_at;
  for (const Expression& expression : model.expressions)
    for (const ExpressionNode& node : expression.nodes)
      if (node.kind == Kind::length || node.kind == Kind::rate) looked_at.insert(node.index);
  return looked_at;
}

}  // namespace detail

/// Sets the user's states, the sampled values, and the used lengths for expressions.
template <class T>
void see_states_and_lengths(System<T>& system, const Kinematics<T>& k, const Velocities<T>& v) {
  const Model& model = system.model;
  Environment<T>& environment = system.environment;
  environment.states.assign(system.x.begin() + first_user_state(model), system.x.end());
  const std::set<int> looked_at = detail::lengths_looked_at(model);
  const T unseen(0.0);
  environment.observed.assign(model.observed.size(), T(0.0));
  environment.lengths.clear();
  environment.rates.clear();
  each_line(model, [&](const auto& element) {
    const bool is_seen = looked_at.contains(static_cast<int>(environment.lengths.size()));
    environment.lengths.push_back(unseen);
    environment.rates.push_back(unseen);
    if (!is_seen) return;
    const detail::Line<T> line = detail::line_between(system, k, v, element.from, element.to);
    environment.lengths.back() = line.length;
    environment.rates.back() = line.rate;
  });
}

namespace detail {

/// Rates of the user's states.
template <class T>
void user_states(ForceWork<T>& work) {
  const Model& model = work.system.model;
  std::size_t place = static_cast<std::size_t>(first_user_state(model));
  for (const UserState& state : model.states) {
    const auto heading = work.system.annotator.within(OwnerKind::state, index_in(model.states, state));
    T rate = work.value(state.derivative);
    work.system.annotator.name(rate, "rate_", state.name);
    work.forces.xd[place++] = rate;
  }
}

}  // namespace detail

/// Auxiliary states that are constant between instants, after the values of `due` are set. due: per sampled value, 1 if
/// its instant is now, else 0; loads: see reaction_loads, none if no value is a load. Requires: see_values, or
/// reaction_loads.
template <class T>
std::vector<T> sampled_states(System<T>& system, const std::vector<T>& due, const std::vector<T>& loads) {
  using mbgen::select;
  const Model& model = system.model;
  const auto first_value = static_cast<std::size_t>(model.states.size());
  std::vector<T>& seen = system.environment.states;
  std::size_t waiting = first_value + model.sampled.size();
  for (std::size_t i = 0; i < model.sampled.size(); ++i) {
    const SampledValue& sampled = model.sampled[i];
    const auto heading = system.annotator.within(OwnerKind::sampled, i);
    const T is_due = due[i] - T(0.5);
    // The last pending value takes effect next, and each moves up by one.
    T next = sampled.load ? loads[i] : value_of(model, sampled.value, system.environment);
    for (int k = 0; k < sampled.delay; ++k, ++waiting) {
      const T before = seen[waiting];
      seen[waiting] = select(is_due, next, before);
      next = before;
    }
    seen[first_value + i] = select(is_due, next, seen[first_value + i]);
  }
  return {seen.begin() + static_cast<std::ptrdiff_t>(first_value), seen.end()};
}

}  // namespace mbgen
