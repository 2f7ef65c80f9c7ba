#pragma once
// States of the user's own: what expressions see of them and of the lengths of springs, and their rates.

#include <algorithm>

#include "compiler/formulation/force_work.hpp"
#include "compiler/model/auxiliary_states.hpp"

namespace mbgen {
namespace detail {

/// Whether an expression of the model looks at the length of an element or at its rate.
inline bool looks_at_length(const Model& model, int element) {
  using Kind = ExpressionNode::Kind;
  const auto is_it = [element](const ExpressionNode& node) {
    return (node.kind == Kind::length || node.kind == Kind::rate) && node.index == element;
  };
  return std::any_of(model.expressions.begin(), model.expressions.end(), [&](const Expression& expression) {
    return std::any_of(expression.nodes.begin(), expression.nodes.end(), is_it);
  });
}

}  // namespace detail

/// Gives expressions the states of the user's own, the sampled values, and those lengths that one looks at.
template <class T>
void see_states_and_lengths(System<T>& system, const Kinematics<T>& k, const Velocities<T>& v) {
  const Model& model = system.model;
  Environment<T>& environment = system.environment;
  environment.states.assign(system.x.begin() + first_user_state(model), system.x.end());
  environment.lengths.assign(model.springs.size() + model.air_springs.size() + model.rods.size(), T(0.0));
  environment.rates = environment.lengths;
  const auto see = [&](int element, const Attachment& from, const Attachment& to) {
    if (!detail::looks_at_length(model, element)) return;
    const detail::Line<T> line = detail::line_between(system, k, v, from, to);
    environment.lengths[element] = line.length;
    environment.rates[element] = line.rate;
  };
  int element = 0;
  for (const PointSpring& spring : model.springs) see(element++, spring.from, spring.to);
  for (const AirSpring& spring : model.air_springs) see(element++, spring.from, spring.to);
  for (const Rod& rod : model.rods) see(element++, rod.from, rod.to);
}

namespace detail {

/// Rates of the states of the user's own; sampled values hold between the instants at which they are set.
template <class T>
void user_states(ForceWork<T>& work) {
  const Model& model = work.system.model;
  for (const UserState& state : model.states) {
    const auto heading = work.system.scribe.within(OwnerKind::state, index_in(model.states, state));
    T rate = work.value(state.derivative);
    work.system.scribe.name(rate, "rate_", state.name);
    work.forces.xd.push_back(rate);
  }
  work.forces.xd.resize(work.system.x.size(), T(0.0));
}

}  // namespace detail

/// The auxiliary states that hold between instants, as they are after those of `due` are set. due: per sampled value,
/// 1 where its instant is now, else 0. Requires: see_states_and_lengths.
template <class T>
std::vector<T> sampled_states(System<T>& system, const std::vector<T>& due) {
  using mbgen::select;
  const Model& model = system.model;
  const auto first_value = static_cast<std::size_t>(model.states.size());
  std::vector<T>& seen = system.environment.states;
  std::size_t waiting = first_value + model.sampled.size();
  for (std::size_t i = 0; i < model.sampled.size(); ++i) {
    const SampledValue& sampled = model.sampled[i];
    const auto heading = system.scribe.within(OwnerKind::sampled, i);
    const T is_due = due[i] - T(0.5);
    // The last of those that wait is the next to take effect, and each moves up.
    T next = value_of(model, sampled.value, system.environment);
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
