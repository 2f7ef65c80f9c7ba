// URDF: loops outside the format, from extensions of other programs and from a sidecar.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "compiler/text/plain_json.hpp"
#include "workbench/import/urdf.hpp"

namespace mbgen::importing {
namespace {

using Json = nlohmann::ordered_json;

struct LoopWord {
  std::string_view word;
  JointType type;
};
constexpr std::array<LoopWord, 7> kLoopWords = {{{"revolute", JointType::revolute},
                                                 {"continuous", JointType::revolute},
                                                 {"prismatic", JointType::prismatic},
                                                 {"cylindrical", JointType::cylindrical},
                                                 {"spherical", JointType::spherical},
                                                 {"planar", JointType::planar},
                                                 {"fixed", JointType::fixed}}};
constexpr const char* kLoopTypes = "known: revolute, continuous, prismatic, cylindrical, spherical, planar, fixed";

std::optional<JointType> loop_type(std::string_view typed) {
  for (const LoopWord& word : kLoopWords) {
    if (word.word == typed) return word.type;
  }
  return std::nullopt;
}

/// A problem of the sidecar, located by JSON pointer; its position in the text is unknown.
void sidecar_problem(Reading& reading, const std::string& pointer, std::string message, std::string hint) {
  Diagnostic diagnostic;
  diagnostic.where.file = reading.request.loops_file;
  diagnostic.where.pointer = pointer;
  diagnostic.message = std::move(message);
  diagnostic.hint = std::move(hint);
  reading.problems.push_back(std::move(diagnostic));
}

/// Reader of the loops in the sidecar.
struct SidecarReader {
  Reading& reading;
  UrdfRobot& robot;

  void fail(const std::string& pointer, std::string message, std::string hint = {}) {
    sidecar_problem(reading, pointer, std::move(message), std::move(hint));
  }

  std::optional<double> angle_or_length(const Json& value, const std::string& pointer) {
    if (value.is_number()) return value.get<double>();
    const bool is_degrees = value.is_object() && value.size() == 1 && value.contains("deg") && value["deg"].is_number();
    if (is_degrees) return value["deg"].get<double>() * std::numbers::pi / 180;
    fail(pointer, "must be a number, or an object like { \"deg\": 30 }");
    return std::nullopt;
  }

  std::optional<Vector3d> vector(const Json& owner, const std::string& key, const std::string& pointer) {
    if (!owner.contains(key)) return std::nullopt;
    const Json& value = owner[key];
    bool is_vector = value.is_array() && value.size() == 3;
    for (std::size_t i = 0; is_vector && i < 3; ++i) is_vector = value[i].is_number();
    if (is_vector) return Vector3d(value[0].get<double>(), value[1].get<double>(), value[2].get<double>());
    fail(pointer + "/" + key, "must be three numbers");
    return std::nullopt;
  }

  Isometry3d frame(const Json& owner, const char* xyz, const char* rpy, const std::string& pointer) {
    const Vector3d angles = vector(owner, rpy, pointer).value_or(Vector3d::Zero());
    Isometry3d result = Isometry3d::Identity();
    result.translate(vector(owner, xyz, pointer).value_or(Vector3d::Zero()));
    result.rotate(turn_of(angles));
    return result;
  }

  int link(const Json& owner, const char* key, const std::string& pointer) {
    if (!owner.contains(key) || !owner[key].is_string()) {
      fail(pointer, fmt::format("a loop needs \"{}\", the name of a link", key));
      return -1;
    }
    const auto name = owner[key].get<std::string>();
    const auto found = robot.link_of.find(name);
    if (found != robot.link_of.end()) return found->second;
    fail(pointer + "/" + key, "no link is named " + quoted_text(name));
    return -1;
  }

  void positions(const Json& list) {
    if (!list.is_object()) return fail("/positions", "must be an object of joint positions");
    for (const auto& [name, value] : list.items()) {
      const std::string pointer = "/positions/" + name;
      const auto found = robot.joint_of.find(name);
      if (found == robot.joint_of.end()) {
        fail(pointer, "no joint is named " + quoted_text(name));
        continue;
      }
      UrdfJoint& joint = robot.joints[static_cast<std::size_t>(found->second)];
      if (joint.type != JointType::revolute && joint.type != JointType::prismatic) {
        fail(pointer, "only revolute, continuous and prismatic joints have a position");
        continue;
      }
      if (const std::optional<double> position = angle_or_length(value, pointer)) joint.reference = *position;
    }
  }

