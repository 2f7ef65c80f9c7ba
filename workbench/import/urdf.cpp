#include "workbench/import/urdf.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "workbench/import/known.hpp"

namespace mbgen::importing {
namespace {

/// Reports text left over for xacro. Result: whether there is any.
bool refuse_xacro(Reading& reading, const Element& element) {
  constexpr const char* hint = "expand it first: xacro robot.urdf.xacro > robot.urdf";
  if (element.name.starts_with("xacro:")) {
    problem(reading, element.spot, fmt::format("<{}> is a macro of xacro, not URDF", element.name), hint);
    return true;
  }
  for (const Attribute& attribute : element.attributes) {
    if (attribute.value.find("${") == std::string::npos) continue;
    problem(reading, attribute.spot,
            fmt::format("{} is an expression of xacro, not URDF", quoted_text(attribute.value)), hint);
    return true;
  }
  for (const Element& inner : element.children) {
    if (refuse_xacro(reading, inner)) return true;
  }
  return false;
}

/// Joints of Drake that URDF does not have: without them the links are not connected.
bool refuse_drake(Reading& reading, const Element& root) {
  const auto is_drake = [](const Element& element) { return element.name == "drake:joint"; };
  const auto first = std::find_if(root.children.begin(), root.children.end(), is_drake);
  if (first == root.children.end()) return false;
  const auto count = std::count_if(root.children.begin(), root.children.end(), is_drake);
  problem(reading, first->spot,
          fmt::format("<drake:joint>{} is no element of URDF", count > 1 ? fmt::format(" ({} of them)", count) : ""),
          "write <joint>, here with type=\"spherical\" for a ball and type=\"planar\" for a planar joint; a universal "
          "joint "
          "is two revolute ones with a link between them, a screw is typed into the model as a coupling");
  return true;
}

void note_limits(Reading& reading, const Element& root) {
  const Element* first = nullptr;
  int count = 0;
  for (const Element& joint : root.children) {
    const Element* limit = joint.name == "joint" ? child(joint, "limit") : nullptr;
    if (!limit) continue;
    if (count++ == 0) first = limit;
  }
  if (!first) return;
  const std::string times = count > 1 ? fmt::format(" ({} of them)", count) : std::string();
  note(reading, first->spot,
       fmt::format("<limit>{} not carried over: {}", times,
                   reading.request.stop_stiffness > 0
                       ? "ranges of joints become stops, efforts and velocities stand beside the joints as comments"
                       : "limits are not enforced, they stand beside the joints as comments"),
       reading.request.stop_stiffness > 0 ? "" : "--stops STIFFNESS makes stops of the ranges");
}

}  // namespace

void import_urdf(Reading& reading, const Element& root, Assembly& assembly) {
  if (refuse_xacro(reading, root) || refuse_drake(reading, root)) return;
  note_left_out(reading, root, kUrdf);
  UrdfRobot robot = read_robot(reading, root);
  const std::vector<UrdfLoop> sidecar = read_sidecar(reading, robot);
  if (!reading.problems.empty()) return;
  std::vector<UrdfLoop> loops = read_extension_loops(reading, root, robot);
  loops.insert(loops.end(), sidecar.begin(), sidecar.end());
  if (!reading.problems.empty()) return;
  assemble_robot(reading, robot, loops, assembly);
  if (!reading.problems.empty()) return;
  add_loops(reading, loops, robot, assembly);
  align_closing_axes(reading, root.spot, assembly);
  add_transmissions(reading, root, robot, assembly);
  add_visuals(reading, root, robot, assembly);
  check_inertias(reading, assembly);
  if (!assembly.frictions.empty()) {
    note(reading, root.spot,
         fmt::format("friction of {} joint{} is smoothed below {} rad/s or m/s", assembly.frictions.size(),
                     assembly.frictions.size() == 1 ? "" : "s", kFrictionVelocity));
  }
  note_limits(reading, root);
}

}  // namespace mbgen::importing
