// Joints: axes, freedoms, closure at the reference configuration.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/reader/positions.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr double kClosureTolerance = 1e-6;  ///< m: rounding of a hardpoint table in micrometres
constexpr double kAngleTolerance = 1e-6;    ///< rad
constexpr double kLeastLean = 1e-3;         ///< sine of the angle of an axle or blade to the normal of its plane
constexpr std::string_view kLetters = "xyz";

bool has_axis(JointType type) {
  return type == JointType::revolute || type == JointType::prismatic || type == JointType::cylindrical ||
         type == JointType::universal || type == JointType::planar || type == JointType::point_on_line ||
         type == JointType::point_on_plane || type == JointType::parallel_axes || type == JointType::homokinetic ||
         holds_velocities(type);
}

bool has_radius(JointType type) { return type == JointType::rolling_disc || type == JointType::rolling_ball; }

/// Whether the axis of `to` equals the axis of `from` in all positions.
bool shares_axis(JointType type) {
  return type == JointType::revolute || type == JointType::prismatic || type == JointType::cylindrical ||
         type == JointType::planar || type == JointType::parallel_axes;
}

/// Index of the frame axis along a direction, or -1 for a skew one.
int letter_index(const Vector3& direction) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(direction[static_cast<std::size_t>(i)]) == 1) return i;
  }
  return -1;
}

Vector3 unit(int index) { return {index == 0 ? 1.0 : 0.0, index == 1 ? 1.0 : 0.0, index == 2 ? 1.0 : 0.0}; }

/// A freedom with its axis still in the frame of `from`.
Freedom freedom(const std::string& joint, FreedomKind kind, std::string_view suffix, const Vector3& axis) {
  const std::string prefix = suffix.empty() ? "" : kind == FreedomKind::revolute ? "_r" : "_t";
  return {joint + prefix + std::string(suffix), kind, axis};
}

