#pragma once
// Model outputs and the terms of the energy balance.

#include "compiler/formulation/motion_outputs.hpp"
#include "compiler/formulation/reactions.hpp"

namespace mbgen {

template <class T>
struct Energies {
  T kinetic{0.0}, potential{0.0},
      power{0.0};  ///< J, J (gravity), W of all applied forces, tau and drives but not gravity
};

namespace detail {

template <class T>
T reaction_output(const System<T>& system, const Kinematics<T>& k, const Reactions<T>& reactions,
                  const ReactionOutput& output) {
  const bool of_joint = output.joint >= 0, at_to = output.end == ReactionOutput::End::to;
  const Reaction<T>& reaction = of_joint ? reactions.joints[output.joint] : reactions.rods[output.rod];
  const Spatial<T>& wrench = at_to ? reaction.on_to : reaction.on_from;
  const Vector<T>& value = output.what == ReactionOutput::What::force ? wrench.linear : wrench.angular;
  if (!output.in_body_axes) return component(direction_in(system, k, reaction.frame, value, kGround), output.axis);
  const auto end_of = [&](const auto& connection) { return at_to ? connection.to.body : connection.from.body; };
  const int body = of_joint ? end_of(system.model.joints[output.joint]) : end_of(system.model.rods[output.rod]);
  return component(in_axes_of(system, k, reaction.frame, value, body), output.axis);
}

template <class T>
T multiplier_output(const Topology& topology, const SolvedState<T>& s, const MultiplierOutput& output) {
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    int first = 0;
    for (int l : topology.blocks[b].loops) {
      const Loop& loop = topology.loops[l];
      const bool is_asked = loop.joint == output.joint && loop.rod == output.rod && loop.coupling == output.coupling;
      if (is_asked) return s.multipliers[b][first + output.equation];
      first += loop.equations;
    }
  }
  return T(0.0);
}

/// Whether an output shows a force or moment that joints transmit.
inline bool asks_for_reactions(const Model& model) {
  const auto shows = [](const Output& output) { return std::holds_alternative<ReactionOutput>(output.source); };
  return std::any_of(model.outputs.begin(), model.outputs.end(), shows) ||
         std::any_of(model.observed.begin(), model.observed.end(),
                     [&](const ObservedOutput& observed) { return shows(observed.output); });
}

/// Value of any output by its source.
template <class T>
struct OutputReader : MotionReader<T> {
  const Reactions<T>& reactions;

  using MotionReader<T>::operator();
  T operator()(const DriveOutput& output) const { return this->s.drive_forces[output.motion]; }
  T operator()(const ReactionOutput& output) const {
    return reaction_output(this->system, this->s.kinematics, reactions, output);
  }
  T operator()(const MultiplierOutput& output) const {
    return multiplier_output(this->system.topology, this->s, output);
  }
};

}  // namespace detail

/// Values of Model::outputs. Ensures: all of Model::observed are set for expressions.
template <class T>
std::vector<T> output_values(System<T>& system, const SolvedState<T>& s) {
  Reactions<T> all_reactions;
  if (detail::asks_for_reactions(system.model)) all_reactions = reactions(system, s);
  const Coordinates<T> users = users_coordinates(system.environment, s.zdd);
  const detail::OutputReader<T> read{{system, s, users}, all_reactions};
  detail::observe(system, kAfterForces, read);
  std::vector<T> values;
  for (const Output& output : system.model.outputs) {
    const auto heading = system.annotator.within(OwnerKind::output, index_in(system.model.outputs, output));
    values.push_back(std::visit(read, output.source));
  }
  return values;
}

