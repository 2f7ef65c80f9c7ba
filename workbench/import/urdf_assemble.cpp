// URDF: placement of links along a spanning tree; their bodies and joints.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "workbench/import/urdf.hpp"

namespace mbgen::importing {
namespace {

constexpr double kClosureTolerance = 1e-6;  // m and rad, as the model's reader allows

UrdfLink& link(UrdfRobot& robot, int index) { return robot.links[static_cast<std::size_t>(index)]; }

/// Inertia about the centre of mass in the link's axes.
void read_inertial(Reading& reading, const UrdfLink& link, BodyDraft& body) {
  const Element* inertial = child(*link.element, "inertial");
  if (!inertial) return;
  const Element* mass = child(*inertial, "mass");
  const Element* inertia = child(*inertial, "inertia");
  if (!mass || !inertia) {
    problem(reading, inertial->spot, fmt::format("<inertial> needs a <{}>", mass ? "inertia" : "mass"));
    return;
  }
  if (!required_text(reading, *mass, "value")) return;
  const auto entry = [&](const char* name) { return number(reading, *inertia, name, 0); };
  const double xx = entry("ixx"), yy = entry("iyy"), zz = entry("izz");
  const double xy = entry("ixy"), xz = entry("ixz"), yz = entry("iyz");
  Matrix3d written;
  written << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  const Isometry3d frame = read_inner_origin(reading, *inertial);
  body.mass = number(reading, *mass, "value", 0);
  body.com = frame.translation();
  body.inertia = frame.linear() * written * frame.linear().transpose();
  body.title = "link " + quoted_text(link.name);
  body.inertia_spot = inertia->spot;
  if (body.mass < 0)
    problem(reading, mass->spot, fmt::format("{}: mass is negative, {:.6g} kg", body.title, body.mass));
}

/// Cycle of a link that is its own ancestor: "a -> b -> a".
std::string circle_text(const UrdfRobot& robot, int start) {
  std::vector<int> path;
  int at = start;
  while (std::find(path.begin(), path.end(), at) == path.end()) {
    path.push_back(at);
    const UrdfLink& here = robot.links[static_cast<std::size_t>(at)];
    at = robot.joints[static_cast<std::size_t>(here.parents.front())].parent;
  }
  std::string text = robot.links[static_cast<std::size_t>(at)].name;
  for (auto i = path.rbegin(); i != path.rend(); ++i) {
    text += " -> " + robot.links[static_cast<std::size_t>(*i)].name;
    if (*i == at) break;
  }
  return text;
}

/// Index of the root, the only link without a parent joint; -1 with a problem if there is none or more than one.
int root_of(Reading& reading, const UrdfRobot& robot) {
  int root = -1;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (!robot.links[i].parents.empty()) continue;
    if (root >= 0) {
      problem(reading, robot.links[i].element->spot,
              fmt::format("links {} and {} are both no joint's child", quoted_text(robot.links[root].name),
                          quoted_text(robot.links[i].name)),
              "every link but the root hangs on a joint; a fixed joint holds two parts together");
      return -1;
    }
    root = static_cast<int>(i);
  }
  if (root < 0) {
    problem(reading, robot.links[0].element->spot,
            "no link is the root, they hang in a circle: " + circle_text(robot, 0),
            "turn a joint of the circle round, its child and parent exchanged: it then closes a loop");
  }
  return root;
}

/// Places the child of a joint with a placed parent.
void place(UrdfRobot& robot, int index, std::vector<BodyDraft>& bodies) {
  const UrdfJoint& joint = robot.joints[static_cast<std::size_t>(index)];
  UrdfLink& below = link(robot, joint.child);
  below.is_placed = true;
  below.placed_by = index;
  bodies[static_cast<std::size_t>(below.body)].pose =
      bodies[static_cast<std::size_t>(link(robot, joint.parent).body)].pose * moved(joint);
}

/// The first joint in the file from a placed link to one not yet placed; -1 without any.
int leaving_joint(const UrdfRobot& robot) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const UrdfJoint& joint = robot.joints[i];
    if (robot.links[static_cast<std::size_t>(joint.parent)].is_placed &&
        !robot.links[static_cast<std::size_t>(joint.child)].is_placed) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

std::string limits_text(Reading& reading, const UrdfJoint& joint) {
  const Element* limit = child(*joint.element, "limit");
  if (!limit) return {};
  const bool turns = joint.type == JointType::revolute;
  std::string text;
  if (std::isfinite(joint.lower) || std::isfinite(joint.upper))
    text = fmt::format("limits {} .. {} {}", joint.lower, joint.upper, turns ? "rad" : "m");
  const auto add = [&](const char* name, const char* unit) {
    const Attribute* written = attribute(*limit, name);
    const auto value = written ? limits(reading, *written, 1, 1) : std::nullopt;
    if (!value || !std::isfinite(value->front())) return;
    text += fmt::format("{}{} {} {}", text.empty() ? "" : ", ", name, value->front(), unit);
  };
  add("effort", turns ? "N m" : "N");
  add("velocity", turns ? "rad/s" : "m/s");
  add("acceleration", turns ? "rad/s^2" : "m/s^2");
  add("deceleration", turns ? "rad/s^2" : "m/s^2");
  add("jerk", turns ? "rad/s^3" : "m/s^3");
  return text;
}

void add_joint(Reading& reading, UrdfRobot& robot, int index, Assembly& assembly) {
  const UrdfJoint& joint = robot.joints[static_cast<std::size_t>(index)];
  const UrdfLink &parent = link(robot, joint.parent), &below = link(robot, joint.child);
  const Isometry3d child_pose = assembly.bodies[static_cast<std::size_t>(below.body)].pose;
  JointDraft draft{.name = unique_joint_name(assembly, joint.name),
                   .type = joint.type,
                   .from = parent.body,
                   .to = below.body,
                   .at = child_pose.translation()};
  if (has_axis(joint.type)) draft.axis = child_pose.linear() * joint.axis;
  draft.comment = limits_text(reading, joint);
  if (const Element* limit = child(*joint.element, "limit"))
    note_narrow(reading, limit->spot, joint.name, joint.lower, joint.upper,
                joint.type == JointType::revolute ? "rad" : "m",
                "type=\"fixed\" holds it, with its <origin> at this position");
  if (joint.reference != 0) {
    draft.comment +=
        fmt::format("{}zero is {} of the URDF", draft.comment.empty() ? "" : "; ", number_text(joint.reference));
  }
  if (below.placed_by != index) {
    draft.cut = true;
    note(reading, joint.element->spot,
         fmt::format("link {} is the child of joints {} and {}: the latter closes a loop", quoted_text(below.name),
                     quoted_text(robot.joints[static_cast<std::size_t>(below.placed_by)].name),
                     quoted_text(joint.name)));
    const Isometry3d pose = assembly.bodies[static_cast<std::size_t>(parent.body)].pose;
    const std::string gap = gap_of({joint.type, pose * moved(joint), child_pose, joint.axis});
    if (!gap.empty() && is_told(robot, joint.name)) {
      problem(reading, joint.element->spot,
              fmt::format("joint {} does not close its loop, {}{}", quoted_text(joint.name), gap,
                          remains_open(robot, joint.name)),
              kGapHint);
    }
  } else if (std::isfinite(joint.lower) || std::isfinite(joint.upper)) {
    add_stops(reading.request, assembly, draft.name, joint.lower - joint.reference, joint.upper - joint.reference);
  }
  const Element* dynamics = child(*joint.element, "dynamics");
  if (dynamics) {
    const double damping = number(reading, *dynamics, "damping", 0),
                 friction = number(reading, *dynamics, "friction", 0);
    const bool has_one_coordinate = joint.type == JointType::revolute || joint.type == JointType::prismatic;
    if (damping < 0 || friction < 0) {
      problem(reading, dynamics->spot,
              fmt::format("joint {}: damping and friction are not negative", quoted_text(joint.name)));
    } else if (draft.cut || !has_one_coordinate) {
      note(reading, dynamics->spot,
           fmt::format("damping and friction of joint {} are not carried over: it {}", quoted_text(joint.name),
                       draft.cut ? "closes a loop" : "has not one coordinate"));
    } else {
      add_joint_forces(assembly, draft.name, 0, damping, 0, friction);
    }
  }
  assembly.joints.push_back(std::move(draft));
}

void note_massless(Reading& reading, const UrdfRobot& robot) {
  const UrdfLink* first = nullptr;
  std::vector<std::string> names;
  for (const UrdfLink& link : robot.links) {
    if (child(*link.element, "inertial") || link.placed_by < 0) continue;
    if (robot.joints[static_cast<std::size_t>(link.placed_by)].type == JointType::fixed) continue;
    if (!first) first = &link;
    names.push_back(link.name);
  }
  if (names.size() == 1) {
    note(reading, first->element->spot,
         fmt::format("link {} moves and has no <inertial>: it is massless", quoted_text(first->name)));
  } else if (first) {
    note(reading, first->element->spot,
         fmt::format("links {} move and have no <inertial>: they are massless", few_names(names)));
  }
}

void add_bodies(Reading& reading, UrdfRobot& robot, int root, Assembly& assembly) {
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    UrdfLink& link = robot.links[i];
    if (static_cast<int>(i) == root && link.name == "world") {
      link.body = kGroundDraft;
      continue;
    }
    link.body = static_cast<int>(assembly.bodies.size());
    BodyDraft body{.name = unique_name(link.name, assembly.body_names)};
    if (body.name != link.name) body.comment = "link " + quoted_text(link.name);
    read_inertial(reading, link, body);
    assembly.bodies.push_back(std::move(body));
  }
}

