#include "compiler/import/urdf.hpp"

#include <fmt/format.h>

#include <array>
#include <map>

namespace mbgen::importing {
namespace {

/// Complains about text that xacro should have replaced. Result: whether there is any.
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

/// Elements that have no part in a model: name, and why.
struct LeftOut {
  std::string_view name, reason;
};
constexpr std::array<LeftOut, 6> kLeftOutOfRobot = {{{"transmission", "motors are not part of the mechanism"},
                                                     {"gazebo", "settings of Gazebo are not read"},
                                                     {"mujoco", "settings of MuJoCo are not read"},
                                                     {"sensor", "outputs are chosen in the model"},
                                                     {"ros2_control", "controllers are not part of the mechanism"},
                                                     {"coupling", "the format has no relation between coordinates"}}};
constexpr std::array<LeftOut, 1> kLeftOutOfLink = {{{"collision", "there is no contact"}}};
constexpr std::array<LeftOut, 3> kLeftOutOfJoint = {
    {{"limit", "limits are not enforced, they stand beside the joints as comments"},
     {"calibration", "it is not part of the mechanism"},
     {"safety_controller", "controllers are not part of the mechanism"}}};
constexpr std::array<std::string_view, 4> kReadOfLink = {"inertial", "origin", "name", "visual"};
constexpr std::array<std::string_view, 6> kReadOfJoint = {"origin", "parent", "child", "axis", "dynamics", "mimic"};
constexpr std::array<std::string_view, 5> kReadOfRobot = {"link", "joint", "loop_joint", "loop", "material"};

/// Elements of one kind that are left out.
struct Count {
  Spot first;
  int count = 0;
  std::string_view reason;
};

template <std::size_t left_out, std::size_t read>
void count_left_out(const Element& owner, const std::array<LeftOut, left_out>& table,
                    const std::array<std::string_view, read>& known, std::map<std::string, Count>& counts) {
  for (const Element& element : owner.children) {
    if (std::find(known.begin(), known.end(), element.name) != known.end()) continue;
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const LeftOut& l) { return l.name == element.name; });
    Count& count = counts[element.name];
    if (count.count++ == 0) count.first = element.spot;
    count.reason = found == table.end() ? std::string_view("it is unknown") : found->reason;
  }
}

void note_left_out(Reading& reading, const Element& root) {
  std::map<std::string, Count> counts;
  count_left_out(root, kLeftOutOfRobot, kReadOfRobot, counts);
  for (const Element& element : root.children) {
    if (element.name == "link") count_left_out(element, kLeftOutOfLink, kReadOfLink, counts);
    if (element.name == "joint") count_left_out(element, kLeftOutOfJoint, kReadOfJoint, counts);
  }
  for (const auto& [name, count] : counts) {
    const std::string times = count.count > 1 ? fmt::format(" ({} of them)", count.count) : std::string();
    note(reading, count.first, fmt::format("<{}>{} not carried over: {}", name, times, count.reason));
  }
}

}  // namespace

void import_urdf(Reading& reading, const Element& root, Assembly& assembly) {
  if (refuse_xacro(reading, root)) return;
  UrdfRobot robot = read_robot(reading, root);
  const std::vector<UrdfLoop> sidecar = read_sidecar(reading, robot);
  if (!reading.problems.empty()) return;
  std::vector<UrdfLoop> loops = read_extension_loops(reading, root, robot);
  loops.insert(loops.end(), sidecar.begin(), sidecar.end());
  if (!reading.problems.empty()) return;
  assemble_robot(reading, robot, loops, assembly);
  if (!reading.problems.empty()) return;
  add_loops(reading, loops, robot, assembly);
  add_visuals(reading, root, robot, assembly);
  check_inertias(reading, assembly);
  if (!assembly.frictions.empty()) {
    note(reading, root.spot,
         fmt::format("friction of {} joint{} is smoothed below {} rad/s or m/s", assembly.frictions.size(),
                     assembly.frictions.size() == 1 ? "" : "s", kFrictionVelocity));
  }
  note_left_out(reading, root);
}

}  // namespace mbgen::importing
