#pragma once
// Forces and moments that joints and rods transmit. Newton's law body by body, from the leaves of the tree to ground:
// the joint that holds a body gives it what inertia takes and neither applied forces nor closures provide. Bodies are
// those of the model, so that a fixed joint has its reaction like any other.

#include "compiler/formulation/dynamics.hpp"
#include "compiler/formulation/solved_state.hpp"

namespace mbgen {

/// Action of a joint or rod on its two bodies. Forces in N, moments in N m about the joint's point on `to`, in the axes
/// of `frame`; a rod's forces act at its ends, without moment.
template <class T>
struct Reaction {
  int frame = kGround;
  Spatial<T> on_to, on_from;
};

template <class T>
struct Reactions {
  std::vector<Reaction<T>> joints, rods;  ///< per Model::joints and Model::rods
};

namespace detail {

/// Sums of wrenches on the bodies of the model. A body's parts come in the frame of the tree body that it moves with,
/// where that has one, and in the frame of that one's base.
template <class T>
struct BodyWrenches {
  const System<T>& system;
  const Kinematics<T>& k;
  std::vector<Spatial<T>> own, base;  ///< per Model::bodies, about the origins of the two frames

  BodyWrenches(const System<T>& s, const Kinematics<T>& kinematics)
      : system(s), k(kinematics), own(s.model.bodies.size()), base(s.model.bodies.size()) {}

