#pragma once
// The numbers of a model as scalars T: constants when folded, expressions of the tunable parameters otherwise.

#include <algorithm>
#include <vector>

#include "compiler/expressions/evaluate.hpp"
#include "compiler/formulation/annotator.hpp"
#include "compiler/formulation/origins.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Values that expressions may refer to. Coordinates that the tree does not have read as zero (the topology room
/// refuses them).
template <class T>
struct Environment {
  const Topology* topology = nullptr;
  std::vector<T> parameters;  ///< all, in model order
  std::vector<T> inputs;
  T t{0.0};
  std::vector<T> z, zd;              ///< per tree coordinate
  std::vector<T> charts;             ///< per ball of the topology, 0 or 1; empty: all 0
  std::vector<T> users_z, users_zd;  ///< as the model counts them, for expressions; empty: z and zd
  std::vector<T> locals;
  std::vector<T> states;          ///< of the user's own, then sampled values and what they will be
  std::vector<T> lengths, rates;  ///< of springs, air springs, rods: m, m/s; only of elements in expressions
  std::vector<T> observed;        ///< of Model::observed, as far as they are known

  T parameter(int i) const { return parameters[i]; }
  T input(int i) const { return inputs[i]; }
  T time() const { return t; }
  T position(const CoordinateReference& c) const { return at(users_z.empty() ? z : users_z, c); }
  T velocity(const CoordinateReference& c) const { return at(users_zd.empty() ? zd : users_zd, c); }
  T local(int i) const { return locals[i]; }
  T state(int i) const { return states[i]; }
  T length(int i) const { return lengths[i]; }
  T rate(int i) const { return rates[i]; }
  T output(int i) const { return observed[i]; }

 private:
  T at(const std::vector<T>& values, const CoordinateReference& c) const {
    const int i = tree_coordinate(*topology, c);
    return i < 0 || values.empty() ? T(0.0) : values[i];
  }
};

/// Value of a number of the model.
template <class T>
T value_of(const Model& model, const Quantity& quantity, const Environment<T>& environment) {
  if (quantity.expression < 0) return T(quantity.value);
  return evaluate<T>(model.expressions[quantity.expression], environment);
}
template <class T>
Vector<T> value_of(const Model& model, const Vector3Quantity& q, const Environment<T>& environment) {
  return {value_of(model, q[0], environment), value_of(model, q[1], environment), value_of(model, q[2], environment)};
}

/// A place on a tree body, or on ground: position relative to the body frame's origin, in its axes (m).
template <class T>
struct Place {
  int body = kGround;
  Vector<T> at;
};

/// A rod with exact inertia (theory.md section 5), ends as places.
template <class T>
struct RodConstants {
  Place<T> from, to;
  T length{0.0};
  T coupling{0.0};  ///< m_jk = m/6, kg
};

/// All constants of a model that positions and inertias need.
template <class T>
struct Constants {
  std::vector<Vector<T>> shift;   ///< per model body: off its pose at the reference configuration, see shifts
  std::vector<Vector<T>> origin;  ///< per tree body: point on its joint's axis, global at the reference configuration
  std::vector<T> mass;            ///< per tree body, everything merged, with the rods' end masses
  std::vector<Vector<T>> com;     ///< per tree body, from its origin, reference axes
  std::vector<Symmetric<T>> inertia;  ///< per tree body about com, reference axes
  std::vector<RodConstants<T>> rods;  ///< per Model::rods
  Vector<T> gravity;
};

template <class T>
Matrix<T> pose_rotation(const Pose& pose) {
  const Matrix3& r = pose.rotation;
  return {{T(r[0]), T(r[3]), T(r[6])}, {T(r[1]), T(r[4]), T(r[7])}, {T(r[2]), T(r[5]), T(r[8])}};
}

/// Global position of a point given in a body frame while the body is at its pose.
template <class T>
Vector<T> reference_position(const Model& model, int body, const Vector3Quantity& point,
                             const Environment<T>& environment) {
  const Pose& pose = model.bodies[body].pose;
  return constant<T>(pose.origin) + pose_rotation<T>(pose) * value_of(model, point, environment);
}

/// How far tunable parameters have moved an attachment's point from where the model has it, global axes.
template <class T>
Vector<T> tuned_displacement(const Model& model, const Attachment& at, const Environment<T>& environment) {
  const Vector3Quantity& point = model.bodies[at.body].points[at.point].position;
  const auto moved = [&](const Quantity& q) {
    return q.expression < 0 ? T(0.0) : value_of(model, q, environment) - T(q.value);
  };
  return pose_rotation<T>(model.bodies[at.body].pose) * Vector<T>{moved(point[0]), moved(point[1]), moved(point[2])};
}

