#pragma once
// Applied forces (step 5): force elements of the model as wrenches on bodies, generalised forces on coordinates, and
// rates of the auxiliary states. The laws themselves are templates of the runtime's headers.

#include "compiler/formulation/elements/every_kind.hpp"
#include "compiler/formulation/elements/user_states.hpp"
#include "compiler/formulation/motion_outputs.hpp"

namespace mbgen {

/// All applied forces except gravity. Ensures: states, lengths, and the observed outputs that need no accelerations are
/// set for expressions. Cost: linear in the number of elements, for each round of them.
template <class T>
AppliedForces<T> applied_forces(System<T>& system, const Kinematics<T>& k, const Velocities<T>& v,
                                const detail::SharedTyreLaw<T>& shared_law = {}) {
  AppliedForces<T> forces;
  forces.about = v.about;
  forces.wrench.resize(system.topology.bodies.size());
  forces.joint.assign(system.topology.bodies.size(), T(0.0));
  forces.xd.assign(system.x.size(), T(0.0));  // sampled values are constant between the instants at which they are set
  see_states_and_lengths(system, k, v);
  detail::ForceWork<T> work{system, k, v, forces, shared_law};
  detail::observe(system, k, v, forces, kBeforeForces);
  const int last = last_round(system.model);
  for (int round = 0; round <= last; ++round) {
    each_element(system.model, [&](const auto& element) {
      if (last > 0 && round_of(system.model, element) != round) return;
      const auto heading = within(system, element);
      if (system.annotator.has_details()) work.in_hand = element.name;
      apply(work, element);
    });
    detail::observe(system, k, v, forces, round);
  }
  detail::user_states(work);
  for (std::size_t i = 0; i < forces.wrench.size() && system.annotator.has_details(); ++i) {
    const auto heading = within_body(system.annotator, i);
    detail_name(system.annotator, forces.wrench[i], "fa", "na", system.topology.bodies[i].name);
    system.annotator.detail(forces.joint[i], "Qa_", system.topology.bodies[i].coordinate);
  }
  return forces;
}

/// Sets everything that expressions look at and that needs no accelerations.
template <class T>
void see_values(System<T>& system, const Kinematics<T>& k, const Velocities<T>& v) {
  see_states_and_lengths(system, k, v);
  if (!system.model.observed.empty()) static_cast<void>(applied_forces(system, k, v));
}

}  // namespace mbgen
