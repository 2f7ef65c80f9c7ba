#include "bench/foreign/simbody_mechanism.hpp"

#include <Simbody.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <deque>

namespace mbgen::foreign {
namespace {

using Eigen::Vector3d;
using SimTK::MobilizedBody;
using SimTK::Rotation;
using SimTK::Transform;
using SimTK::UnitVec3;
using SimTK::Vec3;

Vec3 vec(const Vector3d& v) { return {v[0], v[1], v[2]}; }
UnitVec3 unit(const Vector3d& v) { return UnitVec3(vec(v)); }

SimTK::Body::Rigid rigid(const RigidMass& mass, const Vector3d& origin) {
  const Vec3 com = vec(mass.com - origin);
  const Eigen::Matrix3d& j = mass.inertia;
  const SimTK::Inertia central(j(0, 0), j(1, 1), j(2, 2), j(0, 1), j(0, 2), j(1, 2));
  return SimTK::Body::Rigid(SimTK::MassProperties(mass.mass, com, central.shiftFromMassCenter(-com, mass.mass)));
}

/// The kinds of mobilizer in use, with the freedoms they apply in turn: R about and P along axes of their frame.
enum class Kind { pin, slider, cylinder, universal, planar, translation, gimbal, bushing };

/// Where Simbody keeps a coordinate of the mechanism.
struct Coordinate {
  int body = -1;    ///< mobilizer, in the order they were made
  int place = 0;    ///< of its q and u
  double sign = 1;  ///< q = sign z
};

/// A run of freedoms as one mobilizer: the columns of `frame` are its x, y, z, the freedoms its places.
struct Mobilizer {
  Kind kind = Kind::pin;
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  std::vector<Coordinate> coordinates;  ///< one per freedom of the run, body not yet known
};

using Run = std::vector<const ReferenceBody*>;

bool perpendicular(const Vector3d& a, const Vector3d& b) { return std::abs(a.dot(b)) < 1e-12; }

/// "PPPRRR" of three translations and then three rotations.
std::string letters(const Run& run) {
  std::string text;
  for (const ReferenceBody* body : run) text += body->kind == FreedomKind::revolute ? 'R' : 'P';
  return text;
}

/// A right-handed frame with these first two columns, and the sign of `third` along its z.
Eigen::Matrix3d frame_of(const Vector3d& x, const Vector3d& y) {
  Eigen::Matrix3d frame;
  frame << x, y, x.cross(y);
  return frame;
}

Mobilizer along_z(Kind kind, const Vector3d& axis, std::vector<Coordinate> coordinates) {
  const Perpendiculars p = perpendiculars(axis);
  Mobilizer mobilizer{kind, {}, std::move(coordinates)};
  mobilizer.frame << p.first, p.second, axis;
  return mobilizer;
}

/// Places of three translations along axes of a frame, in whatever order.
bool add_translations(const Run& run, const Eigen::Matrix3d& frame, int first_place, Mobilizer& mobilizer) {
  for (const ReferenceBody* body : run) {
    const Vector3d local = frame.transpose() * body->axis;
    int place = 0;
    if (std::abs(local.cwiseAbs().maxCoeff(&place) - 1) > 1e-12) return false;
    mobilizer.coordinates.push_back({-1, first_place + place, local[place]});
  }
  return true;
}

bool add_rotations(const Run& run, Mobilizer& mobilizer) {
  const Vector3d &a = run[0]->axis, &b = run[1]->axis, &c = run[2]->axis;
  if (!perpendicular(a, b) || !perpendicular(b, c) || !perpendicular(a, c)) return false;
  mobilizer.frame = frame_of(a, b);
  const double hand = a.cross(b).dot(c) > 0 ? 1 : -1;
  for (int k = 0; k < 3; ++k) mobilizer.coordinates.push_back({-1, k, k == 2 ? hand : 1.0});
  return true;
}

/// The mobilizer for a whole run. Result: whether Simbody has it.
bool one_mobilizer(const Run& run, Mobilizer& mobilizer) {
  const std::string kinds = letters(run);
  const auto axis = [&](std::size_t k) { return run[k]->axis; };
  mobilizer = {};
  if (kinds == "R" || kinds == "P") {
    mobilizer = kinds == "R" ? along_z(Kind::pin, axis(0), {{}}) : along_z(Kind::slider, axis(0), {{}});
    if (kinds == "P") mobilizer.frame = frame_of(axis(0), perpendiculars(axis(0)).first);
    return true;
  }
  if ((kinds == "PR" || kinds == "RP") && (axis(0) - axis(1)).norm() < 1e-12) {
    const int turn = kinds == "RP" ? 0 : 1;
    mobilizer = along_z(Kind::cylinder, axis(0), {{-1, turn, 1.0}, {-1, 1 - turn, 1.0}});
    return true;
  }
  if (kinds == "RR" && perpendicular(axis(0), axis(1))) {
    mobilizer = {Kind::universal, frame_of(axis(0), axis(1)), {{-1, 0, 1.0}, {-1, 1, 1.0}}};
    return true;
  }
  if (kinds == "PPR" && perpendicular(axis(0), axis(1)) && (axis(0).cross(axis(1)) - axis(2)).norm() < 1e-12) {
    mobilizer = {Kind::planar, frame_of(axis(0), axis(1)), {{-1, 1, 1.0}, {-1, 2, 1.0}, {-1, 0, 1.0}}};
    return true;
  }
  if (kinds == "PPP") {
    mobilizer.kind = Kind::translation;
    return add_translations(run, mobilizer.frame, 0, mobilizer);
  }
  if (kinds == "RRR") {
    mobilizer.kind = Kind::gimbal;
    return add_rotations(run, mobilizer);
  }
  if (kinds != "PPPRRR") return false;
  mobilizer.kind = Kind::bushing;
  Mobilizer turns;
  if (!add_rotations({run.begin() + 3, run.end()}, turns)) return false;
  mobilizer.frame = turns.frame;
  if (!add_translations({run.begin(), run.begin() + 3}, mobilizer.frame, 3, mobilizer)) return false;
  mobilizer.coordinates.insert(mobilizer.coordinates.end(), turns.coordinates.begin(), turns.coordinates.end());
  return true;
}

MobilizedBody made(Kind kind, MobilizedBody& parent, const Transform& on_parent, const SimTK::Body& body,
                   const Transform& on_child) {
  switch (kind) {
    case Kind::pin:
      return MobilizedBody::Pin(parent, on_parent, body, on_child);
    case Kind::slider:
      return MobilizedBody::Slider(parent, on_parent, body, on_child);
    case Kind::cylinder:
      return MobilizedBody::Cylinder(parent, on_parent, body, on_child);
    case Kind::universal:
      return MobilizedBody::Universal(parent, on_parent, body, on_child);
    case Kind::planar:
      return MobilizedBody::Planar(parent, on_parent, body, on_child);
    case Kind::translation:
      return MobilizedBody::Translation(parent, on_parent, body, on_child);
    case Kind::gimbal:
      return MobilizedBody::Gimbal(parent, on_parent, body, on_child);
    case Kind::bushing:
      break;
  }
  return MobilizedBody::Bushing(parent, on_parent, body, on_child);
}

/// A rod with mass, and where its universal joint stands on the `from` body.
struct SimbodyRod {
  const ReferenceClosure* closure;
  Transform frame;  ///< of the joint on the `from` body: z along the rod at the reference
  Vec3 far_end;     ///< on the `to` body
  int body;         ///< mobilizer
};

/// A state in Simbody's own coordinates.
struct NativeState {
  SimTK::Vector q, u, force;
};

}  // namespace

struct SimbodyMechanism::Content {
  ReferenceMechanism mechanism;
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  SimTK::Force::DiscreteForces tau{forces, matter};
  std::deque<MobilizedBody> mobilizers;  ///< ground is not one of them
  std::vector<int> mobilizer_of;         ///< per tree body
  std::vector<Vector3d> origin;          ///< of the Simbody body that a tree body is, global at the reference
  std::vector<Coordinate> coordinates;   ///< per tree body
  std::vector<SimbodyRod> rods;          ///< with mass
  SimTK::State state;
  std::vector<NativeState> loaded;

