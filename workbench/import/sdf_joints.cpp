// SDF: joints, their springs, couplings, and the joints that close loops.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "workbench/import/sdf.hpp"

namespace mbgen::importing {
namespace {

/// A turn or a slide of a joint.
struct SdfAxis {
  const Element* element = nullptr;        ///< <axis> or <axis2>, null for a free turn of a screw
  Vector3d direction = Vector3d::UnitZ();  ///< unit, global at the reference
};

/// A coordinate that others may look at.
struct SdfCoordinate {
  int draft = -1;  ///< index into Assembly::joints
  const Element* joint = nullptr;
};

struct JointReader {
  Reading& reading;
  const SdfModel& model;
  Assembly& assembly;
  std::map<std::string, SdfCoordinate, std::less<>> coordinates;  ///< by joint; "NAME_2" of a second axis
  std::vector<int> coupled;                                       ///< drafts that couplings look at
  const Element* first_limit = nullptr;
  int limit_count = 0;

  Vector3d read_direction(const Element& joint, const Element& axis) {
    const Element* xyz = child(axis, "xyz");
    Vector3d direction = Vector3d::UnitZ();
    if (xyz)
      if (const auto v = numbers(reading, {"xyz", xyz->text, xyz->spot}, 3, 3))
        direction = Vector3d((*v)[0], (*v)[1], (*v)[2]);
    if (direction.norm() == 0) {
      problem(reading, axis.spot, "axis has zero length", "give its direction, for example <xyz>0 0 1</xyz>");
      return Vector3d::UnitZ();
    }
    std::string frame = xyz ? text_of(*xyz, "expressed_in") : "";
    if (frame.empty()) frame = is_axis_of_model(reading, axis, model.version) ? "__model__" : text_of(joint, "name");
    const auto pose = frame_pose(reading, model, frame, xyz ? *xyz : axis);
    return pose ? Vector3d(model.pose.linear() * pose->linear() * direction.normalized()) : direction.normalized();
  }

  /// Springs, friction, stops and the comment of one coordinate.
  void add_forces(const SdfAxis& axis, JointDraft& draft) {
    if (!axis.element) return;
    if (const Element* dynamics = child(*axis.element, "dynamics")) {
      const double damping = inner_number(reading, *dynamics, "damping", 0),
                   friction = inner_number(reading, *dynamics, "friction", 0),
                   stiffness = inner_number(reading, *dynamics, "spring_stiffness", 0);
      if (damping < 0 || friction < 0 || stiffness < 0)
        problem(reading, dynamics->spot,
                fmt::format("joint {}: damping, friction or stiffness is negative", draft.name));
      add_joint_forces(assembly, draft.name, stiffness, damping,
                       inner_number(reading, *dynamics, "spring_reference", 0), friction);
    }
    const Element* limit = child(*axis.element, "limit");
    if (!limit) return;
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const bool turns = draft.type == JointType::revolute;
    const double lower = inner_limit(reading, *limit, "lower", -kNone),
                 upper = inner_limit(reading, *limit, "upper", kNone);
    if (std::isfinite(lower) || std::isfinite(upper)) {
      if (limit_count++ == 0) first_limit = limit;
      draft.comment = fmt::format("limits {} .. {} {}", lower, upper, turns ? "rad" : "m");
      add_stops(reading.request, assembly, draft.name, lower, upper);
      note_narrow(reading, limit->spot, draft.name, lower, upper, turns ? "rad" : "m",
                  "type \"fixed\" holds it, with the link's pose at this position");
    }
    for (const auto& [name, unit] : {std::pair("effort", turns ? "N m" : "N"), {"velocity", turns ? "rad/s" : "m/s"}}) {
      const double value = inner_limit(reading, *limit, name, kNone);
      if (std::isfinite(value) && value >= 0)
        draft.comment += fmt::format("{}{} {} {}", draft.comment.empty() ? "" : ", ", name, value, unit);
    }
  }

  /// A massless body at a joint.
  int add_between(const std::string& name, const Isometry3d& pose) {
    BodyDraft body{.name = unique_name(name, assembly.body_names), .pose = pose};
    body.comment = "massless, between the axes of a joint";
    assembly.bodies.push_back(std::move(body));
    return static_cast<int>(assembly.bodies.size()) - 1;
  }

