#pragma once
// Reactions as loads that press parts together.

#include "compiler/formulation/outputs.hpp"

namespace mbgen {
namespace detail {

/// Size of a reaction, N or N m, the whole or in a direction of the joint.
template <class T>
T size_of(const System<T>& system, const Kinematics<T>& k, const Reactions<T>& reactions, const ReactionLoad& load) {
  const Reaction<T>& reaction = load.joint >= 0 ? reactions.joints[load.joint] : reactions.rods[load.rod];
  const Vector<T>& value = load.what == ReactionOutput::What::force ? reaction.on_to.linear : reaction.on_to.angular;
  if (load.direction == ReactionLoad::Direction::whole) return norm(value);
  const Joint& joint = system.model.joints[load.joint];
  const Vector<T> axis =
      direction_in(system, k, system.topology.tree_body[joint.from.body], constant<T>(joint.axis), reaction.frame);
  return load.direction == ReactionLoad::Direction::along ? abs(dot(value, axis)) : norm(cross(value, axis));
}

}  // namespace detail

/// Per sampled value the reaction that it is set to, N or N m; zero where it is another one. Ensures: all of
/// Model::observed are set for expressions. Cost: linear.
template <class T>
std::vector<T> reaction_loads(System<T>& system, const SolvedState<T>& s) {
  using mbgen::abs;
  std::vector<T> loads(system.model.sampled.size(), T(0.0));
  const Reactions<T> all = reactions(system, s);
  const Coordinates<T> users = users_coordinates(system.environment, s.zdd);
  detail::observe(system, kAfterForces, detail::OutputReader<T>{{system, s, users}, all});
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const auto heading = system.annotator.within(OwnerKind::sampled, i);
    const std::optional<ReactionLoad>& load = system.model.sampled[i].load;
    if (load) loads[i] = detail::size_of(system, s.kinematics, all, *load);
  }
  return loads;
}

}  // namespace mbgen
