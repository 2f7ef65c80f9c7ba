#include "tests/system/oracle/mujoco_mechanism.hpp"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

#include "compiler/algebra/turns.hpp"

namespace mbgen::foreign {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kThinInertia = 1e-9;  // kg m^2 of a rod about itself: MuJoCo takes no zero, and nothing turns it

std::string text(const Vector3d& v) { return fmt::format("{:.17g} {:.17g} {:.17g}", v[0], v[1], v[2]); }
std::string text(const Quaterniond& q) {
  return fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}", q.w(), q.x(), q.y(), q.z());
}

/// A model element <body> in the making: attributes and joints, then what hangs on it.
struct Node {
  std::string head, sites, inside;
  Vector3d origin = Vector3d::Zero();  ///< global at the reference
  std::vector<int> children;
};

/// A rod with mass: its node and where its angles are.
struct ThinRod {
  const ReferenceClosure* closure;
  std::string name;
  Quaterniond frame;  ///< of its body: z along the rod at the reference
};

struct Writer {
  const ReferenceMechanism& mechanism;
  std::vector<Node> nodes;   ///< nodes[0] is the world
  std::vector<int> node_of;  ///< per tree body
  std::string equalities, tendons;
  std::vector<ThinRod> rods;

  int node(int tree) const { return tree == kGround ? 0 : node_of[tree]; }
  Vector3d local(int tree, const Vector3d& place) const { return place - nodes[node(tree)].origin; }
  std::string name(int tree) const { return tree == kGround ? "world" : fmt::format("b{}", node_of[tree]); }
};

/// In principal axes found here: those that MuJoCo finds for itself are good to 1e-8.
std::string inertial(const RigidMass& mass, const Vector3d& origin) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(mass.inertia);
  Eigen::Matrix3d axes = principal.eigenvectors();
  if (axes.determinant() < 0) axes.col(2) = -axes.col(2);
  return fmt::format("<inertial pos=\"{}\" quat=\"{}\" mass=\"{:.17g}\" diaginertia=\"{}\"/>", text(mass.com - origin),
                     text(Quaterniond(axes)), mass.mass, text(principal.eigenvalues()));
}

/// Freedoms up to the next body with mass go onto that body.
void add_bodies(Writer& w) {
  const std::vector<ReferenceBody>& bodies = w.mechanism.bodies;
  w.nodes.push_back({});
  w.node_of.resize(bodies.size());
  for (std::size_t first = 0; first < bodies.size();) {
    std::size_t last = first;
    while (bodies[last].mass.mass == 0 && last + 1 < bodies.size() &&
           bodies[last + 1].parent == static_cast<int>(last) && bodies[last].model_body < 0)
      ++last;
    const ReferenceBody& body = bodies[last];
    if (body.mass.mass == 0) throw std::invalid_argument("massless body " + body.name);
    Node node;
    node.origin = body.mass.com;
    const int parent = w.node(bodies[first].parent), self = static_cast<int>(w.nodes.size());
    node.head = fmt::format("<body name=\"b{}\" pos=\"{}\">{}", self, text(node.origin - w.nodes[parent].origin),
                            inertial(body.mass, node.origin));
    for (; first <= last; ++first) {
      const ReferenceBody& freedom = bodies[first];
      node.head += fmt::format("<joint name=\"z{}\" type=\"{}\" axis=\"{}\" pos=\"{}\"/>", first,
                               freedom.kind == FreedomKind::revolute ? "hinge" : "slide", text(freedom.axis),
                               text(freedom.pin - node.origin));
      w.node_of[first] = self;
    }
    w.nodes[parent].children.push_back(self);
    w.nodes.push_back(node);
  }
}

void connect(Writer& w, const std::string& one, const std::string& other, const Vector3d& anchor) {
  w.equalities += fmt::format("<connect body1=\"{}\" body2=\"{}\" anchor=\"{}\"/>", one, other, text(anchor));
}

void add_rod(Writer& w, const ReferenceClosure& rod) {
  const std::string name = fmt::format("r{}", w.rods.size());
  if (rod.mass == 0) {
    const std::string tendon = fmt::format("t_{}", rod.name);
    for (const auto& [tree, place, end] : {std::tuple{rod.from, rod.at_from, "a"}, {rod.to, rod.at_to, "b"}}) {
      w.nodes[w.node(tree)].sites +=
          fmt::format("<site name=\"{}_{}\" pos=\"{}\"/>", tendon, end, text(w.local(tree, place)));
    }
    w.tendons += fmt::format("<spatial name=\"{0}\"><site site=\"{0}_a\"/><site site=\"{0}_b\"/></spatial>", tendon);
    w.equalities += fmt::format("<tendon tendon1=\"{}\" polycoef=\"{:.17g} 1 0 0 0\"/>", tendon,
                                rod.length - (rod.at_to - rod.at_from).norm());
    return;
  }
  const Quaterniond frame = shortest_turn(Vector3d::UnitZ(), rod.at_to - rod.at_from);
  const double transverse = rod.mass * rod.length * rod.length / 12;
  w.nodes[w.node(rod.from)].sites += fmt::format(
      "<body name=\"{0}\" pos=\"{1}\" quat=\"{2}\"><inertial pos=\"0 0 {3:.17g}\" mass=\"{4:.17g}\" "
      "diaginertia=\"{5:.17g} {5:.17g} {6}\"/><joint name=\"{0}_x\" type=\"hinge\" axis=\"1 0 0\"/>"
      "<joint name=\"{0}_y\" type=\"hinge\" axis=\"0 1 0\"/></body>",
      name, text(w.local(rod.from, rod.at_from)), text(frame), rod.length / 2, rod.mass, transverse, kThinInertia);
  connect(w, name, w.name(rod.to), Vector3d(0, 0, rod.length));
  w.rods.push_back({&rod, name, frame});
}