  /// Adds a joint draft. Result: its index.
  int add(const Element& joint, const std::string& name, JointType type, int from, int to, const Isometry3d& pose,
          const SdfAxis& axis = {}) {
    JointDraft draft{
        .name = unique_joint_name(assembly, name), .type = type, .from = from, .to = to, .at = pose.translation()};
    if (type == JointType::revolute || type == JointType::prismatic) {
      draft.axis = axis.direction;
      add_forces(axis, draft);
      coordinates.try_emplace(name, SdfCoordinate{static_cast<int>(assembly.joints.size()), &joint});
    }
    assembly.joints.push_back(std::move(draft));
    return static_cast<int>(assembly.joints.size()) - 1;
  }

  /// One or two axes of a joint; nothing with a problem.
  std::vector<SdfAxis> read_axes(const Element& joint, std::size_t count) {
    std::vector<SdfAxis> axes;
    for (const char* name : {"axis", "axis2"}) {
      if (axes.size() == count) break;
      const Element* axis = child(joint, name);
      if (!axis) {
        problem(reading, joint.spot, fmt::format("joint {} has no <{}>", quoted_text(text_of(joint, "name")), name));
        return {};
      }
      axes.push_back({axis, read_direction(joint, *axis)});
    }
    return axes;
  }

  /// Ratio of a slide over its turn, m/rad.
  double lead_of(const Element& joint) {
    const double way = inner_number(reading, joint, "screw_thread_pitch", 0);
    if (way != 0) return way / (2 * std::numbers::pi);
    const double pitch = inner_number(reading, joint, "thread_pitch", 0);
    if (pitch != 0) return -1 / pitch;  // rad/m, positive to the left
    problem(reading, joint.spot, fmt::format("screw {} has no pitch", quoted_text(text_of(joint, "name"))),
            "<screw_thread_pitch> is its way per revolution, m, and not zero");
    return 0;
  }

  void read(const Element& joint) {
    const std::string name = text_of(joint, "name"), type = text_of(joint, "type");
    const auto end = [&](const char* role) {
      const std::string frame = inner_text(joint, role);
      if (!frame.empty()) return body_of_frame(reading, model, frame, joint);
      problem(reading, joint.spot, fmt::format("joint {} has no <{}>", quoted_text(name), role));
      return -1;
    };
    const int from = end("parent"), to = end("child");
    if (from < 0 || to < 0) return;
    if (from == to)
      return problem(reading, joint.spot, fmt::format("joint {} has one link at both ends", quoted_text(name)));
    const auto in_model = frame_pose(reading, model, name, joint);
    if (!in_model) return;
    const Isometry3d pose = model.pose * *in_model;
    if (type == "fixed" || type == "ball") {
      add(joint, name, type == "fixed" ? JointType::fixed : JointType::spherical, from, to, pose);
    } else if (type == "revolute" || type == "continuous" || type == "prismatic") {
      const std::vector<SdfAxis> axes = read_axes(joint, 1);
      if (!axes.empty())
        add(joint, name, type == "prismatic" ? JointType::prismatic : JointType::revolute, from, to, pose, axes[0]);
    } else if (type == "universal" || type == "revolute2") {
      const std::vector<SdfAxis> axes = read_axes(joint, 2);
      if (axes.empty()) return;
      const int between = add_between(name + "_cross", pose);
      add(joint, name, JointType::revolute, from, between, pose, axes[0]);
      add(joint, name + "_2", JointType::revolute, between, to, pose, axes[1]);
    } else if (type == "screw") {
      read_screw(joint, name, from, to, pose);
    } else if (type != "gearbox") {
      problem(reading, joint.spot, fmt::format("unknown joint type {}", quoted_text(type)),
              "known: revolute, continuous, prismatic, fixed, ball, universal, revolute2, screw, gearbox");
    }
  }

  void read_screw(const Element& joint, const std::string& name, int from, int to, const Isometry3d& pose) {
    const std::vector<SdfAxis> axes = read_axes(joint, 1);
    if (axes.empty()) return;
    const double lead = lead_of(joint);
    const int between = add_between(name + "_nut", pose);
    const int turn = add(joint, name, JointType::revolute, from, between, pose, axes[0]);
    const int slide =
        add(joint, name + "_slide", JointType::prismatic, between, to, pose, {nullptr, axes[0].direction});
    couple(name, {{1, slide}, {-lead, turn}});
  }

