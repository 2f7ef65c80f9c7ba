// URDF: motors by <transmission> (http://wiki.ros.org/urdf/XML/Transmission) and by commands in <ros2_control>
// (https://control.ros.org, hardware components).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "workbench/import/urdf.hpp"

namespace mbgen::importing {
namespace {

/// The only child of this name, null for none and for several.
const Element* only_child(const Element& element, std::string_view name) {
  const auto is_named = [&](const Element& inner) { return inner.name == name; };
  return std::ranges::count_if(element.children, is_named) == 1 ? child(element, name) : nullptr;
}

/// Speed of the motor over rate of the joint; 1 where it is not written. Fails (nothing, with a problem): no number.
std::optional<double> reduction_of(Reading& reading, const Element& element) {
  for (const char* name : {"mechanicalReduction", "mechanical_reduction"}) {
    const Element* written = child(element, name);
    if (!written) continue;
    const auto value = numbers(reading, {name, written->text, written->spot}, 1, 1);
    if (value && value->front() != 0) return value->front();
    if (value) problem(reading, written->spot, fmt::format("<{}> is 0: its joint would not move", name));
    return std::nullopt;
  }
  return 1;
}

/// Largest force of a joint by its <limit>, infinite without one.
double effort_of(Reading& reading, const UrdfJoint& joint) {
  const Element* limit = child(*joint.element, "limit");
  const Attribute* effort = limit ? attribute(*limit, "effort") : nullptr;
  const auto value = effort ? limits(reading, *effort, 1, 1) : std::nullopt;
  return value && value->front() > 0 ? value->front() : std::numeric_limits<double>::infinity();
}

/// Adds a motor to a joint that has none yet. element: that names the joint.
void add_motor(Reading& reading, const UrdfRobot& robot, const Element& element, std::string_view name, double gear,
               std::set<std::string>& moved, Assembly& assembly) {
  const auto found = robot.joint_of.find(text_of(element, "name"));
  if (found == robot.joint_of.end())
    return problem(reading, element.spot, "no joint is named " + quoted_text(text_of(element, "name")));
  const UrdfJoint& joint = robot.joints[static_cast<std::size_t>(found->second)];
  if (joint.coordinate.empty()) {
    note(reading, element.spot,
         fmt::format("motor of joint {} not carried over: the joint has not one coordinate", quoted_text(joint.name)));
    return;
  }
  if (!moved.insert(joint.coordinate).second) return;
  assembly.actuators.push_back({unique_name(name.empty() ? joint.coordinate + "_motor" : name, assembly.input_names),
                                joint.coordinate, gear, effort_of(reading, joint) / std::abs(gear)});
}

void add_transmission(Reading& reading, const UrdfRobot& robot, const Element& transmission,
                      std::set<std::string>& moved, Assembly& assembly) {
  const Element *joint = only_child(transmission, "joint"), *actuator = only_child(transmission, "actuator");
  if (!joint || !actuator) {
    note(reading, transmission.spot,
         fmt::format("transmission {} not carried over: it has not one joint and one actuator",
                     quoted_text(text_of(transmission, "name"))));
    return;
  }
  const std::optional<double> at_actuator = reduction_of(reading, *actuator), at_joint = reduction_of(reading, *joint);
  if (at_actuator && at_joint)
    add_motor(reading, robot, *joint, text_of(*actuator, "name"), *at_actuator * *at_joint, moved, assembly);
}

}  // namespace

void add_transmissions(Reading& reading, const Element& root, const UrdfRobot& robot, Assembly& assembly) {
  std::set<std::string> moved;
  for (const Element& element : root.children) {
    if (element.name == "transmission") add_transmission(reading, robot, element, moved, assembly);
    if (element.name != "ros2_control") continue;
    for (const Element& inner : element.children)
      if (inner.name == "transmission") add_transmission(reading, robot, inner, moved, assembly);
  }
  for (const Element& control : root.children) {
    if (control.name != "ros2_control") continue;
    for (const Element& joint : control.children)
      if (joint.name == "joint" && child(joint, "command_interface"))
        add_motor(reading, robot, joint, "", 1, moved, assembly);
  }
}

}  // namespace mbgen::importing