/// Displacement of each body at the reference configuration: the points of a joint of the tree meet whatever parameters
/// make of them, so a body moves as the point that holds it and against its own. Zero at the model's parameters.
template <class T>
std::vector<Vector<T>> shifts(const Model& model, const Topology& topology, const Environment<T>& environment) {
  std::vector<Vector<T>> shift(model.bodies.size());
  for (const TreeJoint& tree_joint : topology.tree_joints) {
    const Joint& joint = model.joints[tree_joint.joint];
    const Attachment &parent = tree_joint.reversed ? joint.to : joint.from,
                     &child = tree_joint.reversed ? joint.from : joint.to;
    shift[tree_joint.child] = shift[tree_joint.parent] + tuned_displacement(model, parent, environment) -
                              tuned_displacement(model, child, environment);
  }
  return shift;
}

/// Origin of the frame that carries a body, global while the body is at its pose.
template <class T>
Vector<T> carrier_origin(const Topology& topology, const Constants<T>& constants, int body) {
  const int tree = topology.tree_body[body];
  return (tree == kGround ? Vector<T>{} : constants.origin[tree]) - constants.shift[body];
}

/// Place of an attachment, relative to the frame of the tree body that carries it.
template <class T>
Place<T> place_of(const Model& model, const Topology& topology, const Constants<T>& constants,
                  const Attachment& attachment, const Environment<T>& environment) {
  const Vector<T> global = reference_position(
      model, attachment.body, model.bodies[attachment.body].points[attachment.point].position, environment);
  return {topology.tree_body[attachment.body], global - carrier_origin(topology, constants, attachment.body)};
}

/// Distance of two places while their bodies are at their poses, which no joint that is tuned changes.
template <class T>
T reference_distance(const Topology& topology, const Constants<T>& constants, const Attachment& from,
                     const Place<T>& from_place, const Attachment& to, const Place<T>& to_place) {
  const auto global = [&](const Attachment& at, const Place<T>& place) {
    return place.at + carrier_origin(topology, constants, at.body);
  };
  return norm(global(from, from_place) - global(to, to_place));
}

/// A rigid part: mass, centre of mass, inertia about it.
template <class T>
struct Part {
  T mass{0.0};
  Vector<T> com;
  Symmetric<T> inertia;
};

/// Two parts as one.
template <class T>
Part<T> joined(const Part<T>& a, const Part<T>& b) {
  const Symmetric<T> inertia = a.inertia + b.inertia;
  if (is_zero(a.mass)) return {b.mass, b.com, inertia};
  if (is_zero(b.mass)) return {a.mass, a.com, inertia};
  const T mass = a.mass + b.mass;
  const T share = b.mass / mass;
  const Vector<T> gap = b.com - a.com;
  return {mass, a.com + share * gap, inertia + point_inertia(a.mass * share, gap)};
}

/// Constants that cancelled but for rounding become zero: left and right rods, for example, leave no product of
/// inertia.
template <class T>
T without_noise(const T& value, double scale) {
  constexpr double kNoise = 1e-15;
  return known_size(value) <= kNoise * scale && known_size(value) > 0 ? T(0.0) : value;
}
template <class T>
Part<T> without_noise(const Part<T>& part) {
  const Symmetric<T>& j = part.inertia;
  const double size = known_size(j.xx) + known_size(j.yy) + known_size(j.zz);
  const double reach = known_size(part.com.x) + known_size(part.com.y) + known_size(part.com.z);
  const auto length = [&](const T& value) { return without_noise(value, reach); };
  const auto entry = [&](const T& value) { return without_noise(value, size); };
  return {part.mass,
          {length(part.com.x), length(part.com.y), length(part.com.z)},
          {entry(j.xx), entry(j.yy), entry(j.zz), entry(j.xy), entry(j.xz), entry(j.yz)}};
}

/// A model body as a part of its tree body, in reference axes. origin: carrier_origin.
template <class T>
Part<T> part_of(const Model& model, int body, const Vector<T>& origin, const Environment<T>& environment) {
  const Body& source = model.bodies[body];
  const auto entry = [&](int k) { return value_of(model, source.inertia[k], environment); };
  const Symmetric<T> central{entry(0), entry(1), entry(2), entry(3), entry(4), entry(5)};
  return {value_of(model, source.mass, environment), reference_position(model, body, source.com, environment) - origin,
          rotated(pose_rotation<T>(source.pose), central)};
}

