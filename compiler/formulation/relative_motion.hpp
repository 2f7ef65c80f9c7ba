#pragma once
// Motion of points and bodies relative to others, in the axes of any body: outputs of points, bodies and wheels.

#include "compiler/formulation/elements/tyre_road.hpp"
#include "compiler/formulation/orientation.hpp"
#include "compiler/formulation/solved_state.hpp"

namespace mbgen::detail {

/// Tree index of a body of the model, kGround for none.
template <class T>
int tree_body(const System<T>& system, int body) {
  return body == kNoBody ? kGround : system.topology.tree_body[body];
}

/// A direction given in the axes of a tree body or a frame, in the axes of another one, wherever the two are.
template <class T>
Vector<T> direction_between(const System<T>& system, const Kinematics<T>& k, int from, const Vector<T>& direction,
                            int to) {
  if (from == to) return direction;
  const int below = common_frame(system, from, to);
  return direction_up(system, k, below, direction_in(system, k, from, direction, below), to);
}

/// A direction given in a frame, in the axes of a body of the model, of none the global ones.
template <class T>
Vector<T> in_axes_of_any(const System<T>& system, const Kinematics<T>& k, int frame, const Vector<T>& direction,
                         int body) {
  const Vector<T> seen = direction_between(system, k, frame, direction, tree_body(system, body));
  return body == kNoBody ? seen : transposed_times(pose_rotation<T>(system.model.bodies[body].pose), seen);
}

/// Angular velocity and acceleration in the axes of a frame, rad/s, rad/s^2.
template <class T>
struct Turning {
  Vector<T> velocity, acceleration;
};

template <class T>
Turning<T> turning_in(const System<T>& system, const SolvedState<T>& s, int body, int frame) {
  const int tree = tree_body(system, body);
  if (tree == kGround) return {};
  const int carrier = system.layout.frame_of(tree);
  const auto seen = [&](const Vector<T>& v) { return direction_between(system, s.kinematics, carrier, v, frame); };
  return {seen(velocity_of(system, s.velocities, tree).angular),
          seen(acceleration_of(system, s.accelerations, tree).angular)};
}

/// Motion of a point relative to another one, as an observer sees it, in the axes of a frame.
template <class T>
Vector<T> relative_motion(const System<T>& system, const SolvedState<T>& s, const PointOutput& output, int frame) {
  const Kinematics<T>& k = s.kinematics;
  const Place<T> point = place_of(system, output.point), other = place_of(system, output.relative_to);
  const Vector<T> gap = position_in(system, k, point, frame) - position_in(system, k, other, frame);
  if (output.what == PointOutput::What::position) return gap;
  const Turning<T> observer = turning_in(system, s, output.observer, frame);
  const Vector<T> velocity = velocity_in(system, k, s.velocities, point, frame) -
                             velocity_in(system, k, s.velocities, other, frame) - cross(observer.velocity, gap);
  if (output.what == PointOutput::What::velocity) return velocity;
  const auto acceleration = [&](const Place<T>& place) {
    const Vector<T> carried = place_acceleration(system, k, s.accelerations, place);
    return direction_in(system, k, system.layout.frame_of(place.body), carried, frame);
  };
  const Vector<T> coriolis = cross(observer.velocity, velocity);
  return acceleration(point) - acceleration(other) - cross(observer.acceleration, gap) - coriolis - coriolis -
         cross(observer.velocity, cross(observer.velocity, gap));
}

template <class T>
T relative_point_output(const System<T>& system, const SolvedState<T>& s, const PointOutput& output) {
  const int frame =
      common_frame(system, tree_body(system, output.point.body), tree_body(system, output.relative_to.body));
  const int axes = output.in_body_axes ? output.point.body : output.axes;
  const Vector<T> motion = relative_motion(system, s, output, frame);
  return component(in_axes_of_any(system, s.kinematics, frame, motion, axes), output.axis);
}

/// Axes of a body of the model in those of another one, of none the global ones.
template <class T>
Matrix<T> relative_axes(const System<T>& system, const Kinematics<T>& k, int body, int other) {
  const int tree = tree_body(system, body);
  const Matrix<T> own = body == kNoBody ? identity<T>() : pose_rotation<T>(system.model.bodies[body].pose);
  const int frame = common_frame(system, tree, tree_body(system, other));
  const auto seen = [&](const Vector<T>& axis) {
    return in_axes_of_any(system, k, frame, direction_in(system, k, tree, axis, frame), other);
  };
  return {seen(own.x), seen(own.y), seen(own.z)};
}

template <class T>
T rotation_output(const System<T>& system, const SolvedState<T>& s, const RotationOutput& output) {
  using What = RotationOutput::What;
  if (output.what <= What::quaternion) {
    const Matrix<T> axes = relative_axes(system, s.kinematics, output.body, output.relative_to);
    if (output.what == What::angle) return angle_of_turn(axes, output.sequence, output.turn);
    if (output.what == What::rotation_vector) return component(rotation_vector(axes), output.axis);
    constexpr int kScalar = 3;
    const Quaternion<T> q = quaternion_of(axes);
    return output.axis == kScalar ? q.w : component(q.v, output.axis);
  }
  const int frame = common_frame(system, tree_body(system, output.body), tree_body(system, output.relative_to));
  const Turning<T> body = turning_in(system, s, output.body, frame),
                   other = turning_in(system, s, output.relative_to, frame);
  Vector<T> motion = body.velocity - other.velocity;
  if (output.what == What::angular_acceleration) {
    const Turning<T> observer = turning_in(system, s, output.observer, frame);
    motion = body.acceleration - other.acceleration - cross(observer.velocity, motion);
  }
  return component(in_axes_of_any(system, s.kinematics, frame, motion, output.axes), output.axis);
}

/// From one point to another, in the axes of a frame at or below both carrying frames, m.
template <class T>
Vector<T> gap_between(const System<T>& system, const Kinematics<T>& k, const Attachment& from, const Attachment& to,
                      int frame) {
  return position_in(system, k, place_of(system, to), frame) - position_in(system, k, place_of(system, from), frame);
}

template <class T>
T points_output(const System<T>& system, const SolvedState<T>& s, const PointsOutput& output) {
  using std::atan2, std::sqrt;
  const Attachment &first = output.points[0], &middle = output.points[1], &last = output.points[2];
  const auto length = [](const Vector<T>& v) { return sqrt(dot(v, v) + T(kTiny * kTiny)); };
  int frame = common_frame(system, tree_body(system, first.body), tree_body(system, middle.body));
  if (last.body < 0) return length(gap_between(system, s.kinematics, middle, first, frame));
  frame = common_frame(system, frame, tree_body(system, last.body));
  const Vector<T> a = gap_between(system, s.kinematics, middle, first, frame),
                  b = gap_between(system, s.kinematics, middle, last, frame);
  return atan2(length(cross(a, b)), dot(a, b));
}

/// A body of the tree that holds the spin axis of an output's wheel: the wheel, or its carrier if it turns on ground.
template <class T>
int body_of_wheel(const System<T>& system, const WheelOutput& output) {
  if (output.tyre >= 0) return tree_body(system, system.model.tyres[output.tyre].centre.body);
  const Joint& joint = system.model.joints[output.joint];
  const int body = tree_body(system, joint.to.body);
  return body == kGround ? tree_body(system, joint.from.body) : body;
}

/// Angles of a wheel's axis, or of the axis that it is steered about, to the axes of a vehicle.
template <class T>
T wheel_output(const System<T>& system, const SolvedState<T>& s, const WheelOutput& output) {
  using std::atan2, std::sqrt;
  using What = WheelOutput::What;
  const T side(output.side);
  if (output.what >= What::caster) {
    const int frame = common_frame(system, tree_body(system, output.lower.body), tree_body(system, output.upper.body));
    const Vector<T> up = gap_between(system, s.kinematics, output.lower, output.upper, frame);
    const Vector<T> seen = in_axes_of_any(system, s.kinematics, frame, up, output.vehicle);
    return output.what == What::caster ? atan2(-seen.x, seen.z) : atan2(-side * seen.y, seen.z);
  }
  const int body = body_of_wheel(system, output);
  const Vector3& spin = output.tyre >= 0 ? system.model.tyres[output.tyre].axis : output.axis;
  const Vector<T> axis = in_axes_of_any(system, s.kinematics, system.layout.frame_of(body),
                                        spin_axis(system, s.kinematics, spin, body), output.vehicle);
  if (output.what == What::camber)
    return -side * atan2(axis.z, sqrt(axis.x * axis.x + axis.y * axis.y + T(kTiny * kTiny)));
  return output.what == What::toe ? side * atan2(axis.x, axis.y) : atan2(-axis.x, axis.y);
}

}  // namespace mbgen::detail
