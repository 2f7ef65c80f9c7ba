// URDF: reading links and joints.
#include <fmt/format.h>

#include <array>
#include <optional>

#include "compiler/import/urdf.hpp"

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

/// The name of a link that an element refers to, and its index; -1 with a problem.
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
  frame.linear() = (Eigen::AngleAxisd(rpy[2], Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy[1], Vector3d::UnitY()) *
                    Eigen::AngleAxisd(rpy[0], Vector3d::UnitX()))
                       .toRotationMatrix();
  return frame;
}

Isometry3d read_inner_origin(Reading& reading, const Element& element) {
  const Element* origin = child(element, "origin");
  return origin ? read_origin(reading, *origin) : Isometry3d::Identity();
}

Vector3d read_axis(Reading& reading, const Element& element) {
  const Element* axis = child(element, "axis");
  if (!axis) return Vector3d::UnitX();
  const Vector3d direction = read_vector(reading, *axis, "xyz", Vector3d::UnitX());
  if (direction.norm() > 0) return direction.normalized();
  problem(reading, attribute(*axis, "xyz")->spot, "axis has zero length",
          "give its direction, for example xyz=\"0 0 1\"");
  return Vector3d::UnitX();
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
  return robot;
}

}  // namespace mbgen::importing