  /// A linear relation between coordinates.
  void couple(const std::string& name, const std::vector<std::pair<double, int>>& terms) {
    std::vector<Term> sum;
    for (const auto& [factor, draft] : terms) {
      sum.push_back({factor, "z." + assembly.joints[static_cast<std::size_t>(draft)].name});
      coupled.push_back(draft);
    }
    assembly.couplings.push_back({unique_name(name, assembly.coupling_names), sum_text(sum)});
  }

  /// Angle between two bodies about a direction: its draft with the sign; nothing where no revolute joint has it.
  std::optional<std::pair<double, int>> angle_between(int from, int to, const Vector3d& direction) {
    for (std::size_t i = 0; i < assembly.joints.size(); ++i) {
      const JointDraft& draft = assembly.joints[i];
      const bool is_forward = draft.from == from && draft.to == to, is_back = draft.from == to && draft.to == from;
      const double along = draft.axis.dot(direction);
      if (draft.type != JointType::revolute || !(is_forward || is_back) || std::abs(along) < 1 - 1e-9) continue;
      return std::pair((along > 0) == is_forward ? 1.0 : -1.0, static_cast<int>(i));
    }
    return std::nullopt;
  }

  /// theta_2 = -ratio theta_1, the angles of parent and child against the reference body.
  void read_gearbox(const Element& joint) {
    const std::string name = text_of(joint, "name"), reference = inner_text(joint, "gearbox_reference_body");
    const std::vector<SdfAxis> axes = read_axes(joint, 2);
    if (axes.empty()) return;
    if (reference.empty())
      return problem(reading, joint.spot, fmt::format("gearbox {} has no <gearbox_reference_body>", quoted_text(name)));
    const int parent = body_of_frame(reading, model, inner_text(joint, "parent"), joint),
              below = body_of_frame(reading, model, inner_text(joint, "child"), joint),
              base = body_of_frame(reading, model, reference, joint);
    if (parent < 0 || below < 0 || base < 0) return;
    const auto first = angle_between(base, parent, axes[0].direction),
               second = angle_between(base, below, axes[1].direction);
    if (!first || !second) {
      note(reading, joint.spot,
           fmt::format("gearbox {} not carried over: revolute joints about its axes must connect {} with both links",
                       quoted_text(name), quoted_text(reference)));
      return;
    }
    const double ratio = inner_number(reading, joint, "gearbox_ratio", 1);
    if (ratio == 0)
      return problem(reading, joint.spot, fmt::format("gearbox {} has a ratio of zero", quoted_text(name)),
                     "the child turns by -<gearbox_ratio> times the angle of the parent");
    couple(name, {{second->first, second->second}, {ratio * first->first, first->second}});
  }