  MobilizedBody& body(int tree) {
    return tree == kGround ? static_cast<MobilizedBody&>(matter.updGround()) : mobilizers[mobilizer_of[tree]];
  }
  Vec3 local(int tree, const Vector3d& place) const {
    return vec(tree == kGround ? place : Vector3d(place - origin[tree]));
  }
  void add(Mobilizer mobilizer, const Run& run, int first);
  void add_tree();
  void add_closure(const ReferenceClosure& closure);
  void add_rod(const ReferenceClosure& closure);
  void lay_rod(const SimbodyRod& rod);
  NativeState native(const ForeignState& at);
  void evaluate(const NativeState& at);
};

/// Tree bodies first.. of the run end in one Simbody body, parallel to the global axes at the reference.
void SimbodyMechanism::Content::add(Mobilizer mobilizer, const Run& run, int first) {
  const ReferenceBody& last = *run.back();
  const Rotation axes(SimTK::Mat33(mobilizer.frame(0, 0), mobilizer.frame(0, 1), mobilizer.frame(0, 2),
                                   mobilizer.frame(1, 0), mobilizer.frame(1, 1), mobilizer.frame(1, 2),
                                   mobilizer.frame(2, 0), mobilizer.frame(2, 1), mobilizer.frame(2, 2)));
  const int parent = run.front()->parent;
  const Transform on_parent(axes, local(parent, last.pin)), on_child(axes, vec(last.pin - last.mass.com));
  mobilizers.push_back(made(mobilizer.kind, body(parent), on_parent, rigid(last.mass, last.mass.com), on_child));
  for (std::size_t k = 0; k < run.size(); ++k) {
    mobilizer_of[first + static_cast<int>(k)] = static_cast<int>(mobilizers.size()) - 1;
    origin[first + static_cast<int>(k)] = last.mass.com;
    mobilizer.coordinates[k].body = static_cast<int>(mobilizers.size()) - 1;
    coordinates.push_back(mobilizer.coordinates[k]);
  }
}

void SimbodyMechanism::Content::add_tree() {
  const int n = static_cast<int>(mechanism.bodies.size());
  mobilizer_of.resize(n);
  origin.resize(n);
  for (int first = 0; first < n;) {
    Run run;
    int next = first;
    do run.push_back(&mechanism.bodies[next++]);
    while (next < n && mechanism.bodies[next].joint == mechanism.bodies[first].joint);
    Mobilizer mobilizer;
    while (!one_mobilizer(run, mobilizer)) run.resize(1);  // a chain then; one freedom there always is
    add(mobilizer, run, first);
    first += static_cast<int>(run.size());
  }
}

void SimbodyMechanism::Content::add_rod(const ReferenceClosure& closure) {
  const Vector3d along = (closure.at_to - closure.at_from).normalized();
  const double transverse = closure.mass * closure.length * closure.length / 12;
  const SimTK::MassProperties thin(
      closure.mass, Vec3(0, 0, closure.length / 2),
      SimTK::Inertia(transverse, transverse, 0).shiftFromMassCenter(Vec3(0, 0, -closure.length / 2), closure.mass));
  const Transform frame(Rotation(unit(along), SimTK::ZAxis), local(closure.from, closure.at_from));
  mobilizers.push_back(MobilizedBody::Universal(body(closure.from), frame, SimTK::Body::Rigid(thin), Transform()));
  const Vec3 far_end = local(closure.to, closure.at_to);
  SimTK::Constraint::Ball(mobilizers.back(), Vec3(0, 0, closure.length), body(closure.to), far_end);
  rods.push_back({&closure, frame, far_end, static_cast<int>(mobilizers.size()) - 1});
}

void SimbodyMechanism::Content::add_closure(const ReferenceClosure& c) {
  using SimTK::Constraint;
  MobilizedBody &from = body(c.from), &to = body(c.to);
  const Vec3 at_from = local(c.from, c.at_from), at_to = local(c.to, c.at_to);
  const Perpendiculars p = perpendiculars(c.axis);
  const auto keep_axis = [&] {
    Constraint::ConstantAngle(from, unit(p.first), to, unit(c.axis));
    Constraint::ConstantAngle(from, unit(p.second), to, unit(c.axis));
  };
  switch (c.kind) {
    case ClosureKind::spherical:
      Constraint::Ball(from, at_from, to, at_to);
      return;
    case ClosureKind::revolute:
      Constraint::Ball(from, at_from, to, at_to);
      return keep_axis();
    case ClosureKind::universal:
      Constraint::Ball(from, at_from, to, at_to);
      Constraint::ConstantAngle(from, unit(c.axis), to, unit(c.second_axis));
      return;
    case ClosureKind::fixed:
      Constraint::Weld(from, Transform(at_from), to, Transform(at_to));
      return;
    case ClosureKind::prismatic:
      Constraint::PointOnLine(from, unit(c.axis), at_from, to, at_to);
      Constraint::ConstantOrientation(from, Rotation(), to, Rotation());
      return;
    case ClosureKind::cylindrical:
      Constraint::PointOnLine(from, unit(c.axis), at_from, to, at_to);
      return keep_axis();
    case ClosureKind::planar:
      Constraint::PointInPlane(from, unit(c.axis), SimTK::dot(vec(c.axis), at_from), to, at_to);
      return keep_axis();
    case ClosureKind::rod:
      if (c.mass > 0) return add_rod(c);
      Constraint::Rod(from, at_from, to, at_to, c.length);
  }
}

/// Sets the angles of a rod's universal joint (turns a about x, then b about y) so that it points to its far end, and
/// their rates likewise. Requires: the state of the tree is set and realised to velocity.
void SimbodyMechanism::Content::lay_rod(const SimbodyRod& rod) {
  MobilizedBody &from = body(rod.closure->from), &to = body(rod.closure->to);
  const Vec3 gap = to.findStationLocationInAnotherBody(state, rod.far_end, from) - rod.frame.p();
  const Vec3 d = ~rod.frame.R() * gap;
  const Vec3 rate = ~rod.frame.R() * to.findStationVelocityInAnotherBody(state, rod.far_end, from);
  const double across = d[1] * d[1] + d[2] * d[2], length = d.norm();
  const MobilizedBody& bar = mobilizers[rod.body];
  bar.setOneQ(state, 0, std::atan2(-d[1], d[2]));
  bar.setOneQ(state, 1, std::asin(d[0] / length));
  bar.setOneU(state, 0, (d[1] * rate[2] - d[2] * rate[1]) / across);
  const double length_rate = SimTK::dot(d, rate) / length;
  bar.setOneU(state, 1, (rate[0] - d[0] / length * length_rate) / std::sqrt(across));
}

NativeState SimbodyMechanism::Content::native(const ForeignState& at) {
  SimTK::Vector force(state.getNU(), 0.0);
  state.updQ() = 0;
  state.updU() = 0;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const Coordinate& c = coordinates[i];
    const MobilizedBody& mobilizer = mobilizers[c.body];
    mobilizer.setOneQ(state, c.place, c.sign * at.z[i]);
    mobilizer.setOneU(state, c.place, c.sign * at.zd[i]);
    force[mobilizer.getFirstUIndex(state) + c.place] = c.sign * at.tau[i];
  }
  system.realize(state, SimTK::Stage::Velocity);
  std::vector<double> angles;
  for (const SimbodyRod& rod : rods) {
    lay_rod(rod);
    system.realize(state, SimTK::Stage::Velocity);
  }
  return {state.getQ(), state.getU(), force};
}