/// Adds the joint of the root link.
void add_base(Reading& reading, const UrdfRobot& robot, int root, Assembly& assembly) {
  const UrdfLink& base = robot.links[static_cast<std::size_t>(root)];
  if (base.body == kGroundDraft) return;
  const bool floats = reading.request.base == RobotBase::floating;
  assembly.joints.push_back({.name = unique_joint_name(assembly, floats ? "floating_base" : "fixed_base"),
                             .type = floats ? JointType::free : JointType::fixed,
                             .to = base.body});
  if (!floats) {
    note(reading, base.element->spot, fmt::format("root link {} is fixed to the ground", quoted_text(base.name)),
         "--base floating lets it move");
  }
}

}  // namespace

Isometry3d moved(const UrdfJoint& joint) {
  Isometry3d frame = joint.origin;
  if (joint.type == JointType::revolute) frame.rotate(Eigen::AngleAxisd(joint.reference, joint.axis));
  if (joint.type == JointType::prismatic) frame.translate(joint.reference * joint.axis);
  return frame;
}

void place_links(UrdfRobot& robot, int root, std::vector<BodyDraft>& bodies) {
  for (UrdfLink& link : robot.links) link.is_placed = false;
  link(robot, root).is_placed = true;
  std::vector<int> reached = {root};
  for (std::size_t next = 0;; ++next) {
    if (next == reached.size()) {
      const int other = leaving_joint(robot);
      if (other < 0) return;
      place(robot, other, bodies);
      reached.push_back(robot.joints[static_cast<std::size_t>(other)].child);
    }
    for (const int index : link(robot, reached[next]).children) {
      const int child = robot.joints[static_cast<std::size_t>(index)].child;
      if (link(robot, child).is_placed || link(robot, child).parents.front() != index) continue;
      place(robot, index, bodies);
      reached.push_back(child);
    }
  }
}