namespace detail {

/// First moment of all mass about the origin of ground, in its axes, kg m. Cost: linear, each frame with all that moves
/// on it.
template <class T>
Vector<T> first_moment(const System<T>& system, const Kinematics<T>& k) {
  const Constants<T>& c = system.constants;
  const int n = system.topology.size();
  std::vector<T> mass(n + 1, T(0.0));
  std::vector<Vector<T>> moment(n + 1);
  const auto place_in = [n](int frame) { return frame == kGround ? n : frame; };
  const auto add = [&](int frame, const T& m, const Vector<T>& at) {
    mass[place_in(frame)] += m;
    moment[place_in(frame)] = moment[place_in(frame)] + m * at;
  };
  for (int i = 0; i < n; ++i) {
    const Vector<T> com = inertia_arm(system, k, i, c.com[i], MotionPoint::frame_origin);
    add(system.layout.frame_of(i), c.mass[i], com);
  }
  for (const LoopBlock& block : system.topology.blocks)
    for (int l : block.loops) {
      const Loop& loop = system.topology.loops[l];
      if (loop.kind != ClosureKind::rod) continue;
      const RodConstants<T>& rod = c.rods[loop.rod];
      // Beside the m/3 that a body has at its end, which ground has not.
      for (const Place<T>& end : {rod.from, rod.to}) {
        const T mass = end.body == kGround ? T(3.0) * rod.coupling : rod.coupling;
        add(block.base, mass, position_in(system, k, end, block.base));
      }
    }
  for (int i = n - 1; i >= 0; --i) {
    if (!system.layout.bodies[i].own_frame) continue;
    const int base = place_in(system.layout.bodies[i].base);
    system.annotator.detail(mass[i], "mc_", system.topology.bodies[i].name);
    mass[base] += mass[i];
    moment[base] = moment[base] + (mass[i] * k.position[i] + k.orientation[i] * moment[i]);
  }
  return moment[n];
}

/// Twice the kinetic energy of the coupling masses of the rods, J, each in the frame of its block.
template <class T>
T twice_the_energy_of_couplings(const System<T>& system, const SolvedState<T>& s) {
  T twice(0.0);
  for (const LoopBlock& block : system.topology.blocks)
    for (int l : block.loops) {
      const Loop& loop = system.topology.loops[l];
      if (loop.kind != ClosureKind::rod) continue;
      const RodConstants<T>& rod = system.constants.rods[loop.rod];
      const Vector<T> from = velocity_in(system, s.kinematics, s.velocities, rod.from, block.base);
      const Vector<T> to = velocity_in(system, s.kinematics, s.velocities, rod.to, block.base);
      twice = twice + T(2.0) * rod.coupling * dot(from, to);
    }
  return twice;
}

}  // namespace detail

/// Kinetic and gravitational energy, and the power of everything else that is applied. Cost: linear.
template <class T>
Energies<T> energies(System<T>& system, const SolvedState<T>& s, const std::vector<T>& tau,
                     const std::vector<int>& driven) {
  const Constants<T>& c = system.constants;
  Energies<T> e;
  T twice(0.0);
  for (int i = 0; i < system.topology.size(); ++i) {
    const Spatial<T> velocity = velocity_of(system, s.velocities, i);
    const Vector<T> com = inertia_arm(system, s.kinematics, i, c.com[i], s.velocities.about);
    const Vector<T> v = velocity_at(velocity, com);
    const Vector<T> w = transposed_times(inertia_axes(system, s.kinematics, i), velocity.angular);
    twice = twice + c.mass[i] * dot(v, v) + dot(w, c.inertia[i] * w);
    e.power = e.power + dot(s.forces.wrench[i], velocity) + (tau[i] + s.forces.joint[i]) * system.zd(i);
  }
  twice = twice + detail::twice_the_energy_of_couplings(system, s);
  e.potential = -dot(system.constants.gravity, detail::first_moment(system, s.kinematics));
  for (std::size_t g = 0; g < driven.size(); ++g) e.power = e.power + s.drive_forces[g] * system.zd(driven[g]);
  e.kinetic = T(0.5) * twice;
  return e;
}

}  // namespace mbgen
