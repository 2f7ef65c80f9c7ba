#pragma once
// Motions of the recursive form: every body about its own origin; in loop blocks against the base, in its axes.

#include "compiler/formulation/column_names.hpp"
#include "compiler/formulation/motion.hpp"
#include "compiler/formulation/recursion/recursion_units.hpp"

namespace mbgen {

/// Three joint axes by which quasi-velocities and joint rates are exchanged, in the joint's frame.
template <class T>
struct QuasiAxes {
  Vector<T> axis[3];
  Vector<T> dual[3];  ///< dual[a] . axis[b] = 1 for a = b, else 0
  T volume{1.0};      ///< of the axes' parallelepiped: zero where the joint rates are singular
};

/// Data that the passes of the recursive form share.
template <class T>
struct RecursionWork {
  System<T>& system;
  const Recursion& recursion;
  const Kinematics<T>& k;
  std::vector<Vector<T>> offset;        ///< bodies of blocks: origin from the previous body's origin, base frame, m
  std::vector<QuasiAxes<T>> quasi;      ///< per tree body that ends a quasi step
  std::vector<const JointStep*> step;   ///< per tree body: the step that ends there, null inside a step
  std::vector<std::string> names = {};  ///< per tree joint, in programs for reading: of its (quasi-)velocity

  int parent(const JointStep& s) const { return system.topology.bodies[s.joints[0]].parent; }
  bool own(int body) const { return recursion.layout.bodies[body].own_frame; }
  /// Origin of a body in the frame that its input joint is seen from.
  const Vector<T>& origin(int body) const { return k.position[body]; }
  const std::string& name_of(int joint) const {
    return names.empty() ? system.topology.bodies[joint].coordinate : names[static_cast<std::size_t>(joint)];
  }
  ColumnNames columns_of(const RecursionUnit& unit) const { return {system.topology, unit.joints, &names}; }
};

template <class T>
QuasiAxes<T> quasi_axes(const System<T>& system, const Kinematics<T>& k, const JointStep& step) {
  QuasiAxes<T> q;
  for (int c = 0; c < 3; ++c) q.axis[c] = q.dual[c] = k.axis[step.joints[c]];
  if (!step.revolute) return q;
  const Vector<T> across = cross(q.axis[1], q.axis[2]);
  q.volume = dot(q.axis[0], across);
  const T scale = T(1.0) / q.volume;
  q.dual[0] = scale * across;
  q.dual[2] = scale * cross(q.axis[0], q.axis[1]);
  const auto constant_axis = [&](int c) { return constant<double>(system.topology.bodies[step.joints[c]].axis); };
  const auto square = [&](int a, int b) { return std::abs(dot(constant_axis(a), constant_axis(b))) <= 1e-15; };
  const bool cardan = square(0, 1) && square(1, 2);
  if (!cardan) q.dual[1] = scale * cross(q.axis[2], q.axis[0]);  // else the middle axis is its own dual
  return q;
}

/// Names the exchange of joint rates and quasi-velocities in programs for reading.
template <class T>
void detail_quasi_axes(const System<T>& system, const JointStep& step, const QuasiAxes<T>& q) {
  if (!system.annotator.has_details()) return;
  system.annotator.detail(q.volume, "volume_", system.body_name(step.body()));
  system.annotator.detail(T(1.0) / q.volume, "per_volume_", system.body_name(step.body()));
  for (int c = 0; c < 3; ++c) {
    const std::string& coordinate = system.topology.bodies[step.joints[c]].coordinate;
    detail_name(system.annotator, q.axis[c], "axis_", coordinate);
    detail_name(system.annotator, q.dual[c], "dual_", coordinate);
  }
}

/// Names of the (quasi-)velocities per tree joint: coordinates, and for three joints that turn or move together the
/// axes of the components, as carrier_left_about_x of carrier_left_rz, _rx and _ry.
inline std::vector<std::string> velocity_names(const Topology& topology, const Recursion& recursion) {
  std::vector<std::string> names;
  for (const TreeBody& body : topology.bodies) names.push_back(body.coordinate);
  const auto stem = [&](int joint) {
    const std::string& name = topology.bodies[joint].coordinate;
    return name.substr(0, name.size() < 3 ? 0 : name.size() - 3);
  };
  for (const RecursionUnit& unit : recursion.units)
    for (const JointStep& step : unit.steps) {
      if (!step.quasi()) continue;
      const std::string first = stem(step.joints[0]);
      const bool is_one_joint = first == stem(step.joints[1]) && first == stem(step.joints[2]);
      const std::string& of = is_one_joint ? first : topology.bodies[step.body()].name;
      for (std::size_t c = 0; c < 3; ++c)
        names[static_cast<std::size_t>(step.joints[c])] = of + (step.revolute ? "_about_" : "_along_") + "xyz"[c];
    }
  return names;
}

template <class T>
RecursionWork<T> recursion_work(System<T>& system, const Recursion& recursion, const Kinematics<T>& k) {
  const auto poses = system.annotator.step(Step::inertias);
  const std::size_t n = system.topology.bodies.size();
  RecursionWork<T> work{system, recursion, k, {}, {}, {}};
  work.offset.resize(n);
  work.quasi.resize(n);
  work.step.resize(n, nullptr);
  if (system.annotator.has_details()) work.names = velocity_names(system.topology, recursion);
  for (const RecursionUnit& unit : recursion.units)
    for (const JointStep& step : unit.steps) {
      const int body = step.body(), first = step.joints[0], p = work.parent(step);
      work.step[body] = &step;
      const auto heading = within_body(system.annotator, body);
      if (step.quasi()) work.quasi[body] = quasi_axes(system, k, step);
      if (step.quasi()) detail_quasi_axes(system, step, work.quasi[body]);
      if (unit.block < 0) continue;
      const Matrix<T> axes = p == unit.base ? identity<T>() : k.orientation[p];
      work.offset[body] = axes * joint_offset(system, first);
      if (!step.revolute) work.offset[body] = work.offset[body] + system.z(first) * k.axis[first];
      detail_name(system.annotator, work.offset[body], "offset_", system.body_name(body));
    }
  return work;
}

/// Joint motion of a step for given values of its joints' (quasi-)velocities: of the joint's child against its parent,
/// about the child's origin when the joint's pin is there.
/// values: by tree joint.
template <class T, class Values>
Spatial<T> step_motion(const RecursionWork<T>& work, const JointStep& step, const Values& values) {
  const Vector<T> motion = step.quasi()
                               ? Vector<T>{values[step.joints[0]], values[step.joints[1]], values[step.joints[2]]}
                               : values[step.joints[0]] * work.k.axis[step.joints[0]];
  return step.revolute ? Spatial<T>{{}, motion} : Spatial<T>{motion, {}};
}

/// Motion of a block's bodies against the base, linear in the values of its joints (by tree joint), about their
/// origins.
template <class T, class Values>
PerBody<Spatial<T>> block_motion(const RecursionWork<T>& work, const RecursionUnit& unit, const Values& values) {
  PerBody<Spatial<T>> motion(unit);
  for (const JointStep& step : unit.steps) {
    const int p = work.parent(step);
    const auto heading = within_body(work.system.annotator, step.body());
    const Spatial<T> below = p == unit.base ? Spatial<T>{} : motion[p];
    motion[step.body()] =
        Spatial<T>{velocity_at(below, work.offset[step.body()]), below.angular} + step_motion(work, step, values);
  }
  return motion;
}

/// Puts the components of a quasi step's vector in place of the values of its joints. at: the value of a tree joint.
template <class T, class At>
void set_components(const JointStep& step, const Vector<T>& v, const At& at) {
  at(step.joints[0]) = v.x;
  at(step.joints[1]) = v.y;
  at(step.joints[2]) = v.z;
}

/// Sum of the joint rates of a quasi step times their axes.
template <class T>
Vector<T> rate_sum(const RecursionWork<T>& work, const JointStep& step) {
  const QuasiAxes<T>& q = work.quasi[step.body()];
  const auto rate = [&](int c) { return work.system.zd(step.joints[c]) * q.axis[c]; };
  return rate(0) + rate(1) + rate(2);
}

/// Joint rates, with the rates of quasi steps replaced by quasi-velocities.
template <class T>
std::vector<T> quasi_velocities(const RecursionWork<T>& work) {
  std::vector<T> values = work.system.environment.zd;
  for (const JointStep* step : work.step) {
    if (step == nullptr || !step->quasi()) continue;
    const auto heading = within_body(work.system.annotator, step->body());
    set_components(*step, rate_sum(work, *step), [&](int j) -> T& { return values[j]; });
  }
  return values;
}

/// Generalised forces, with the forces of quasi steps replaced by forces on the quasi-velocities.
template <class T>
std::vector<T> quasi_forces(const RecursionWork<T>& work, std::vector<T> tau) {
  for (const JointStep* step : work.step) {
    if (step == nullptr || !step->quasi()) continue;
    const auto heading = within_body(work.system.annotator, step->body());
    const QuasiAxes<T>& q = work.quasi[step->body()];
    const auto part = [&](int c) { return tau[step->joints[c]] * q.dual[c]; };
    set_components(*step, part(0) + part(1) + part(2), [&](int j) -> T& { return tau[j]; });
  }
  return tau;
}

/// Joint accelerations of a quasi step. before: angular velocity of the body before it, in the frame of the axes.
template <class T>
void set_joint_accelerations(const RecursionWork<T>& work, const JointStep& step, const Vector<T>& before,
                             const Vector<T>& quasi, std::vector<T>& zdd) {
  const QuasiAxes<T>& q = work.quasi[step.body()];
  Vector<T> left = quasi;
  if (step.revolute) {
    Vector<T> turning = before;
    for (int c = 0; c < 3; ++c) {
      const Vector<T> rate = work.system.zd(step.joints[c]) * q.axis[c];
      left = left - cross(turning, rate);
      turning = turning + rate;
    }
  }
  for (int c = 0; c < 3; ++c) zdd[step.joints[c]] = dot(q.dual[c], left);
}

/// Rows of a block's projection over joint rates, with rows of quasi steps replaced by quasi-velocities.
/// rz: [column of the block][free direction], columns as unit.joints.
template <class T>
std::vector<std::vector<T>> quasi_projection(const RecursionWork<T>& work, const RecursionUnit& unit,
                                             std::vector<std::vector<T>> rz) {
  for (const JointStep& step : unit.steps) {
    if (!step.quasi()) continue;
    const QuasiAxes<T>& axes = work.quasi[step.body()];
    for (std::size_t q = 0; q < rz.front().size(); ++q) {
      const auto at = [&](int joint) -> T& { return rz[unit.column(joint)][q]; };
      const auto part = [&](int c) { return at(step.joints[c]) * axes.axis[c]; };
      set_components(step, part(0) + part(1) + part(2), at);
    }
  }
  return rz;
}

/// Joint accelerations of a block with those of quasi steps replaced by quasi-accelerations: the inverse of
/// set_joint_accelerations. velocity: of the block's bodies against the base.
template <class T>
std::vector<T> quasi_accelerations(const RecursionWork<T>& work, const RecursionUnit& unit,
                                   const PerBody<Spatial<T>>& velocity, std::vector<T> zdd) {
  for (const JointStep& step : unit.steps) {
    if (!step.quasi()) continue;
    const QuasiAxes<T>& axes = work.quasi[step.body()];
    const int p = work.parent(step);
    const auto at = [&](int joint) -> T& { return zdd[unit.column(joint)]; };
    Vector<T> sum, turning = p == unit.base ? Vector<T>{} : velocity[p].angular;
    for (int c = 0; c < 3; ++c) {
      sum = sum + at(step.joints[c]) * axes.axis[c];
      if (!step.revolute) continue;
      const Vector<T> rate = work.system.zd(step.joints[c]) * axes.axis[c];
      sum = sum + cross(turning, rate);
      turning = turning + rate;
    }
    set_components(step, sum, at);
  }
  return zdd;
}

/// Acceleration of a body's origin, angular, and the gradient w~w~ + alpha~.
template <class T>
struct BodyAcceleration {
  Vector<T> linear, angular;
  Matrix<T> gradient{};
};

/// Accelerations of a block's bodies against the base under the present velocities and zero accelerations of single
/// joints. quasi: accelerations of the quasi steps, by column of the block; empty: zero.
template <class T>
PerBody<BodyAcceleration<T>> block_bias(const RecursionWork<T>& work, const RecursionUnit& unit,
                                        const PerBody<Spatial<T>>& velocity, const std::vector<T>& quasi = {}) {
  PerBody<BodyAcceleration<T>> bias(unit);
  for (const JointStep& step : unit.steps) {
    const int body = step.body(), p = work.parent(step);
    const auto heading = within_body(work.system.annotator, body);
    const BodyAcceleration<T> below = p == unit.base ? BodyAcceleration<T>{} : bias[p];
    const Vector<T> turning = p == unit.base ? Vector<T>{} : velocity[p].angular;
    BodyAcceleration<T> b{below.linear + below.gradient * work.offset[body], below.angular, below.gradient};
    if (step.quasi() && !quasi.empty()) {
      const auto at = [&](int c) -> const T& { return quasi[unit.column(step.joints[c])]; };
      b.angular = b.angular + Vector<T>{at(0), at(1), at(2)};
    } else if (!step.quasi()) {
      const Vector<T> coriolis = cross(turning, work.system.zd(step.joints[0]) * work.k.axis[step.joints[0]]);
      if (step.revolute)
        b.angular = b.angular + coriolis;
      else
        b.linear = b.linear + coriolis + coriolis;
    }
    if (step.revolute) b.gradient = acceleration_gradient(velocity[body].angular, b.angular);
    detail_name(work.system.annotator, b.linear, "abias_", work.system.body_name(body));
    detail_name(work.system.annotator, b.angular, "alphabias_", work.system.body_name(body));
    detail_name(work.system.annotator, b.gradient, "Gbias_", work.system.body_name(body));
    bias[body] = b;
  }
  return bias;
}

/// The same under zero accelerations of all joints, those of quasi steps too.
template <class T>
PerBody<BodyAcceleration<T>> rate_bias(const RecursionWork<T>& work, const RecursionUnit& unit,
                                       const PerBody<Spatial<T>>& velocity) {
  const std::vector<T> zero(unit.joints.size(), T(0.0));
  return block_bias(work, unit, velocity, quasi_accelerations(work, unit, velocity, zero));
}

}  // namespace mbgen