const char* const kGapHint =
    "name joint positions at which it closes: --loops FILE with { \"positions\": { \"joint\": 0.3 } }";

std::string gap_of(const LoopEnds& ends) {
  const Isometry3d between = ends.from.inverse() * ends.to;
  Vector3d gap = between.translation();
  const Vector3d along = ends.axis * ends.axis.dot(gap);
  const bool slides = ends.type == JointType::prismatic || ends.type == JointType::cylindrical;
  if (slides) gap -= along;
  if (ends.type == JointType::planar) gap = along;
  if (ends.type != JointType::free && gap.norm() > kClosureTolerance) {
    return fmt::format("its ends are {:.6g} m apart at the reference", gap.norm());
  }
  const double turned = Eigen::AngleAxisd(between.linear()).angle();
  if (ends.type == JointType::universal) {
    const double off = std::abs(gap_between(ends).turned.norm());
    return off > kClosureTolerance ? fmt::format("its axes are {:.6g} rad off a right angle at the reference", off)
                                   : "";
  }
  const Vector3d axis = between.linear() * ends.axis;
  const double tilted = std::atan2(axis.cross(ends.axis).norm(), axis.dot(ends.axis));
  const bool holds_all = ends.type == JointType::fixed || ends.type == JointType::prismatic;
  if (holds_all && std::abs(turned) > kClosureTolerance) {
    return fmt::format("its ends are {:.6g} rad apart at the reference", std::abs(turned));
  }
  const bool holds_axis = !holds_all && ends.type != JointType::spherical && ends.type != JointType::free;
  if (holds_axis && tilted > kClosureTolerance) {
    return fmt::format("its axes are {:.6g} rad apart at the reference", tilted);
  }
  return {};
}