void add_closure(Writer& w, const ReferenceClosure& c) {
  if (c.kind == ClosureKind::rod) return add_rod(w, c);
  if (c.kind != ClosureKind::spherical && c.kind != ClosureKind::revolute)
    throw std::invalid_argument("cut joint " + c.name);
  // `from` may be the world, which cannot be the first body of a connect with an anchor of its own.
  const int one = c.from == kGround ? c.to : c.from, other = c.from == kGround ? c.from : c.to;
  connect(w, w.name(one), w.name(other), w.local(one, c.at_from));
  if (c.kind == ClosureKind::revolute) connect(w, w.name(one), w.name(other), w.local(one, c.at_from + 0.1 * c.axis));
}

std::string body_text(const Writer& w, int index) {
  const Node& node = w.nodes[index];
  std::string text = node.head + node.sites;
  for (const int child : node.children) text += body_text(w, child);
  return index == 0 ? text : text + "</body>";
}

std::string xml(const Writer& w) {
  return fmt::format(
      "<mujoco><compiler angle=\"radian\" balanceinertia=\"false\" inertiafromgeom=\"false\"/>"
      "<option gravity=\"{}\" solver=\"Newton\" iterations=\"100\" tolerance=\"1e-10\">"
      "<flag contact=\"disable\" limit=\"disable\"/></option>"
      "<default><equality solimp=\"0.9999 0.9999 0.001 0.5 2\"/></default>"
      "<worldbody>{}</worldbody><tendon>{}</tendon><equality>{}</equality></mujoco>",
      text(w.mechanism.gravity), body_text(w, 0), w.tendons, w.equalities);
}

mjModel* model_of(const std::string& text) {
  mjVFS vfs;
  mj_defaultVFS(&vfs);
  mj_makeEmptyFileVFS(&vfs, "mechanism.xml", static_cast<int>(text.size()));
  std::copy(text.begin(), text.end(), static_cast<char*>(vfs.filedata[0]));
  char error[1000] = "";
  mjModel* model = mj_loadXML("mechanism.xml", &vfs, error, sizeof error);
  mj_deleteVFS(&vfs);
  if (model == nullptr) throw std::runtime_error(std::string("MuJoCo: ") + error);
  return model;
}

/// A state in MuJoCo's own coordinates.
struct NativeState {
  std::vector<mjtNum> q, v, force;
};

}  // namespace

struct MujocoMechanism::Content {
  /// A rod with mass, its coordinates and its bodies.
  struct Rod {
    int from, to, coordinate;
    Vector3d at_from, at_to;  ///< on their bodies
    Quaterniond frame;
  };

  std::unique_ptr<mjModel, void (*)(mjModel*)> model{nullptr, mj_deleteModel};
  std::unique_ptr<mjData, void (*)(mjData*)> data{nullptr, mj_deleteData};
  std::vector<int> place;  ///< per tree body: of its coordinate
  std::vector<Rod> rods;
  std::vector<NativeState> loaded;

  Vector3d velocity(int body, const Vector3d& at) const;
  void lay_rod(const Rod& rod);
  NativeState native(const ForeignState& at);
  void evaluate(const NativeState& at);
};

/// Velocity of a point of a body, global. Requires: velocities are computed.
Vector3d MujocoMechanism::Content::velocity(int body, const Vector3d& at) const {
  mjtNum v[6];
  mj_objectVelocity(model.get(), data.get(), mjOBJ_BODY, body, v, 0);  // at the body's frame, global axes: w then v
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> axes(data->xmat + 9 * body);
  return Vector3d(v[3], v[4], v[5]) + Vector3d(v[0], v[1], v[2]).cross(axes * at);
}