  int tree_body(int body) const { return system.topology.tree_body[body]; }
  int base_frame(int body) const {
    return tree_body(body) == kGround ? kGround : system.layout.bodies[tree_body(body)].base;
  }
  /// frame: one of the body's two.
  void add(int body, int frame, const Spatial<T>& wrench) {
    Spatial<T>& sum = frame == tree_body(body) ? own[body] : base[body];
    sum = sum + wrench;
  }
  /// Everything in the base frame.
  Spatial<T> total(int body) const {
    const int tree = tree_body(body);
    if (tree == kGround) return own[body];
    return system.layout.bodies[tree].own_frame ? base[body] + lowered(k, tree, own[body]) : base[body];
  }
};

/// A wrench, and the frame that it is seen in.
template <class T>
struct FramedWrench {
  int frame;
  Spatial<T> wrench;
};

/// A wrench on a joint's child in a frame that knows the parent: bodies without mass inside the joint may have frames
/// of their own, where a coupling of its last coordinates makes one the base of a block.
template <class T>
FramedWrench<T> on_the_parents_side(const BodyWrenches<T>& needed, const TreeJoint& placed) {
  const int parent = needed.tree_body(placed.parent), base = needed.base_frame(placed.parent);
  FramedWrench<T> seen{needed.base_frame(placed.child), needed.total(placed.child)};
  while (seen.frame != parent && seen.frame != base) {
    seen.wrench = lowered(needed.k, seen.frame, seen.wrench);
    seen.frame = needed.system.layout.bodies[seen.frame].base;
  }
  return seen;
}

/// The same wrench about another point of the same frame.
template <class T>
Spatial<T> about(const Vector<T>& point, const Spatial<T>& wrench) {
  return {wrench.linear, wrench.angular - cross(point, wrench.linear)};
}

/// A wrench on a body about the origin of the frame that carries it.
template <class T>
Spatial<T> about_frame(const System<T>& system, const Kinematics<T>& k, int tree, MotionPoint point,
                       const Spatial<T>& wrench) {
  if (point == MotionPoint::frame_origin || system.layout.frame_of(tree) == tree) return wrench;
  return {wrench.linear, wrench.angular + cross(k.position[tree], wrench.linear)};
}

/// Wrench that each body needs from the joints that hold it: inertia less applied forces (weight is in the
/// accelerations).
template <class T>
BodyWrenches<T> needed_wrenches(System<T>& system, const SolvedState<T>& s) {
  BodyWrenches<T> needed(system, s.kinematics);
  const Topology& topology = system.topology;
  for (int b = 0; b < static_cast<int>(system.model.bodies.size()); ++b) {
    if (b == system.model.ground) continue;
    const auto heading = system.annotator.within(OwnerKind::body, b);
    const int tree = topology.tree_body[b];
    const Vector<T> origin = carrier_origin(topology, system.constants, b);
    const Part<T> part = without_noise(part_of(system.model, b, origin, system.environment));
    needed.add(b, system.layout.frame_of(tree),
               about_frame(system, s.kinematics, tree, s.accelerations.about,
                           part_force(system, s.kinematics, tree, part, velocity_of(system, s.velocities, tree).angular,
                                      acceleration_of(system, s.accelerations, tree), s.accelerations.about)));
  }
  for (const Action<T>& action : s.forces.actions) {
    const int tree = topology.tree_body[action.body];
    needed.add(action.body, system.layout.frame_of(tree),
               about_frame(system, s.kinematics, tree, s.forces.about,
                           Spatial<T>{} - force_at(action.force, action.point) - Spatial<T>{{}, action.moment}));
  }
  return needed;
}

/// A cut joint: its rows' wrenches times their multipliers, in the block's base frame. Phi_z' lambda stands on the side
/// of the inertia, so `from` is acted on by the negative.
template <class T>
Reaction<T> cut_reaction(const System<T>& system, const Kinematics<T>& k, const Joint& joint,
                         const std::vector<Row<T>>& rows, const T* lambda, int frame, BodyWrenches<T>& needed) {
  Spatial<T> on_to, from_loses;
  for (std::size_t e = 0; e < rows.size(); ++e) {
    on_to = on_to + lambda[e] * rows[e].wrench_to;
    from_loses = from_loses + lambda[e] * rows[e].wrench_from;
  }
  needed.add(joint.to.body, frame, Spatial<T>{} - on_to);
  needed.add(joint.from.body, frame, from_loses);
  const Vector<T> point = position_in(system, k, place_of(system, joint.to), frame);
  return {frame, about(point, on_to), Spatial<T>{} - about(point, from_loses)};
}

/// A rod: its tension, and its inertia and weight as m/3 of the near and m/6 of the far end's acceleration.
template <class T>
Reaction<T> rod_reaction(const System<T>& system, const SolvedState<T>& s, const Loop& loop, const Row<T>& row,
                         const T& tension, int frame, BodyWrenches<T>& needed) {
  const RodConstants<T>& rod = system.constants.rods[loop.rod];
  const auto acceleration = [&](const Place<T>& end) {
    const Vector<T> local = place_acceleration(system, s.kinematics, s.accelerations, end);
    return direction_in(system, s.kinematics, system.layout.frame_of(end.body), local, frame);
  };
  Vector<T> on_to = tension * row.wrench_to.linear, on_from = -on_to;
  if (!is_zero(rod.coupling)) {
    const Vector<T> from = rod.coupling * acceleration(rod.from), to = rod.coupling * acceleration(rod.to);
    on_to = on_to - (to + to + from);
    on_from = on_from - (from + from + to);
  }
  const Rod& ends = system.model.rods[loop.rod];
  const auto take = [&](int body, const Place<T>& end, const Vector<T>& force) {
    needed.add(body, frame, Spatial<T>{} - force_at(force, position_in(system, s.kinematics, end, frame)));
  };
  take(ends.to.body, rod.to, on_to);
  take(ends.from.body, rod.from, on_from);
  return {frame, {on_to, {}}, {on_from, {}}};
}

/// Reactions of joints and rods that close a loop, taken off the wrenches that their bodies need.
template <class T>
void closure_reactions(System<T>& system, const SolvedState<T>& s, BodyWrenches<T>& needed, Reactions<T>& reactions) {
  const RelativeMotion<T> rest = at_rest<T>(system.topology);
  for (std::size_t b = 0; b < system.topology.blocks.size(); ++b) {
    const LoopBlock& block = system.topology.blocks[b];
    const T* lambda = s.multipliers[b].data();
    for (int l : block.loops) {
      const Loop& loop = system.topology.loops[l];
      if (loop.kind == ClosureKind::coupling) {  // its forces act inside the joints, like those of a motion
        ++lambda;
        continue;
      }
      const std::vector<Row<T>> rows = loop_rows(system, s.kinematics, rest, loop, block.base);
      if (loop.rod >= 0)
        reactions.rods[loop.rod] = rod_reaction(system, s, loop, rows[0], *lambda, block.base, needed);
      else
        reactions.joints[loop.joint] =
            cut_reaction(system, s.kinematics, system.model.joints[loop.joint], rows, lambda, block.base, needed);
      lambda += rows.size();
    }
  }
}

}  // namespace detail

/// Reaction of every joint and rod at a solved state. Cost: linear.
template <class T>
Reactions<T> reactions(System<T>& system, const SolvedState<T>& s) {
  const Topology& topology = system.topology;
  Reactions<T> result;
  result.joints.resize(system.model.joints.size());
  result.rods.resize(system.model.rods.size());
  detail::BodyWrenches<T> needed = detail::needed_wrenches(system, s);
  detail::closure_reactions(system, s, needed, result);
  for (auto placed = topology.tree_joints.rbegin(); placed != topology.tree_joints.rend(); ++placed) {
    const Joint& joint = system.model.joints[placed->joint];
    const auto heading = system.annotator.within(OwnerKind::joint, placed->joint);
    const auto [frame, wrench] = detail::on_the_parents_side(needed, *placed);
    needed.add(placed->parent, frame, wrench);
    const Place<T> to = place_of(system, joint.to);
    const Spatial<T> on_child = detail::about(position_in(system, s.kinematics, to, frame), wrench);
    const Spatial<T> on_parent = Spatial<T>{} - on_child;
    result.joints[placed->joint] =
        placed->reversed ? Reaction<T>{frame, on_parent, on_child} : Reaction<T>{frame, on_child, on_parent};
  }
  return result;
}

}  // namespace mbgen