std::string remains_open(const UrdfRobot& robot, const std::string& name) {
  const auto found = robot.left_open.find(name);
  return found == robot.left_open.end() ? std::string() : "; " + found->second;
}

bool is_told(const UrdfRobot& robot, const std::string& name) {
  return !robot.is_closed_by_moving && (robot.left_open.empty() || robot.left_open.contains(name));
}

void follow_leaders(UrdfRobot& robot) {
  // A leader may be a follower itself; cycles are refused earlier.
  for (std::size_t pass = 0; pass < robot.joints.size(); ++pass) {
    bool has_moved = false;
    for (UrdfJoint& joint : robot.joints) {
      if (joint.leader < 0) continue;
      const double wanted =
          joint.multiplier * robot.joints[static_cast<std::size_t>(joint.leader)].reference + joint.offset;
      has_moved = has_moved || wanted != joint.reference;
      joint.reference = wanted;
    }
    if (!has_moved) return;
  }
}

void add_mimics(Reading& reading, const UrdfRobot& robot, const std::map<int, std::string>& coordinate_of,
                Assembly& assembly) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const UrdfJoint& joint = robot.joints[i];
    if (joint.leader < 0) continue;
    const auto own = coordinate_of.find(static_cast<int>(i)), leader = coordinate_of.find(joint.leader);
    if (own == coordinate_of.end() || leader == coordinate_of.end()) {
      const int cut = own == coordinate_of.end() ? static_cast<int>(i) : joint.leader;
      note(reading, child(*joint.element, "mimic")->spot,
           fmt::format("joint {} does not follow {}: {} closes a loop and has no coordinate", quoted_text(joint.name),
                       quoted_text(robot.joints[static_cast<std::size_t>(joint.leader)].name),
                       quoted_text(robot.joints[static_cast<std::size_t>(cut)].name)),
           "name a joint of the tree");
      continue;
    }
    // Both coordinates are zero at the reference, where the relation holds.
    assembly.couplings.push_back({unique_name(joint.name, assembly.coupling_names),
                                  sum_text({{1, "z." + own->second}, {-joint.multiplier, "z." + leader->second}})});
  }
}

void assemble_robot(Reading& reading, UrdfRobot& robot, const std::vector<UrdfLoop>& loops, Assembly& assembly) {
  const int root = root_of(reading, robot);
  if (root < 0) return;
  add_bodies(reading, robot, root, assembly);
  follow_leaders(robot);
  place_links(robot, root, assembly.bodies);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (robot.links[i].is_placed) continue;
    problem(reading, robot.links[i].element->spot,
            fmt::format("link {} does not hang on root {}: {}", quoted_text(robot.links[i].name),
                        quoted_text(robot.links[static_cast<std::size_t>(root)].name),
                        circle_text(robot, static_cast<int>(i))),
            "joints in a circle need one that comes from the root");
    return;
  }
  close_loops(reading, robot, loops, root, assembly.bodies);
  add_base(reading, robot, root, assembly);
  std::map<int, std::string> coordinate_of;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    add_joint(reading, robot, static_cast<int>(i), assembly);
    const JointDraft& made = assembly.joints.back();
    if (made.cut) continue;
    coordinate_of[static_cast<int>(i)] = made.name;
    if (made.type == JointType::revolute || made.type == JointType::prismatic) robot.joints[i].coordinate = made.name;
  }
  add_mimics(reading, robot, coordinate_of, assembly);
  note_massless(reading, robot);
}

}  // namespace mbgen::importing