  /// position = multiplier (leader - reference) + offset
  void read_mimic(const Element& joint, const char* axis, const std::string& own) {
    const Element* inner = child(joint, axis);
    const Element* mimic = inner ? child(*inner, "mimic") : nullptr;
    if (!mimic) return;
    const std::string leader = text_of(*mimic, "joint") + (text_of(*mimic, "axis") == "axis2" ? "_2" : "");
    const auto follower = coordinates.find(own), found = coordinates.find(leader);
    const double multiplier = inner_number(reading, *mimic, "multiplier", 0);
    const double at_zero =
        inner_number(reading, *mimic, "offset", 0) - multiplier * inner_number(reading, *mimic, "reference", 0);
    if (follower == coordinates.end() || found == coordinates.end())
      return problem(reading, mimic->spot,
                     fmt::format("joint {} follows {}, which has no such coordinate", quoted_text(own),
                                 quoted_text(text_of(*mimic, "joint"))));
    if (std::abs(at_zero) > 1e-9)
      return note(reading, mimic->spot,
                  fmt::format("joint {} does not follow {}: it would stand at {:.6g} where all joints are at zero",
                              quoted_text(own), quoted_text(leader), at_zero));
    couple(own, {{1, follower->second.draft}, {-multiplier, found->second.draft}});
  }
};

/// Bodies in groups that joints of the tree connect.
struct Groups {
  std::vector<int> parent;
  explicit Groups(std::size_t size) : parent(size) { std::iota(parent.begin(), parent.end(), 0); }
  int of(int body) {
    while (parent[static_cast<std::size_t>(body)] != body) body = parent[static_cast<std::size_t>(body)];
    return body;
  }
  bool join(int a, int b) {
    const int one = of(a), other = of(b);
    parent[static_cast<std::size_t>(one)] = other;
    return one != other;
  }
};

/// Chooses the joints that close loops: those without forces on their coordinates, of these with the fewest equations.
void cut_loops(Reading& reading, const std::vector<int>& coupled, const Element& model, Assembly& assembly,
               Groups& groups) {
  std::set<std::string> with_forces;
  for (const SpringDraft& spring : assembly.springs) with_forces.insert(spring.coordinate);
  for (const FrictionDraft& friction : assembly.frictions) with_forces.insert(friction.coordinate);
  for (const StopDraft& stop : assembly.stops) with_forces.insert(stop.coordinate);
  const auto rank = [&](int index) {
    const JointDraft& joint = assembly.joints[static_cast<std::size_t>(index)];
    if (std::ranges::count(coupled, index) > 0) return 0;
    if (joint.type == JointType::fixed) return 1;
    if (with_forces.contains(joint.name)) return 2;
    return joint.type == JointType::spherical ? 4 : 3;
  };
  std::vector<int> order(assembly.joints.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, rank);
  for (const int index : order) {
    JointDraft& joint = assembly.joints[static_cast<std::size_t>(index)];
    if (groups.join(joint.from, joint.to)) continue;
    joint.cut = true;
    const auto is_of_joint = [&](const auto& force) { return force.coordinate == joint.name; };
    const std::size_t lost = std::erase_if(assembly.springs, is_of_joint) +
                             std::erase_if(assembly.frictions, is_of_joint) +
                             std::erase_if(assembly.stops, is_of_joint);
    if (lost > 0)
      note(reading, model.spot,
           fmt::format("forces and stops of joint {} are not carried over: it closes a loop", quoted_text(joint.name)));
    if (rank(index) == 0)
      problem(reading, model.spot,
              fmt::format("joint {} closes a loop, and a coupling needs its coordinate", quoted_text(joint.name)));
  }
}

/// Holds the bodies that hang on nothing: by a free joint, or fixed in a static model.
void hold_roots(Reading& reading, const SdfModel& model, Assembly& assembly, Groups& groups) {
  const bool is_static = inner_truth(reading, *model.element, "static");
  for (std::size_t i = 1; i < assembly.bodies.size(); ++i) {
    const int body = static_cast<int>(i);
    if (!groups.join(body, kGroundDraft)) continue;
    assembly.joints.push_back({.name = unique_joint_name(assembly, is_static ? "fixed_base" : "floating_base"),
                               .type = is_static ? JointType::fixed : JointType::free,
                               .to = body});
    if (is_static) continue;
    note(reading, model.element->spot,
         fmt::format("link {} moves freely: no joint holds it to the world", quoted_text(assembly.bodies[i].name)),
         "a fixed joint with <parent>world</parent> holds it");
  }
}

}  // namespace

void add_sdf_joints(Reading& reading, const SdfModel& model, Assembly& assembly) {
  JointReader reader{reading, model, assembly, {}, {}};
  for (const Element* joint : model.joints) reader.read(*joint);
  for (const Element* joint : model.joints) {
    if (text_of(*joint, "type") == "gearbox") reader.read_gearbox(*joint);
    reader.read_mimic(*joint, "axis", text_of(*joint, "name"));
    reader.read_mimic(*joint, "axis2", text_of(*joint, "name") + "_2");
  }
  if (!reading.problems.empty()) return;
  Groups groups(assembly.bodies.size());
  cut_loops(reading, reader.coupled, *model.element, assembly, groups);
  hold_roots(reading, model, assembly, groups);
  if (reader.limit_count == 0) return;
  const bool stops = reading.request.stop_stiffness > 0;
  note(reading, reader.first_limit->spot,
       fmt::format("<limit>{} not carried over: {}",
                   reader.limit_count > 1 ? fmt::format(" ({} of them)", reader.limit_count) : "",
                   stops ? "ranges of joints become stops, efforts and velocities stand beside the joints as comments"
                         : "limits are not enforced, they stand beside the joints as comments"),
       stops ? "" : "--stops STIFFNESS makes stops of the ranges");
}

}  // namespace mbgen::importing
