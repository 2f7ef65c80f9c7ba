#pragma once
// Relative position of an attachment in another body's axes, for forces with directions fixed to that body.

#include "compiler/formulation/elements/force_work.hpp"

namespace mbgen::detail {

/// The attachment `to` relative to the attachment `from`; vectors in the axes of the body of `from`.
template <class T>
struct SeenPlace {
  Place<T> from, to;
  int frame = kGround;  ///< that both bodies see
  Vector<T> gap;        ///< from `from` to `to`, m
  Vector<T> drift;      ///< rate of `gap` relative to the body of `from`, m/s
  Vector<T> spin;       ///< of the body, rad/s
};

/// Angular velocity of a body in the axes of another frame.
template <class T>
Vector<T> spin_in(const ForceWork<T>& work, int body, int frame) {
  return direction_in(work.system, work.k, work.system.layout.frame_of(body),
                      velocity_of(work.system, work.v, body).angular, frame);
}

template <class T>
SeenPlace<T> seen_place(const ForceWork<T>& work, const Attachment& from, const Attachment& to) {
  const System<T>& system = work.system;
  SeenPlace<T> s;
  s.from = work.place(from);
  s.to = work.place(to);
  s.frame = common_frame(system, s.from.body, s.to.body);
  const auto in_from = [&](const Vector<T>& v) { return direction_up(system, work.k, s.frame, v, s.from.body); };
  s.gap = in_from(position_in(system, work.k, s.to, s.frame) - position_in(system, work.k, s.from, s.frame));
  const Vector<T> velocity = in_from(velocity_in(system, work.k, work.v, s.to, s.frame) -
                                     velocity_in(system, work.k, work.v, s.from, s.frame));
  s.spin = in_from(spin_in(work, s.from.body, s.frame));
  s.drift = velocity - cross(s.spin, s.gap);
  return s;
}

/// Adds a force and a moment at `to` on the body of `from`, and the opposite on the body of `to`. from, to: from
/// seen_place; force, moment: on `from`, in the axes of its body.
template <class T>
void act_between(ForceWork<T>& work, const Attachment& from, const Attachment& to, const SeenPlace<T>& s,
                 const Vector<T>& force, const Vector<T>& moment) {
  const System<T>& system = work.system;
  const int from_carrier = system.layout.frame_of(s.from.body), to_carrier = system.layout.frame_of(s.to.body);
  const auto on_from = [&](const Vector<T>& v) { return direction_in(system, work.k, s.from.body, v, from_carrier); };
  const auto on_to = [&](const Vector<T>& v) {
    return direction_up(system, work.k, s.frame, direction_in(system, work.k, s.from.body, v, s.frame), to_carrier);
  };
  act(work, {from.body, on_from(force), on_from(moment + cross(s.gap, force)),
             arm_of(system, work.k, s.from, work.forces.about)});
  act(work, {to.body, on_to(-force), on_to(-moment), arm_of(system, work.k, s.to, work.forces.about)});
}

}  // namespace mbgen::detail
