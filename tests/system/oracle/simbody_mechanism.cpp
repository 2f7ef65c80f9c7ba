#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "tests/system/oracle/simbody_system.hpp"

namespace mbgen::foreign {
namespace {

using Eigen::Vector3d;
using SimTK::MobilizedBody;
using SimTK::Rotation;
using SimTK::Transform;
using SimTK::UnitVec3;
using SimTK::Vec3;

UnitVec3 unit(const Vector3d& v) { return UnitVec3(vec(v)); }

SimTK::Body::Rigid rigid(const RigidMass& mass, const Vector3d& origin) {
  const Vec3 com = vec(mass.com - origin);
  const Eigen::Matrix3d& j = mass.inertia;
  const SimTK::Inertia central(j(0, 0), j(1, 1), j(2, 2), j(0, 1), j(0, 2), j(1, 2));
  return SimTK::Body::Rigid(SimTK::MassProperties(mass.mass, com, central.shiftFromMassCenter(-com, mass.mass)));
}

/// The kinds of mobilizer in use, with the freedoms they apply in turn: R about and P along axes of their frame.
enum class Kind { pin, slider, cylinder, universal, planar, translation, gimbal, bushing };

/// A run of freedoms as one mobilizer: the columns of `frame` are its x, y, z, the freedoms its places.
struct Mobilizer {
  Kind kind = Kind::pin;
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  std::vector<SimbodyCoordinate> coordinates;  ///< one per freedom of the run, body not yet known
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

Mobilizer along_z(Kind kind, const Vector3d& axis, std::vector<SimbodyCoordinate> coordinates) {
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

/// Tree bodies first.. of the run end in one Simbody body, parallel to the global axes at the reference.
void add_run(SimbodySystem& s, Mobilizer mobilizer, const Run& run, int first) {
  const ReferenceBody& last = *run.back();
  const Rotation axes(SimTK::Mat33(mobilizer.frame(0, 0), mobilizer.frame(0, 1), mobilizer.frame(0, 2),
                                   mobilizer.frame(1, 0), mobilizer.frame(1, 1), mobilizer.frame(1, 2),
                                   mobilizer.frame(2, 0), mobilizer.frame(2, 1), mobilizer.frame(2, 2)));
  const int parent = run.front()->parent;
  const Transform on_parent(axes, s.local(parent, last.pin)), on_child(axes, vec(last.pin - last.mass.com));
  s.mobilizers.push_back(made(mobilizer.kind, s.body(parent), on_parent, rigid(last.mass, last.mass.com), on_child));
  for (std::size_t k = 0; k < run.size(); ++k) {
    s.mobilizer_of[first + static_cast<int>(k)] = static_cast<int>(s.mobilizers.size()) - 1;
    s.origin[first + static_cast<int>(k)] = last.mass.com;
    mobilizer.coordinates[k].body = static_cast<int>(s.mobilizers.size()) - 1;
    s.coordinates.push_back(mobilizer.coordinates[k]);
  }
}

void add_tree(SimbodySystem& s) {
  const std::vector<ReferenceBody>& bodies = s.mechanism.bodies;
  const int n = static_cast<int>(bodies.size());
  s.mobilizer_of.resize(n);
  s.origin.resize(n);
  for (int first = 0; first < n;) {
    Run run;
    int next = first;
    do run.push_back(&bodies[next++]);
    while (next < n && bodies[next].joint == bodies[first].joint);
    Mobilizer mobilizer;
    while (!one_mobilizer(run, mobilizer)) run.resize(1);  // a chain then; one freedom there always is
    add_run(s, mobilizer, run, first);
    first += static_cast<int>(run.size());
  }
}

SimTK::Constraint rod_with_mass(SimbodySystem& s, const ReferenceClosure& closure) {
  const Vector3d along = (closure.at_to - closure.at_from).normalized();
  const double transverse = closure.mass * closure.length * closure.length / 12;
  const SimTK::MassProperties thin(
      closure.mass, Vec3(0, 0, closure.length / 2),
      SimTK::Inertia(transverse, transverse, 0).shiftFromMassCenter(Vec3(0, 0, -closure.length / 2), closure.mass));
  const Transform frame(Rotation(unit(along), SimTK::ZAxis), s.local(closure.from, closure.at_from));
  s.mobilizers.push_back(MobilizedBody::Universal(s.body(closure.from), frame, SimTK::Body::Rigid(thin), Transform()));
  const Vec3 far_end = s.local(closure.to, closure.at_to);
  s.rods.push_back({&closure, frame, far_end, static_cast<int>(s.mobilizers.size()) - 1});
  return SimTK::Constraint::Ball(s.mobilizers.back(), Vec3(0, 0, closure.length), s.body(closure.to), far_end);
}

/// A relation in Simbody's coordinates.
class RelationFunction : public SimTK::Function {
 public:
  RelationFunction(const ReferenceRelation& relation, std::vector<double> signs)
      : relation_(relation), signs_(std::move(signs)) {}
  double calcValue(const SimTK::Vector& q) const override { return relation_.derivative(positions(q), {}); }
  double calcDerivative(const SimTK::Array_<int>& by, const SimTK::Vector& q) const override {
    double value = relation_.derivative(positions(q), {by.begin(), by.end()});
    for (const int i : by) value *= signs_[static_cast<std::size_t>(i)];
    return value;
  }
  int getArgumentSize() const override { return static_cast<int>(signs_.size()); }
  int getMaxDerivativeOrder() const override { return 2; }

 private:
  std::vector<double> positions(const SimTK::Vector& q) const {
    std::vector<double> z;
    for (std::size_t i = 0; i < signs_.size(); ++i) z.push_back(signs_[i] * q[static_cast<int>(i)]);
    return z;
  }
  const ReferenceRelation& relation_;
  std::vector<double> signs_;
};

SimTK::Constraint coupler(SimbodySystem& s, const ReferenceRelation& relation) {
  SimTK::Array_<SimTK::MobilizedBodyIndex> bodies;
  SimTK::Array_<SimTK::MobilizerQIndex> places;
  std::vector<double> signs;
  for (const int tree : relation.coordinates) {
    const SimbodyCoordinate& coordinate = s.coordinates[static_cast<std::size_t>(tree)];
    bodies.push_back(s.mobilizers[static_cast<std::size_t>(coordinate.body)].getMobilizedBodyIndex());
    places.push_back(SimTK::MobilizerQIndex(coordinate.place));
    signs.push_back(coordinate.sign);
  }
  return SimTK::Constraint::CoordinateCoupler(s.matter, new RelationFunction(relation, signs), bodies, places);
}

/// No slip of a disc or blade along some directions. In planar motion the place and the directions of the contact stay
/// on its carriage; planar joints hold the height. NoSlip1D takes the acceleration of the material that is at the
/// contact, which for a wheel that turns with its carriage is right forward but not to the side, where the carriage
/// moves as the wheel does.
std::vector<SimTK::Constraint> no_slip(SimbodySystem& s, const ReferenceClosure& c) {
  const Vector3d forward = c.second_axis.cross(c.axis), left = c.axis.cross(forward);
  const Vec3 contact = s.local(c.carriage, c.at_to - c.radius * c.axis);
  const auto along = [&](const Vector3d& direction, int body) {
    return SimTK::Constraint::NoSlip1D(s.body(c.carriage), contact, unit(direction), s.body(c.from), s.body(body));
  };
  if (c.kind == ClosureKind::knife_edge) return {along(-forward, c.to)};
  return {along(forward, c.to), along(left, c.carriage)};
}

std::vector<SimTK::Constraint> constraints_of(SimbodySystem& s, const ReferenceClosure& c) {
  using SimTK::Constraint;
  if (c.kind == ClosureKind::coupling) return {coupler(s, c.relation)};
  MobilizedBody &from = s.body(c.from), &to = s.body(c.to);
  const Vec3 at_from = s.local(c.from, c.at_from), at_to = s.local(c.to, c.at_to);
  const Perpendiculars p = perpendiculars(c.axis);
  const auto across = [&](const Vector3d& direction) {
    return Constraint::ConstantAngle(from, unit(direction), to, unit(c.axis));
  };
  const auto with_axis = [&](const Constraint& place) {
    return std::vector<Constraint>{place, across(p.first), across(p.second)};
  };
  switch (c.kind) {
    case ClosureKind::spherical:
      return {Constraint::Ball(from, at_from, to, at_to)};
    case ClosureKind::revolute:
      return with_axis(Constraint::Ball(from, at_from, to, at_to));
    case ClosureKind::universal:
      return {Constraint::Ball(from, at_from, to, at_to),
              Constraint::ConstantAngle(from, unit(c.axis), to, unit(c.second_axis))};
    case ClosureKind::fixed:
      return {Constraint::Weld(from, Transform(at_from), to, Transform(at_to))};
    case ClosureKind::prismatic:
      return {Constraint::PointOnLine(from, unit(c.axis), at_from, to, at_to),
              Constraint::ConstantOrientation(from, Rotation(), to, Rotation())};
    case ClosureKind::cylindrical:
      return with_axis(Constraint::PointOnLine(from, unit(c.axis), at_from, to, at_to));
    case ClosureKind::planar:
      return with_axis(Constraint::PointInPlane(from, unit(c.axis), SimTK::dot(vec(c.axis), at_from), to, at_to));
    case ClosureKind::point_on_line:
      return {Constraint::PointOnLine(from, unit(c.axis), at_from, to, at_to)};
    case ClosureKind::point_on_plane:
      return {Constraint::PointInPlane(from, unit(c.axis), SimTK::dot(vec(c.axis), at_from), to, at_to)};
    case ClosureKind::parallel_axes:
      return {across(p.first), across(p.second)};
    case ClosureKind::orientation:
      return {Constraint::ConstantOrientation(from, Rotation(), to, Rotation())};
    case ClosureKind::rolling_ball:
      return {Constraint::SphereOnPlaneContact(from, Transform(Rotation(unit(c.axis), SimTK::ZAxis), at_from), to,
                                               at_to, c.radius, true)};
    case ClosureKind::rolling_disc:
    case ClosureKind::knife_edge:
      return no_slip(s, c);
    case ClosureKind::homokinetic:
      throw std::invalid_argument("Simbody has no homokinetic joint: " + c.name);
    case ClosureKind::coupling:
    case ClosureKind::rod:
      break;
  }
  if (c.mass > 0) return {rod_with_mass(s, c)};
  return {Constraint::Rod(from, at_from, to, at_to, c.length)};
}

}  // namespace

bool SimbodyMechanism::is_available() { return true; }

std::string SimbodyMechanism::version() {
  int major = 0, minor = 0, patch = 0;
  SimTK_version_simbody(&major, &minor, &patch);
  std::string text = std::to_string(major);
  text += '.';
  text += std::to_string(minor);
  return text;
}

SimbodyMechanism::SimbodyMechanism(const ReferenceMechanism& mechanism, const ForceElements& elements)
    : system_(std::make_unique<SimbodySystem>()) {
  SimbodySystem& s = *system_;
  s.mechanism = mechanism;
  s.elements = elements;
  s.matter.setShowDefaultGeometry(false);
  SimTK::Force::UniformGravity(s.forces, s.matter, vec(mechanism.gravity));
  add_tree(s);
  for (const ReferenceClosure& closure : s.mechanism.closures) s.constraints.push_back(constraints_of(s, closure));
  add_elements(s);
  s.state = s.system.realizeTopology();
  s.system.realizeModel(s.state);
}

SimbodyMechanism::~SimbodyMechanism() = default;
SimbodyMechanism::SimbodyMechanism(SimbodyMechanism&&) noexcept = default;

}  // namespace mbgen::foreign
