// MJCF: the tree of bodies and the joints between them.
#include <fmt/format.h>

#include <array>
#include <numbers>

#include "workbench/import/mjcf.hpp"

namespace mbgen::importing {
namespace {

struct MjcfJointWord {
  std::string_view word;
  JointType type;
};
constexpr std::array<MjcfJointWord, 4> kMjcfJointWords = {{{"hinge", JointType::revolute},
                                                           {"slide", JointType::prismatic},
                                                           {"ball", JointType::spherical},
                                                           {"free", JointType::free}}};

std::optional<JointType> mjcf_joint_type(Mjcf& mjcf, const Element& element, const std::string& childclass) {
  if (element.name == "freejoint") return JointType::free;
  const std::string typed = inherited_text(mjcf, element, childclass, "type", "hinge");
  for (const MjcfJointWord& word : kMjcfJointWords) {
    if (word.word == typed) return word.type;
  }
  problem(mjcf.reading, element.spot, "unknown joint type " + quoted_text(typed), "known: hinge, slide, ball, free");
  return std::nullopt;
}

/// An element of a body with its pose.
struct Placed {
  const Element* element;
  Isometry3d frame;
  std::string childclass;
};

bool has_one_coordinate(JointType type) { return type == JointType::revolute || type == JointType::prismatic; }

BodyDraft& draft(Mjcf& mjcf, int body) { return mjcf.assembly.bodies[static_cast<std::size_t>(body)]; }

/// Attributes of a joint that are not carried over.
void note_lost(Mjcf& mjcf, const Placed& joint, JointType type) {
  const Element& element = *joint.element;
  if (inherited(mjcf, element, joint.childclass, "range")) {
    const bool stops = mjcf.reading.request.stop_stiffness > 0 && has_one_coordinate(type);
    if (!stops)
      lose(mjcf, element.spot, "joint with a range: limits are not enforced, they stand beside the joints as comments");
  }
  if (type == JointType::revolute || type == JointType::prismatic) return;
  for (const char* name : {"stiffness", "damping", "frictionloss", "armature"}) {
    if (element.name == "freejoint" || inherited_number(mjcf, element, joint.childclass, name, 0) == 0) continue;
    lose(mjcf, element.spot,
         fmt::format("{} joint with {}: not carried over, the coordinates of the model are others",
                     type == JointType::free ? "free" : "ball", name));
  }
  if (element.name != "freejoint" && inherited(mjcf, element, joint.childclass, "springdamper"))
    lose(mjcf, element.spot,
         fmt::format("{} joint with springdamper: not carried over, the coordinates of the model are others",
                     type == JointType::free ? "free" : "ball"));
}

/// Ends of the range in MuJoCo's coordinate, rad or m, if it is enforced.
std::optional<std::pair<double, double>> limits_of(Mjcf& mjcf, const Placed& joint, JointType type) {
  const std::string limited = inherited_text(mjcf, *joint.element, joint.childclass, "limited", "auto");
  const Attribute* range = inherited(mjcf, *joint.element, joint.childclass, "range");
  if (!range || limited == "false" || (limited == "auto" && !mjcf.settings.limits_by_range)) return std::nullopt;
  const std::optional<std::vector<double>> values = limits(mjcf.reading, *range, 2, 2);
  // As in MuJoCo: two zeros stand for no range unless the joint is `limited`.
  const bool is_none = values && (*values)[0] == 0 && (*values)[1] == 0 && limited == "auto";
  if (!values || is_none) return std::nullopt;
  const double unit = type == JointType::revolute && mjcf.settings.is_in_degrees ? std::numbers::pi / 180 : 1.0;
  return std::pair((*values)[0] * unit, (*values)[1] * unit);
}

std::string range_text(Mjcf& mjcf, const Placed& joint, JointType type) {
  const Attribute* range = inherited(mjcf, *joint.element, joint.childclass, "range");
  if (!range) return {};
  const std::optional<std::vector<double>> values = limits(mjcf.reading, *range, 2, 2);
  if (!values) return {};
  const char* unit = type == JointType::prismatic ? "m" : mjcf.settings.is_in_degrees ? "deg" : "rad";
  return fmt::format("range {} .. {} {}", (*values)[0], (*values)[1], unit);
}

/// Spring, damper and friction of a hinge or slide; in MuJoCo its coordinate equals `ref` at the reference.
void add_passive_forces(Mjcf& mjcf, const Placed& joint, const MjcfJoint& made) {
  const auto value = [&](const char* name) {
    return inherited_number(mjcf, *joint.element, joint.childclass, name, 0);
  };
  const double stiffness = mjcf.settings.has_springs ? value("stiffness") : 0;
  const double damping = mjcf.settings.has_dampers ? value("damping") : 0;
  const double friction = mjcf.settings.has_friction ? value("frictionloss") : 0;
  if (stiffness < 0 || damping < 0 || friction < 0) {
    problem(mjcf.reading, joint.element->spot, "stiffness, damping and frictionloss are not negative");
    return;
  }
  const Attribute* given = inherited(mjcf, *joint.element, joint.childclass, "springdamper");
  const std::vector<double> by_time =
      given ? numbers(mjcf.reading, *given, 2, 2).value_or(std::vector<double>{0, 0}) : std::vector<double>{0, 0};
  // As in MuJoCo: if both are positive, they override stiffness and damping.
  const bool is_by_time = by_time[0] > 0 && by_time[1] > 0;
  if (is_by_time) mjcf.spring_dampers.push_back({made.coordinate, by_time[0], by_time[1], made.free});
  add_joint_forces(mjcf.assembly, made.coordinate, is_by_time ? 0 : stiffness, is_by_time ? 0 : damping, made.free,
                   friction);
  if (friction > 0) {
    lose(mjcf, joint.element->spot,
         fmt::format("joint with frictionloss: smoothed below {} rad/s or m/s", kFrictionVelocity));
  }
}

void add_joint(Mjcf& mjcf, const Placed& joint, JointType type, int from, int to) {
  const Element& element = *joint.element;
  const Isometry3d pose = draft(mjcf, to).pose;
  const Attribute* named = attribute(element, "name");
  const std::string name = named && !named->value.empty() ? named->value : draft(mjcf, to).name + "_joint";
  JointDraft made{.name = unique_joint_name(mjcf.assembly, name), .type = type, .from = from, .to = to};
  made.at = pose.translation();
  const bool has_axis = type == JointType::revolute || type == JointType::prismatic;
  if (type != JointType::free) {
    const Vector3d pos = inherited_vector(mjcf, element, joint.childclass, "pos", Vector3d::Zero());
    made.at = pose * (joint.frame * pos);
    made.comment = range_text(mjcf, joint, type);
  }
  MjcfJoint result{made.name, type};
  if (has_axis) {
    const Vector3d axis = inherited_vector(mjcf, element, joint.childclass, "axis", Vector3d::UnitZ());
    if (axis.norm() == 0)
      problem(mjcf.reading, element.spot, "axis has zero length", "give its direction, for example axis=\"0 0 1\"");
    made.axis = pose.linear() * joint.frame.linear() * axis.normalized();
    const bool is_angle = type == JointType::revolute && mjcf.settings.is_in_degrees;
    result.reference =
        inherited_number(mjcf, element, joint.childclass, "ref", 0) * (is_angle ? std::numbers::pi / 180 : 1.0);
    result.armature = inherited_number(mjcf, element, joint.childclass, "armature", 0);
    if (result.armature < 0) problem(mjcf.reading, element.spot, "armature is not negative");
    result.free =
        inherited_number(mjcf, element, joint.childclass, "springref", 0) * (is_angle ? std::numbers::pi / 180 : 1.0) -
        result.reference;
    add_passive_forces(mjcf, joint, result);
    const auto ends = limits_of(mjcf, joint, type);
    if (ends)
      note_narrow(mjcf.reading, element.spot, name, ends->first, ends->second,
                  type == JointType::revolute ? "rad" : "m",
                  "MuJoCo refuses such a range; a body without this joint, placed at the position, is held");
    if (ends && ends->first < ends->second) {
      result.lower = ends->first - result.reference;
      result.upper = ends->second - result.reference;
      add_stops(mjcf.reading.request, mjcf.assembly, made.name, result.lower, result.upper);
    }
    mjcf.scalar_joints.push_back(result);
  }
  note_lost(mjcf, joint, type);
  if (named && !mjcf.joint_of.emplace(named->value, result).second) {
    problem(mjcf.reading, element.spot, fmt::format("joint {} is defined twice", quoted_text(named->value)));
  }
  mjcf.assembly.joints.push_back(std::move(made));
}

void read_site(Mjcf& mjcf, const Element& site, const std::string& childclass, const Isometry3d& frame, int body) {
  require_class(mjcf, site, "class");
  const std::string name = text_of(site, "name");
  if (name.empty()) return;
  BodyDraft& owner = draft(mjcf, body);
  Isometry3d place = read_pose(mjcf, site, childclass);
  if (const Attribute* fromto = inherited(mjcf, site, childclass, "fromto")) {
    const std::vector<double> v = numbers(mjcf.reading, *fromto, 6, 6).value_or(std::vector<double>(6, 0.0));
    place.translation() = Vector3d(v[0] + v[3], v[1] + v[4], v[2] + v[5]) / 2;
  }
  place = frame * place;
  add_point(owner, name, place.translation());
  mjcf.site_of[name] = place;
  mjcf.body_of_site[name] = body;
}

void read_body(Mjcf& mjcf, const Element& element, const std::string& outer_class, const Isometry3d& frame, int parent);

/// Bodies and sites inside a body or the world.
void read_inside(Mjcf& mjcf, const Element& owner, const std::string& childclass, int body) {
  for_children(mjcf, owner, childclass, [&](const Element& inner, const Isometry3d& frame, const std::string& name) {
    if (inner.name == "body") {
      read_body(mjcf, inner, name, frame, body);
    } else if (inner.name == "site") {
      read_site(mjcf, inner, name, frame, body);
    } else if (inner.name == "geom") {
      lose(mjcf, inner.spot, "<geom>: only its mass is carried over, there is no contact");
    }
  });
}

void read_body(Mjcf& mjcf, const Element& element, const std::string& outer_class, const Isometry3d& frame,
               int parent) {
  require_class(mjcf, element, "childclass");
  const Attribute* own = attribute(element, "childclass");
  const std::string childclass = own ? own->value : outer_class;
  const std::string written = text_of(element, "name");
  const std::string name = written.empty() ? fmt::format("body_{}", mjcf.assembly.bodies.size()) : written;
  BodyDraft body{.name = unique_name(name, mjcf.assembly.body_names)};
  if (!written.empty() && body.name != written) body.comment = "body " + quoted_text(written);
  body.pose = draft(mjcf, parent).pose * frame * read_pose(mjcf, element, "");
  read_mass(mjcf, element, childclass, body);
  const int index = static_cast<int>(mjcf.assembly.bodies.size());
  if (!written.empty() && !mjcf.body_of.emplace(written, index).second) {
    problem(mjcf.reading, element.spot, fmt::format("body {} is defined twice", quoted_text(written)));
  }
  if (text_of(element, "mocap") == "true") lose(mjcf, element.spot, "mocap body: it is fixed");
  if (attribute(element, "gravcomp")) lose(mjcf, element.spot, "body with gravcomp: not carried over");
  mjcf.assembly.bodies.push_back(std::move(body));
  read_joints(mjcf, element, childclass, parent, index);
  read_inside(mjcf, element, childclass, index);
}

}  // namespace

void read_joints(Mjcf& mjcf, const Element& element, const std::string& childclass, int parent, int body) {
  std::vector<Placed> joints;
  for_children(mjcf, element, childclass, [&](const Element& inner, const Isometry3d& frame, const std::string& name) {
    if (inner.name != "joint" && inner.name != "freejoint") return;
    require_class(mjcf, inner, "class");
    joints.push_back({&inner, frame, name});
  });
  if (joints.empty()) {
    const std::string name = unique_joint_name(mjcf.assembly, draft(mjcf, body).name + "_fixed");
    mjcf.assembly.joints.push_back(
        {.name = name, .from = parent, .to = body, .at = draft(mjcf, body).pose.translation()});
    return;
  }
  int from = parent;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const std::optional<JointType> type = mjcf_joint_type(mjcf, *joints[i].element, joints[i].childclass);
    if (!type) return;
    if (*type == JointType::free && (parent != kGroundDraft || joints.size() > 1)) {
      problem(mjcf.reading, joints[i].element->spot,
              fmt::format("a free joint is the only joint of a body of the world, body {} is not",
                          quoted_text(draft(mjcf, body).name)));
      return;
    }
    int to = body;
    if (i + 1 < joints.size()) {
      // Several joints of one body are in series, with massless bodies between them.
      BodyDraft between{.name =
                            unique_name(fmt::format("{}_{}", draft(mjcf, body).name, i + 1), mjcf.assembly.body_names)};
      between.pose = draft(mjcf, body).pose;
      between.comment = fmt::format("between the joints of {}", draft(mjcf, body).name);
      to = static_cast<int>(mjcf.assembly.bodies.size());
      mjcf.assembly.bodies.push_back(std::move(between));
    }
    add_joint(mjcf, joints[i], *type, from, to);
    from = to;
  }
}

void report_references(Mjcf& mjcf) {
  std::map<std::string, double, std::less<>> references;
  for (const MjcfJoint& joint : mjcf.scalar_joints) references[joint.coordinate] = joint.reference;
  for (JointDraft& draft : mjcf.assembly.joints) {
    const auto found = references.find(draft.name);
    if (found == references.end() || found->second == 0) continue;
    draft.comment +=
        fmt::format("{}zero is {} of the MJCF", draft.comment.empty() ? "" : "; ", number_text(found->second));
  }
}

void read_bodies(Mjcf& mjcf, const Element& world) {
  mjcf.body_of.emplace("world", kGroundDraft);
  read_inside(mjcf, world, text_of(world, "childclass"), kGroundDraft);
}

}  // namespace mbgen::importing
