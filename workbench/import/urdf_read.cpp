// URDF: reading links and joints.
#include <fmt/format.h>

#include <array>
#include <optional>

#include "workbench/import/urdf.hpp"

namespace mbgen::importing {
namespace {

struct JointWord {
  std::string_view word;
  JointType type;
};
constexpr std::array<JointWord, 7> kUrdfJointWords = {{{"revolute", JointType::revolute},
                                                       {"continuous", JointType::revolute},
                                                       {"prismatic", JointType::prismatic},
                                                       {"fixed", JointType::fixed},
                                                       {"floating", JointType::free},
                                                       {"planar", JointType::planar},
                                                       {"spherical", JointType::spherical}}};

Vector3d read_vector(Reading& reading, const Element& element, std::string_view name, const Vector3d& fallback) {
  const Attribute* found = attribute(element, name);
  if (!found) return fallback;
  const std::optional<std::vector<double>> values = numbers(reading, *found, 3, 3);
  return values ? Vector3d((*values)[0], (*values)[1], (*values)[2]) : fallback;
}

/// Name of a referenced link and its index; -1 with a problem.
int link_index(Reading& reading, const UrdfRobot& robot, const Element& joint, std::string_view role) {
  const Element* end = child(joint, role);
  if (!end) {
    problem(reading, joint.spot, fmt::format("joint {} has no <{}>", quoted_text(text_of(joint, "name")), role));
    return -1;
  }
  const std::optional<std::string> name = required_text(reading, *end, "link");
  if (!name) return -1;
  const auto found = robot.link_of.find(*name);
  if (found != robot.link_of.end()) return found->second;
  problem(reading, attribute(*end, "link")->spot, "no link is named " + quoted_text(*name),
          "add the link, or correct the name");
  return -1;
}

void read_link(Reading& reading, const Element& element, UrdfRobot& robot) {
  const std::optional<std::string> name = required_text(reading, element, "name");
  if (!name) return;
  if (!robot.link_of.emplace(*name, static_cast<int>(robot.links.size())).second) {
    problem(reading, element.spot, fmt::format("link {} is defined twice", quoted_text(*name)));
    return;
  }
  robot.links.push_back({.element = &element, .name = *name});
}

std::optional<JointType> read_type(Reading& reading, const Element& element) {
  const std::optional<std::string> type = required_text(reading, element, "type");
  if (!type) return std::nullopt;
  for (const JointWord& word : kUrdfJointWords) {
    if (word.word == *type) return word.type;
  }
  problem(reading, attribute(element, "type")->spot, "unknown joint type " + quoted_text(*type),
          "known: revolute, continuous, prismatic, fixed, floating, planar, spherical");
  return std::nullopt;
}

/// Ends of the range of a joint; a number too large for a length or angle means no limit.
void read_limits(Reading& reading, const Element& element, UrdfJoint& joint) {
  const Element* limit = child(element, "limit");
  const bool is_limited = text_of(element, "type") == "revolute" || joint.type == JointType::prismatic;
  if (!limit || !is_limited || (!attribute(*limit, "lower") && !attribute(*limit, "upper"))) return;
  const auto end = [&](const char* name) {
    const Attribute* written = attribute(*limit, name);
    return written ? limits(reading, *written, 1, 1).value_or(std::vector<double>{0})[0] : 0.0;
  };
  joint.lower = end("lower");
  joint.upper = end("upper");
}

/// Reads a follower: position = multiplier * leader + offset.
void read_mimic(Reading& reading, UrdfRobot& robot, UrdfJoint& joint) {
  const Element* mimic = child(*joint.element, "mimic");
  if (!mimic) return;
  const std::optional<std::string> leader = required_text(reading, *mimic, "joint");
  if (!leader) return;
  const auto found = robot.joint_of.find(*leader);
  if (found == robot.joint_of.end())
    return problem(reading, attribute(*mimic, "joint")->spot, "no joint is named " + quoted_text(*leader));
  const auto has_one = [](JointType type) { return type == JointType::revolute || type == JointType::prismatic; };
  if (!has_one(joint.type) || !has_one(robot.joints[static_cast<std::size_t>(found->second)].type))
    return note(reading, mimic->spot,
                fmt::format("joint {} cannot follow {}: both must be revolute, continuous or prismatic",
                            quoted_text(joint.name), quoted_text(*leader)));
  joint.leader = found->second;
  joint.multiplier = number(reading, *mimic, "multiplier", 1);
  joint.offset = number(reading, *mimic, "offset", 0);
}

void refuse_circles(Reading& reading, UrdfRobot& robot) {
  for (UrdfJoint& joint : robot.joints) {
    int at = joint.leader;
    for (std::size_t steps = 0; at >= 0 && steps <= robot.joints.size(); ++steps)
      at = robot.joints[static_cast<std::size_t>(at)].leader;
    if (at < 0) continue;
    problem(
        reading, child(*joint.element, "mimic")->spot,
        fmt::format("joint {} follows itself, through <mimic> of the joint that it follows", quoted_text(joint.name)));
    joint.leader = -1;
  }
}

void read_joint(Reading& reading, const Element& element, UrdfRobot& robot) {
  const std::optional<std::string> name = required_text(reading, element, "name");
  const std::optional<JointType> type = read_type(reading, element);
  UrdfJoint joint{.element = &element};
  joint.parent = link_index(reading, robot, element, "parent");
  joint.child = link_index(reading, robot, element, "child");
  joint.origin = read_inner_origin(reading, element);
  if (!name || !type) return;
  joint.name = *name;
  joint.type = *type;
  if (has_axis(*type)) joint.axis = read_axis(reading, element);
  read_limits(reading, element, joint);
  const int index = static_cast<int>(robot.joints.size());
  if (!robot.joint_of.emplace(*name, index).second) {
    problem(reading, element.spot, fmt::format("joint {} is defined twice", quoted_text(*name)));
    return;
  }
  if (joint.parent >= 0 && joint.parent == joint.child) {
    problem(reading, element.spot, fmt::format("joint {} has one link at both ends", quoted_text(*name)));
  }
  if (joint.parent >= 0 && joint.child >= 0) {
    robot.links[static_cast<std::size_t>(joint.parent)].children.push_back(index);
    robot.links[static_cast<std::size_t>(joint.child)].parents.push_back(index);
  }
  robot.joints.push_back(joint);
}

}  // namespace

bool has_axis(JointType type) {
  return type == JointType::revolute || type == JointType::prismatic || type == JointType::cylindrical ||
         type == JointType::planar;
}

Isometry3d read_origin(Reading& reading, const Element& element) {
  const Vector3d xyz = read_vector(reading, element, "xyz", Vector3d::Zero());
  const Vector3d rpy = read_vector(reading, element, "rpy", Vector3d::Zero());
  Isometry3d frame = Isometry3d::Identity();
  frame.translation() = xyz;
  if (const Attribute* quaternion = attribute(element, "quat_xyzw")) {
    const auto q = numbers(reading, *quaternion, 4, 4);
    if (!q) return frame;
    const Eigen::Quaterniond turn((*q)[3], (*q)[0], (*q)[1], (*q)[2]);
    if (attribute(element, "rpy")) {
      problem(reading, quaternion->spot, fmt::format("<{}> has rpy and quat_xyzw", element.name),
              "one of them says the turn");
    } else if (turn.norm() == 0) {
      problem(reading, quaternion->spot, "quat_xyzw gives no orientation");
    } else {
      frame.linear() = turn.normalized().toRotationMatrix();
    }
    return frame;
  }
  frame.linear() = turn_of(rpy);
  return frame;
}

Isometry3d read_inner_origin(Reading& reading, const Element& element) {
  const Element* origin = child(element, "origin");
  return origin ? read_origin(reading, *origin) : Isometry3d::Identity();
}

Vector3d read_unit(Reading& reading, const Element& axis) {
  const Vector3d direction = read_vector(reading, axis, "xyz", Vector3d::UnitX());
  if (direction.norm() > 0) return direction.normalized();
  problem(reading, attribute(axis, "xyz")->spot, "axis has zero length",
          "give its direction, for example xyz=\"0 0 1\"");
  return Vector3d::UnitX();
}

Vector3d read_axis(Reading& reading, const Element& element) {
  const Element* axis = child(element, "axis");
  return axis ? read_unit(reading, *axis) : Vector3d::UnitX();
}

UrdfRobot read_robot(Reading& reading, const Element& root) {
  UrdfRobot robot;
  for (const Element& element : root.children) {
    if (element.name == "link") read_link(reading, element, robot);
  }
  if (robot.links.empty()) problem(reading, root.spot, "robot has no links");
  for (const Element& element : root.children) {
    if (element.name == "joint") read_joint(reading, element, robot);
  }
  for (UrdfJoint& joint : robot.joints) read_mimic(reading, robot, joint);
  refuse_circles(reading, robot);
  return robot;
}

}  // namespace mbgen::importing