  void loop(const std::string& name, const Json& value, std::vector<UrdfLoop>& loops) {
    const std::string pointer = "/loops/" + name;
    if (!value.is_object()) return fail(pointer, "must be an object with type, from and to");
    static constexpr std::array known = {"type", "from", "to", "xyz", "rpy", "axis", "to_xyz", "to_rpy"};
    for (const auto& [key, ignored] : value.items()) {
      if (std::find(known.begin(), known.end(), key) == known.end()) {
        fail(pointer + "/" + key, "unknown field", "known: type, from, to, xyz, rpy, axis, to_xyz, to_rpy");
      }
    }
    UrdfLoop loop{.name = name, .pointer = pointer};
    loop.from = link(value, "from", pointer);
    loop.to = link(value, "to", pointer);
    const bool has_type = value.contains("type") && value["type"].is_string();
    const std::optional<JointType> type = has_type ? loop_type(value["type"].get<std::string>()) : std::nullopt;
    if (!type) return fail(pointer, "a loop needs a type", kLoopTypes);
    loop.ends.type = *type;
    const Vector3d axis = vector(value, "axis", pointer).value_or(Vector3d::UnitX());
    if (axis.norm() == 0) return fail(pointer + "/axis", "axis has zero length");
    loop.ends.axis = axis.normalized();
    loop.ends.from = frame(value, "xyz", "rpy", pointer);
    loop.ends.to = frame(value, "to_xyz", "to_rpy", pointer);
    loop.has_far_frame = value.contains("to_xyz") || value.contains("to_rpy");
    if (loop.from >= 0 && loop.from == loop.to) return fail(pointer, "both ends are on one link");
    if (loop.from >= 0 && loop.to >= 0) loops.push_back(std::move(loop));
  }
};

/// One end of a <loop_joint> or <loop>: its link and its frame in it.
struct ExtensionEnd {
  int link = -1;
  Isometry3d frame = Isometry3d::Identity();
};

std::vector<ExtensionEnd> extension_ends(Reading& reading, const Element& loop, const UrdfRobot& robot) {
  std::vector<ExtensionEnd> ends;
  for (const Element& end : loop.children) {
    const bool is_end =
        end.name == "link1" || end.name == "link2" || end.name == "predecessor" || end.name == "successor";
    if (!is_end) continue;
    const std::optional<std::string> name = required_text(reading, end, "link");
    if (!name) return {};
    const auto found = robot.link_of.find(*name);
    if (found == robot.link_of.end()) {
      problem(reading, attribute(end, "link")->spot, "no link is named " + quoted_text(*name));
      return {};
    }
    const bool is_nested = child(end, "origin") != nullptr;
    ends.push_back({found->second, is_nested ? read_inner_origin(reading, end) : read_origin(reading, end)});
  }
  if (ends.size() == 2 && ends[0].link != ends[1].link) return ends;
  problem(reading, loop.spot, fmt::format("<{}> needs two different links", loop.name),
          "by <link1> and <link2>, or <predecessor> and <successor>");
  return {};
}

/// The frame and the link of an end of a <constraint>: role parent or child.
std::optional<ExtensionEnd> constraint_end(Reading& reading, const Element& constraint, const std::string& role,
                                           const UrdfRobot& robot) {
  const Element* end = child(constraint, role);
  if (!end) {
    problem(reading, constraint.spot, fmt::format("<constraint> has no <{}>", role));
    return std::nullopt;
  }
  const std::optional<std::string> name = required_text(reading, *end, "link");
  if (!name) return std::nullopt;
  const auto found = robot.link_of.find(*name);
  if (found == robot.link_of.end()) {
    problem(reading, attribute(*end, "link")->spot, "no link is named " + quoted_text(*name));
    return std::nullopt;
  }
  for (const Element& inner : end->children) {
    if (inner.name != role + "_origin" && inner.name != role + "_axis") continue;
    problem(reading, inner.spot, fmt::format("<{}> stands in <{}>: it is not read there", inner.name, role),
            fmt::format("write it beside <{}>, in <constraint>", role));
  }
  const Element* origin = child(constraint, role + "_origin");
  return ExtensionEnd{found->second, origin ? read_origin(reading, *origin) : Isometry3d::Identity()};
}

/// The direction of <parent_axis> or <child_axis>, `fallback` without it.
Vector3d constraint_axis(Reading& reading, const Element& constraint, const std::string& name,
                         const Vector3d& fallback) {
  const Element* axis = child(constraint, name);
  return axis ? read_unit(reading, *axis) : fallback;
}

/// A loop by a <constraint> as proposed for urdfdom (https://github.com/ros/urdfdom/pull/264): a frame and an axis on
/// either side.
void read_constraint(Reading& reading, const Element& constraint, JointType type, const std::string& name,
                     const UrdfRobot& robot, std::vector<UrdfLoop>& loops) {
  const std::optional<ExtensionEnd> from = constraint_end(reading, constraint, "parent", robot),
                                    to = constraint_end(reading, constraint, "child", robot);
  if (!from || !to) return;
  if (from->link == to->link) return problem(reading, constraint.spot, "<constraint> needs two different links");
  LoopEnds ends{type, from->frame, to->frame, Vector3d::UnitX()};
  if (type == JointType::universal) {
    if (!child(constraint, "parent_axis") || !child(constraint, "child_axis"))
      return problem(reading, constraint.spot, "a universal <constraint> needs <parent_axis> and <child_axis>");
    ends.axis = constraint_axis(reading, constraint, "parent_axis", ends.axis);
    ends.far = constraint_axis(reading, constraint, "child_axis", ends.far);
  }
  if (has_axis(type)) {
    ends.axis = constraint_axis(reading, constraint, "parent_axis", Vector3d::UnitX());
    const Vector3d far = constraint_axis(reading, constraint, "child_axis", ends.axis);
    // Both ends have one axis: the frame of the child turns to it.
    ends.to.rotate(Eigen::Quaterniond::FromTwoVectors(ends.axis, far));
  }
  loops.push_back({.name = name, .spot = constraint.spot, .ends = ends, .from = from->link, .to = to->link});
}

}  // namespace

std::vector<UrdfLoop> read_extension_loops(Reading& reading, const Element& root, const UrdfRobot& robot) {
  std::vector<UrdfLoop> loops;
  for (const Element& element : root.children) {
    if (element.name != "loop_joint" && element.name != "loop" && element.name != "constraint") continue;
    const std::optional<std::string> name = required_text(reading, element, "name");
    const std::optional<JointType> type = loop_type(text_of(element, "type"));
    if (element.name == "constraint" && text_of(element, "type") == "universal") {
      if (name) read_constraint(reading, element, JointType::universal, *name, robot, loops);
      continue;
    }
    if (!type) {
      problem(reading, element.spot, fmt::format("<{}> has no known type", element.name), kLoopTypes);
      continue;
    }
    if (element.name == "constraint") {
      if (name) read_constraint(reading, element, *type, *name, robot, loops);
      continue;
    }
    const std::vector<ExtensionEnd> ends = extension_ends(reading, element, robot);
    if (!name || ends.empty()) continue;
    LoopEnds frames{*type, ends[0].frame, ends[1].frame, Vector3d::UnitX()};
    if (has_axis(*type)) frames.axis = read_axis(reading, element);
    loops.push_back({.name = *name, .spot = element.spot, .ends = frames, .from = ends[0].link, .to = ends[1].link});
  }
  return loops;
}

std::vector<UrdfLoop> read_sidecar(Reading& reading, UrdfRobot& robot) {
  std::vector<UrdfLoop> sidecar;
  if (!reading.request.loops) return sidecar;
  SidecarReader reader{reading, robot};
  const PlainJson json = read_plain_json(*reading.request.loops);
  if (json.fault && !json.fault->pointer.empty()) {
    reader.fail(json.fault->pointer, json.fault->message);
    return sidecar;
  }
  if (json.fault) {
    const int file = add_source(reading, reading.request.loops_file, *reading.request.loops);
    problem(reading, {file, json.fault->byte}, json.fault->is_number ? json.fault->message : "not well-formed JSON");
    return sidecar;
  }
  const Json& root = json.value;
  if (!root.is_object()) {
    reader.fail("", "must be an object with \"loops\" or \"positions\"");
    return sidecar;
  }
  for (const auto& [key, value] : root.items()) {
    if (key == "positions") {
      reader.positions(value);
    } else if (key == "loops" && value.is_object()) {
      for (const auto& [name, loop] : value.items()) reader.loop(name, loop, sidecar);
    } else {
      reader.fail("/" + key, key == "loops" ? "must be an object of loops" : "unknown field",
                  "known: loops, positions");
    }
  }
  return sidecar;
}

void add_loops(Reading& reading, const std::vector<UrdfLoop>& loops, const UrdfRobot& robot, Assembly& assembly) {
  for (const UrdfLoop& loop : loops) {
    const int from = robot.links[static_cast<std::size_t>(loop.from)].body;
    const int to = robot.links[static_cast<std::size_t>(loop.to)].body;
    const auto pose = [&](int body) { return assembly.bodies[static_cast<std::size_t>(body)].pose; };
    LoopEnds ends = loop.ends;
    ends.from = pose(from) * ends.from;
    ends.to = loop.has_far_frame ? pose(to) * ends.to : ends.from;
    JointDraft draft{.name = unique_joint_name(assembly, loop.name),
                     .type = ends.type,
                     .from = from,
                     .to = to,
                     .at = ends.to.translation(),
                     .cut = true};
    if (has_axis(ends.type) || ends.type == JointType::universal) draft.axis = ends.from.linear() * ends.axis;
    if (ends.type == JointType::universal) {
      const Vector3d far = ends.to.linear() * ends.far;
      draft.axis2 = (far - far.dot(draft.axis) * draft.axis).normalized();
    }
    assembly.joints.push_back(std::move(draft));
    const std::string gap = gap_of(ends);
    if (gap.empty() || !is_told(robot, loop.name)) continue;
    if (loop.pointer.empty()) {
      problem(reading, loop.spot,
              fmt::format("loop {} does not close, {}{}", quoted_text(loop.name), gap, remains_open(robot, loop.name)),
              kGapHint);
    } else {
      sidecar_problem(reading, loop.pointer, "loop does not close, " + gap + remains_open(robot, loop.name),
                      "name joint positions at which it closes, as \"positions\": { \"joint\": 0.3 }");
    }
  }
}

}  // namespace mbgen::importing