void add_planar(std::vector<Freedom>& freedoms, const std::string& name, const Vector3& normal) {
  const int letter = letter_index(normal);
  if (letter >= 0) {
    for (int next = 1; next <= 2; ++next) {
      const int index = (letter + next) % 3;
      freedoms.push_back(
          freedom(name, FreedomKind::prismatic, kLetters.substr(static_cast<std::size_t>(index), 1), unit(index)));
    }
    freedoms.push_back(
        freedom(name, FreedomKind::revolute, kLetters.substr(static_cast<std::size_t>(letter), 1), normal));
    return;
  }
  // The frame axis with the largest angle to the normal, made perpendicular to it.
  const auto smallest =
      std::min_element(normal.begin(), normal.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  Vector3 second = cross(normal, unit(static_cast<int>(smallest - normal.begin())));
  const double length = norm(second);
  for (double& component : second) component /= length;
  freedoms.push_back(freedom(name, FreedomKind::prismatic, "1", cross(second, normal)));
  freedoms.push_back(freedom(name, FreedomKind::prismatic, "2", second));
  freedoms.push_back(freedom(name, FreedomKind::revolute, "z", normal));
}

/// Freedoms in their order in the joint, axes in the frame of `from`. Requires: axes and sequence were read.
std::vector<Freedom> freedoms_of(const JointFields& joint) {
  const std::string& name = joint.name;
  const Vector3 axis = joint.written_axis.value_or(Vector3{}), axis2 = joint.axis2.value_or(Vector3{});
  const int letter = letter_index(axis), letter2 = letter_index(axis2);
  const auto suffix = [&](int index, std::string_view skew) {
    return index < 0 ? skew : kLetters.substr(static_cast<std::size_t>(index), 1);
  };
  std::vector<Freedom> freedoms;
  switch (joint.type) {
    case JointType::revolute:
      freedoms = {freedom(name, FreedomKind::revolute, "", axis)};
      break;
    case JointType::prismatic:
      freedoms = {freedom(name, FreedomKind::prismatic, "", axis)};
      break;
    case JointType::cylindrical:
      freedoms = {freedom(name, FreedomKind::prismatic, suffix(letter, "z"), axis),
                  freedom(name, FreedomKind::revolute, suffix(letter, "z"), axis)};
      break;
    case JointType::universal: {
      const bool skew = letter < 0 || letter2 < 0;
      freedoms = {freedom(name, FreedomKind::revolute, skew ? "1" : suffix(letter, ""), axis),
                  freedom(name, FreedomKind::revolute, skew ? "2" : suffix(letter2, ""), axis2)};
      break;
    }
    case JointType::planar:
      add_planar(freedoms, name, axis);
      break;
    case JointType::free:
      for (int i = 0; i < 3; ++i) freedoms.push_back(freedom(name, FreedomKind::prismatic, suffix(i, ""), unit(i)));
      [[fallthrough]];
    case JointType::spherical:
      for (const char c : joint.sequence) {
        const int index = static_cast<int>(kLetters.find(c));
        freedoms.push_back(freedom(name, FreedomKind::revolute, suffix(index, ""), unit(index)));
      }
      break;
    case JointType::fixed:
    case JointType::point_on_line:
    case JointType::point_on_plane:
    case JointType::parallel_axes:
    case JointType::orientation:
    case JointType::homokinetic:
    case JointType::rolling_disc:
    case JointType::rolling_ball:
    case JointType::knife_edge:
      break;
  }
  return freedoms;
}

/// Reports missing axes, and axes that the type does not have. Result: whether the freedoms can be named.
bool check_fields(Reader& reader, const Value& value, const JointFields& joint) {
  const std::string type = find(value, "type")->text;
  const char* article = type == "orientation" ? "an" : "a";
  bool complete = true;
  const auto need = [&](const char* key, bool needed) {
    const Member* member = find_member(value, key);
    if (needed && !member) {
      report(reader, value, fmt::format("{} {} joint needs {}", article, type, in_quotes(key)));
      complete = false;
    } else if (!needed && member) {
      report(reader, member->place, fmt::format("{} {} joint takes no {}", article, type, in_quotes(key)));
    }
  };
  need("axis", has_axis(joint.type));
  if (joint.type != JointType::homokinetic) need("axis2", has_second_axis(joint.type));
  if (!has_radius(joint.type)) need("radius", false);
  if (!shares_axis(joint.type)) need("axis_to", false);
  if (!is_ball(joint.type)) need("sequence", false);
  if (closes_only(joint.type) && joint.marked_cut == false) {
    report(reader, *find(value, "cut"),
           fmt::format("{} {} joint has no coordinates and always closes a loop", article, type), "leave out \"cut\"");
  }
  const auto spoiled = [](const std::optional<Vector3>& axis) { return axis && std::isnan((*axis)[0]); };
  const bool named_by_axis = joint.type != JointType::revolute && joint.type != JointType::prismatic;
  if (named_by_axis && (spoiled(joint.written_axis) || spoiled(joint.axis2))) complete = false;
  return complete;
}

bool check_sequence(Reader& reader, const Value& value, const JointFields& joint) {
  if (!is_ball(joint.type)) return true;
  std::string sorted = joint.sequence;
  std::sort(sorted.begin(), sorted.end());
  if (sorted == kLetters) return true;
  report(reader, member_or_object(value, "sequence"),
         "sequence must have x, y and z once each, got " + in_quotes(joint.sequence));
  return false;
}

/// angle: of the axle or blade to the normal of the plane, rad.
void check_axis_on_plane(Reader& reader, const Value& value, const JointFields& joint, double angle) {
  if (std::sin(angle) >= kLeastLean) return;
  const bool is_disc = joint.type == JointType::rolling_disc;
  report(reader, *find(value, "axis2"),
         fmt::format("{} stands on the plane at right angles: {}", is_disc ? "the axle of the disc" : "the blade",
                     is_disc ? "a disc that lies flat has no point of contact" : "it has no direction across"),
         is_disc ? "\"axis\" is the normal of the plane, \"axis2\" the axle: tilt one, or place the body on its rim"
                 : "\"axis\" is the normal of the plane, \"axis2\" the line of the blade");
}

void check_axes(Reader& reader, const Value& value, const JointFields& joint) {
  if (joint.written_axis && joint.axis2) {
    const double angle = angle_between(*joint.written_axis, *joint.axis2);
    if (holds_velocities(joint.type)) {
      check_axis_on_plane(reader, value, joint, angle);
    } else if (joint.type == JointType::homokinetic) {
      if (angle > std::numbers::pi / 2 - kAngleTolerance) {
        report(reader, *find(value, "axis2"),
               fmt::format("shafts of a homokinetic joint must bend by less than 90 deg, the angle is {:.6g} deg",
                           angle * 180 / std::numbers::pi),
               "both axes point the same way through the joint: reverse one of them");
      }
    } else if (std::abs(angle - std::numbers::pi / 2) > kAngleTolerance) {
      report(reader, *find(value, "axis2"),
             fmt::format("axes of a universal joint must be perpendicular, the angle is {:.6g} deg",
                         angle * 180 / std::numbers::pi));
    }
  }
  if (!joint.written_axis || !joint.axis_to) return;
  const double angle = angle_between(placed_axis(reader, joint.from.body, *joint.written_axis, FreedomKind::prismatic),
                                     placed_axis(reader, joint.to.body, *joint.axis_to, FreedomKind::prismatic));
  if (angle > kAngleTolerance) {
    const bool opposite = angle > std::numbers::pi - kAngleTolerance;
    report(reader, *find(value, "axis_to"),
           fmt::format("axes do not agree at the reference, the angle is {:.6g} rad", angle),
           opposite ? "reverse one of the axes" : "");
  }
}

/// gap: from the point of `from` to the point of `to` at the reference, m.
void check_place(Reader& reader, const Value& value, const JointFields& joint, const Vector3& gap) {
  const Vector3 axis = placed_axis(reader, joint.from.body, *joint.written_axis, FreedomKind::prismatic);
  const bool is_line = joint.type == JointType::point_on_line;
  const double off = is_line ? norm(cross(gap, axis)) : std::abs(dot(gap, axis));
  if (off <= kClosureTolerance || std::isnan(off)) return;  // NaN has been reported
  report(reader, *find(value, "to"),
         fmt::format("joint does not close at the reference, {} is {:.6g} m off the {}",
                     attachment_text(reader.model, joint.to), off, is_line ? "line" : "plane"),
         fmt::format("the {} goes through {}: move one of the points, or turn \"axis\"",
                     is_line ? "line along \"axis\"" : "plane across \"axis\"",
                     attachment_text(reader.model, joint.from)));
}

/// Checks that the rim of a disc, or a ball, touches the plane at the reference; sets a missing radius from this. gap:
/// from the point of `from` to the centre, m.
void set_radius(Reader& reader, const Value& value, JointFields& joint, const Vector3& gap) {
  const bool is_disc = joint.type == JointType::rolling_disc;
  if (!joint.written_axis || (is_disc && !joint.axis2)) return;
  const Vector3 normal = placed_axis(reader, joint.from.body, *joint.written_axis, FreedomKind::prismatic);
  const double lean = is_disc ? std::sin(angle_between(*joint.written_axis, *joint.axis2)) : 1.0;
  const double height = dot(gap, normal);
  if (std::isnan(height) || std::isnan(lean) || lean < kLeastLean) return;  // these have their messages
  const char* what = is_disc ? "disc" : "ball";
  if (height < -kClosureTolerance) {
    report(reader, *find(value, "axis"),
           fmt::format("the {} is behind the plane: its centre {} is {:.6g} m on the other side of the normal", what,
                       attachment_text(reader.model, joint.to), -height),
           "\"axis\" is the normal of the plane to the side of the " + std::string(what) + ": reverse it");
    return;
  }
  if (!joint.radius) {
    if (height > kClosureTolerance)
      joint.radius = Quantity{height / lean};
    else
      report(reader, *find(value, "to"), fmt::format("the centre of the {} lies in the plane", what),
             "place the body where it touches the plane by its rim or surface, or give \"radius\"");
    return;
  }
  const double above = height - joint.radius->value * lean;
  if (std::abs(above) <= kClosureTolerance || std::isnan(above)) return;
  report(reader, *find(value, "to"),
         fmt::format("joint does not close at the reference: the {} of radius {:.6g} m is {:.6g} m {} the plane", what,
                     joint.radius->value, std::abs(above), above > 0 ? "above" : "below"),
         "move the body or the plane, or leave out \"radius\", which then follows from them");
}

void check_closure(Reader& reader, const Value& value, JointFields& joint) {
  if (joint.from.body < 0 || joint.to.body < 0) return;
  if (joint.from.body == joint.to.body) {
    report(reader, *find(value, "to"),
           "both ends are on body " + in_quotes(reader.model.bodies[static_cast<std::size_t>(joint.to.body)].name));
    return;
  }
  if (joint.type == JointType::parallel_axes || joint.type == JointType::orientation) return;
  if (joint.type == JointType::knife_edge) return;
  const Vector3 a = reference_position(reader.model, joint.from), b = reference_position(reader.model, joint.to);
  const Vector3 gap{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  if (joint.type == JointType::point_on_line || joint.type == JointType::point_on_plane) {
    if (joint.written_axis) check_place(reader, value, joint, gap);
    return;
  }
  if (has_radius(joint.type)) return set_radius(reader, value, joint, gap);
  const double distance = std::hypot(gap[0], gap[1], gap[2]);
  if (distance > kClosureTolerance) {
    report(reader, *find(value, "to"),
           fmt::format("joint does not close at the reference, {} and {} are {:.6g} m apart",
                       attachment_text(reader.model, joint.from), attachment_text(reader.model, joint.to), distance),
           "both points are at one place at the reference, where all coordinates are zero: move one, or give a body a "
           "point there");
  }
}

/// Axes by points are read in the axes of the scope and transformed to the frame of a body, like others.
void turn_axes_by_points(const Reader& reader, const Value& value, JointFields& joint) {
  if (joint.written_axis) turn_axis_by_points(reader, find(value, "axis"), joint.from.body, *joint.written_axis);
  if (joint.axis_to) turn_axis_by_points(reader, find(value, "axis_to"), joint.to.body, *joint.axis_to);
  if (joint.axis2) turn_axis_by_points(reader, find(value, "axis2"), joint.from.body, *joint.axis2);
}

/// Transforms the axes to global ones.
void resolve_axes(Reader& reader, JointFields& joint, int index) {
  const auto kind = joint.type == JointType::prismatic || joint.type == JointType::cylindrical ||
                            joint.type == JointType::planar || closes_only(joint.type)
                        ? FreedomKind::prismatic
                        : FreedomKind::revolute;
  const auto global = [&](const Vector3& axis, FreedomKind of) {
    return placed_axis(reader, joint.from.body, axis, of);
  };
  if (joint.written_axis) joint.axis = global(*joint.written_axis, kind);
  // Axle of a rolling body: mirrored wheels have the same sense of forward rolling.
  if (joint.axis2)
    joint.second_axis = global(*joint.axis2, joint.type == JointType::rolling_disc ? FreedomKind::revolute : kind);
  if (joint.type == JointType::homokinetic) {
    if (!joint.axis2) joint.second_axis = joint.axis;
    // A mirrored instance may reverse one of two shafts.
    if (dot(joint.axis, joint.second_axis) < 0)
      for (double& component : joint.second_axis) component = -component;
  }
  for (std::size_t i = 0; i < joint.freedoms.size(); ++i) {
    Freedom& freedom = joint.freedoms[i];
    if (is_reversed(reader, freedom.axis, freedom.kind)) reader.names.reversed.push_back({index, static_cast<int>(i)});
    freedom.axis = global(freedom.axis, freedom.kind);
  }
}

/// Adds the names of a joint's coordinates to its scope and the enclosing scopes.
void name_coordinates(Reader& reader, const Entry& entry, const Joint& joint, int index) {
  const Visibility& visible = reader.scopes[entry.scope].visible;
  const Level& own = visible.front();
  for (const Level& level : visible) {
    const std::string before = own.before.substr(level.before.size());
    const std::string after = own.after.substr(0, own.after.size() - level.after.size());
    for (std::size_t i = 0; i < joint.freedoms.size(); ++i) {
      const std::string freedom = joint.freedoms[i].name.substr(joint.name.size());
      reader.names.coordinates[level.scope].emplace(before + entry.written + after + freedom,
                                                    CoordinateReference{index, static_cast<int>(i)});
    }
  }
}

void check_coordinates(Reader& reader, const Entry& entry, const Joint& joint) {
  for (std::size_t i = 0; i < joint.freedoms.size(); ++i) {
    const std::string& name = joint.freedoms[i].name;
    const auto found = reader.names.coordinates[0].find(name);
    if (found == reader.names.coordinates[0].end()) continue;
    const Joint& other = reader.model.joints[static_cast<std::size_t>(found->second.joint)];
    report(reader, entry.place,
           fmt::format("coordinate {} is also one of joint {}", in_quotes(name), in_quotes(other.name)),
           "rename one of the joints");
  }
}

}  // namespace

void add_coordinates(Reader& reader, const Entry& entry, const Joint& joint, int index) {
  check_coordinates(reader, entry, joint);
  name_coordinates(reader, entry, joint, index);
}

void read_joints(Reader& reader, const Entries& entries) {
  for (const Entry& entry : entries) {
    const InScope in_scope(reader, entry.scope);
    const Value& value = *entry.value;
    JointFields joint = with_defaults<JointFields>();
    joint.name = entry.name;
    joint.where = where_of(reader.documents, entry.place);
    const bool readable = read_fields(reader, value, joint);
    turn_axes_by_points(reader, value, joint);
    bool named = joint.written_type.has_value();
    if (named) {
      joint.type = *joint.written_type;
      named = check_fields(reader, value, joint);
      named = check_sequence(reader, value, joint) && named;
      check_axes(reader, value, joint);
    }
    if (joint.written_type && !joint.written_axis && has_axis(joint.type)) joint.axis.fill(kUnreadable);
    if (readable) check_closure(reader, value, joint);
    if (joint.marked_cut) joint.cut = *joint.marked_cut ? CutMark::cut : CutMark::tree;
    const int index = static_cast<int>(reader.model.joints.size());
    if (named) {
      joint.freedoms = freedoms_of(joint);
      resolve_axes(reader, joint, index);
      add_coordinates(reader, entry, joint, index);
    } else {
      reader.names.unreadable_joints.push_back(entry.name);
      if (entry.written != entry.name) reader.names.unreadable_joints.push_back(entry.written);
    }
    reader.names.joints.emplace(entry.name, index);
    reader.model.joints.push_back(joint);
  }
}

}  // namespace mbgen::reading