template <class T>
RodConstants<T> rod_constants(const Model& model, const Topology& topology, const Constants<T>& constants,
                              const Rod& rod, const Environment<T>& environment) {
  RodConstants<T> result{place_of(model, topology, constants, rod.from, environment),
                         place_of(model, topology, constants, rod.to, environment), T(0.0), T(0.0)};
  result.length = rod.length ? value_of(model, *rod.length, environment)
                             : reference_distance(topology, constants, rod.from, result.from, rod.to, result.to);
  result.coupling = value_of(model, rod.mass, environment) / T(6.0);
  return result;
}

/// Where the origins of bodies lie: slid along their axes, or in the points of their joints, where a mechanism and its
/// mirror image have the same numbers.
enum class Origins { slid, of_joints };

/// Evaluates every constant. Ends of massive rods become point masses m/3 of their bodies (the other third is the
/// coupling).
template <class T>
Constants<T> make_constants(const Model& model, const Topology& topology, const Environment<T>& environment,
                            Origins origins = Origins::slid) {
  Constants<T> constants;
  constants.gravity = value_of(model, model.gravity, environment);
  constants.shift = shifts(model, topology, environment);
  const std::vector<SlidOrigin> slid =
      origins == Origins::slid ? slid_origins(model, topology) : std::vector<SlidOrigin>(topology.bodies.size());
  for (std::size_t i = 0; i < topology.bodies.size(); ++i) {
    const Attachment& from = model.joints[topology.bodies[i].joint].from;
    Vector<T> origin =
        reference_position(model, from.body, model.bodies[from.body].points[from.point].position, environment) +
        constants.shift[from.body];
    if (slid[i].component >= 0)
      (slid[i].component == 0 ? origin.x : slid[i].component == 1 ? origin.y : origin.z) = T(slid[i].value);
    constants.origin.push_back(origin);
  }
  std::vector<Part<T>> parts(topology.bodies.size());
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    if (const int tree = topology.tree_body[b]; tree != kGround)
      parts[tree] = joined(parts[tree], part_of(model, static_cast<int>(b),
                                                carrier_origin(topology, constants, static_cast<int>(b)), environment));
  for (const Rod& rod : model.rods) {
    constants.rods.push_back(rod_constants(model, topology, constants, rod, environment));
    const RodConstants<T>& r = constants.rods.back();
    for (const Place<T>& end : {r.from, r.to})
      if (end.body != kGround) parts[end.body] = joined(parts[end.body], Part<T>{T(2.0) * r.coupling, end.at, {}});
  }
  for (const Part<T>& noisy : parts) {
    const Part<T> part = without_noise(noisy);
    constants.mass.push_back(part.mass);
    constants.com.push_back(part.com);
    constants.inertia.push_back(part.inertia);
  }
  return constants;
}

/// Limit of the rounding in an inertia of zero, kg m^2 or kg: closed loops cancel velocities of all bodies to some
/// 1e-16 of theirs, and the inertia is their square. 1e-12 of a velocity leaves its first digits right.
template <class T>
double inertia_left_by_rounding(const Constants<T>& constants) {
  double mass = 0, reach = 0;
  for (std::size_t i = 0; i < constants.origin.size(); ++i) {
    const Vector<T> apart = constants.origin[i] - constants.origin[0];
    mass += known_size(constants.mass[i]);
    reach = std::max({reach, known_size(apart.x), known_size(apart.y), known_size(apart.z)});
  }
  const double length = reach > 0 ? std::min(reach, 1.0) : 1.0;
  return 1e-24 * mass * length * length;
}

/// Names the numbers of the bodies and rods: m_ mass, c_ centre of mass, I_ inertia about it, p_ ends of rods from the
/// origins of their bodies, l_ lengths, g_ gravity.
template <class T>
void name_constants(Annotator<T>& annotator, const Model& model, const Topology& topology, Constants<T>& constants) {
  name_constant(annotator, constants.gravity, "g");
  for (std::size_t i = 0; i < topology.bodies.size(); ++i) {
    const std::string& body = topology.bodies[i].name;
    annotator.constant(constants.mass[i], "m_", body);
    name_constant(annotator, constants.com[i], "c_", body);
    name_constant(annotator, constants.inertia[i], "I_", body);
  }
  for (std::size_t r = 0; r < model.rods.size(); ++r) {
    RodConstants<T>& rod = constants.rods[r];
    name_constant(annotator, rod.from.at, "p_", model.rods[r].name, "_from");
    name_constant(annotator, rod.to.at, "p_", model.rods[r].name, "_to");
    annotator.constant(rod.length, "l_", model.rods[r].name);
    annotator.bound(rod.coupling, "A sixth of the mass of the rod", "m6_", model.rods[r].name);
  }
}

}  // namespace mbgen