void SimbodyMechanism::Content::evaluate(const NativeState& at) {
  state.updQ() = at.q;
  state.updU() = at.u;
  tau.setAllMobilityForces(state, at.force);
  system.realize(state, SimTK::Stage::Acceleration);
}

bool SimbodyMechanism::is_available() { return true; }

std::string SimbodyMechanism::version() {
  int major = 0, minor = 0, patch = 0;
  SimTK_version_simbody(&major, &minor, &patch);
  std::string text = std::to_string(major);
  text += '.';
  text += std::to_string(minor);
  return text;
}

SimbodyMechanism::SimbodyMechanism(const ReferenceMechanism& mechanism) : content_(std::make_unique<Content>()) {
  Content& c = *content_;
  c.mechanism = mechanism;
  c.matter.setShowDefaultGeometry(false);
  SimTK::Force::UniformGravity(c.forces, c.matter, vec(mechanism.gravity));
  c.add_tree();
  for (const ReferenceClosure& closure : c.mechanism.closures) c.add_closure(closure);
  c.state = c.system.realizeTopology();
  c.system.realizeModel(c.state);
}

SimbodyMechanism::~SimbodyMechanism() = default;
SimbodyMechanism::SimbodyMechanism(SimbodyMechanism&&) noexcept = default;

std::vector<double> SimbodyMechanism::accelerations(const ForeignState& state) {
  Content& c = *content_;
  c.evaluate(c.native(state));
  std::vector<double> zdd;
  for (const Coordinate& place : c.coordinates) {
    zdd.push_back(place.sign * c.mobilizers[place.body].getOneUDot(c.state, place.place));
  }
  return zdd;
}

void SimbodyMechanism::load(const std::vector<ForeignState>& states) {
  content_->loaded.clear();
  for (const ForeignState& state : states) content_->loaded.push_back(content_->native(state));
}

void SimbodyMechanism::run(int repetitions) {
  for (int r = 0; r < repetitions; ++r)
    for (const NativeState& at : content_->loaded) content_->evaluate(at);
}

}  // namespace mbgen::foreign