/// As for Simbody: turns about x, then about y point the rod to its far end.
void MujocoMechanism::Content::lay_rod(const Rod& rod) {
  const auto axes = [&](int body) {
    return Eigen::Matrix3d(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data->xmat + 9 * body));
  };
  const auto point = [&](int body, const Vector3d& at) {
    return Vector3d(Eigen::Map<const Vector3d>(data->xpos + 3 * body) + axes(body) * at);
  };
  const Vector3d gap = point(rod.to, rod.at_to) - point(rod.from, rod.at_from);
  mjtNum v[6];
  mj_objectVelocity(model.get(), data.get(), mjOBJ_BODY, rod.from, v, 0);
  const Vector3d relative = velocity(rod.to, rod.at_to) - velocity(rod.from, rod.at_from);
  const Eigen::Matrix3d inverse = (axes(rod.from) * rod.frame.toRotationMatrix()).transpose();
  const Vector3d d = inverse * gap, rate = inverse * (relative - Vector3d(v[0], v[1], v[2]).cross(gap));
  const double across = d[1] * d[1] + d[2] * d[2], length = d.norm();
  data->qpos[rod.coordinate] = std::atan2(-d[1], d[2]);
  data->qpos[rod.coordinate + 1] = std::asin(d[0] / length);
  data->qvel[rod.coordinate] = (d[1] * rate[2] - d[2] * rate[1]) / across;
  data->qvel[rod.coordinate + 1] = (rate[0] - d[0] / length * (d.dot(rate) / length)) / std::sqrt(across);
}

NativeState MujocoMechanism::Content::native(const ForeignState& at) {
  mj_resetData(model.get(), data.get());
  std::vector<mjtNum> force(model->nv);
  for (std::size_t i = 0; i < place.size(); ++i) {
    data->qpos[place[i]] = at.z[i];
    data->qvel[place[i]] = at.zd[i];
    force[place[i]] = at.tau[i];
  }
  mj_fwdPosition(model.get(), data.get());
  mj_fwdVelocity(model.get(), data.get());
  for (const Rod& rod : rods) lay_rod(rod);
  return {{data->qpos, data->qpos + model->nq}, {data->qvel, data->qvel + model->nv}, force};
}

void MujocoMechanism::Content::evaluate(const NativeState& at) {
  std::copy(at.q.begin(), at.q.end(), data->qpos);
  std::copy(at.v.begin(), at.v.end(), data->qvel);
  std::copy(at.force.begin(), at.force.end(), data->qfrc_applied);
  mj_forward(model.get(), data.get());
}

bool MujocoMechanism::is_available() { return true; }
std::string MujocoMechanism::version() { return mj_versionString(); }

MujocoMechanism::MujocoMechanism(const ReferenceMechanism& mechanism) : content_(std::make_unique<Content>()) {
  Writer w{mechanism, {}, {}, {}, {}, {}};
  add_bodies(w);
  for (const ReferenceClosure& closure : mechanism.closures) add_closure(w, closure);
  Content& c = *content_;
  c.model.reset(model_of(xml(w)));
  c.data.reset(mj_makeData(c.model.get()));
  const auto coordinate = [&](const std::string& joint) {
    return c.model->jnt_dofadr[mj_name2id(c.model.get(), mjOBJ_JOINT, joint.c_str())];
  };
  const auto body = [&](int tree) { return mj_name2id(c.model.get(), mjOBJ_BODY, w.name(tree).c_str()); };
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) c.place.push_back(coordinate(fmt::format("z{}", i)));
  for (const ThinRod& rod : w.rods) {
    const ReferenceClosure& ends = *rod.closure;
    c.rods.push_back({body(ends.from), body(ends.to), coordinate(rod.name + "_x"), w.local(ends.from, ends.at_from),
                      w.local(ends.to, ends.at_to), rod.frame});
  }
}

MujocoMechanism::~MujocoMechanism() = default;
MujocoMechanism::MujocoMechanism(MujocoMechanism&&) noexcept = default;

std::vector<double> MujocoMechanism::accelerations(const ForeignState& state) {
  content_->evaluate(content_->native(state));
  std::vector<double> zdd;
  for (const int place : content_->place) zdd.push_back(content_->data->qacc[place]);
  return zdd;
}

std::vector<double> MujocoMechanism::inverse_forces(const ForeignState& state, const std::vector<double>& zdd) {
  Content& c = *content_;
  c.native(state);
  for (std::size_t i = 0; i < zdd.size(); ++i) c.data->qacc[c.place[i]] = zdd[i];
  mj_inverse(c.model.get(), c.data.get());
  std::vector<double> force;
  for (const int place : c.place) force.push_back(c.data->qfrc_inverse[place]);
  return force;
}

void MujocoMechanism::load(const std::vector<ForeignState>& states) {
  content_->loaded.clear();
  for (const ForeignState& state : states) content_->loaded.push_back(content_->native(state));
}

void MujocoMechanism::run(int repetitions) {
  for (int r = 0; r < repetitions; ++r)
    for (const NativeState& at : content_->loaded) content_->evaluate(at);
}

}  // namespace mbgen::foreign
