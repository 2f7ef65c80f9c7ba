// Springs and dampers on coordinates.
#include <fmt/format.h>

#include <array>

#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

template <>
std::span<const Field<JointSpring>> fields<JointSpring>();

namespace {

constexpr std::array<std::string_view, 2> kJointSpringLocals = {"position", "rate"};

/// Degrees are for rotations.
void check_degrees(Reader& reader, const Value& value, std::string_view key, const CoordinateReference& coordinate) {
  const Value* member = find(value, key);
  if (coordinate.joint < 0 || !member || member->kind != Value::Kind::object || is_rotation(reader.model, coordinate))
    return;
  report(reader, *member,
         fmt::format("coordinate {} is a translation, degrees have no meaning",
                     in_quotes(coordinate_name(reader.model, coordinate))));
}

}  // namespace

void check_coordinate_pair(Reader& reader, const Value& value, std::string_view element,
                           const CoordinateReference& joint, const CoordinateReference& relative_to) {
  refuse_reversed(reader, member_or_object(value, "relative_to").place, relative_to);
  if (joint.joint < 0 || relative_to.joint < 0) return;
  const std::string name = in_quotes(coordinate_name(reader.model, joint));
  if (joint == relative_to) {
    report(reader, *find(value, "relative_to"), fmt::format("{} is between coordinate {} and itself", element, name));
  } else if (is_rotation(reader.model, joint) != is_rotation(reader.model, relative_to)) {
    report(reader, *find(value, "relative_to"),
           fmt::format("{} is between a rotation and a translation, {} and {}", element, name,
                       in_quotes(coordinate_name(reader.model, relative_to))));
  }
}

namespace {

void read_joint_springs(Reader& reader, const Entries& entries) {
  for (const Entry& entry : entries)
    names_of<JointSpring>(reader).emplace(entry.name, static_cast<int>(names_of<JointSpring>(reader).size()));
  read_list(reader, entries, reader.model.joint_springs, [](Reader& r, const Value& value, const JointSpring& spring) {
    if (!has_any(value, {"stiffness", "damping", "preload", "force"})) {
      report(r, value, "spring has no stiffness, damping, preload or force");
    }
    check_degrees(r, value, "free", spring.joint);
    refuse_reversed(r, member_or_object(value, "joint").place, spring.joint);
    if (spring.relative_to) check_coordinate_pair(r, value, "spring", spring.joint, *spring.relative_to);
  });
}

std::string trouble_of_joint_spring(const Model& model, std::size_t index) {
  const JointSpring& spring = model.joint_springs[index];
  if (spring.force) return kByExpression;
  return look_at_motion(model, spring.stiffness, spring.preload, spring.free) ? kByMotion : "";
}

void note_joint_springs(Reader& reader) {
  for (const JointSpring& spring : reader.model.joint_springs)
    if (spring.free.expression < 0)
      note_angle(reader, spring.where, fmt::format("\"free\" of {}", in_quotes(spring.name)), spring.joint,
                 spring.free.value);
}

}  // namespace

template <>
std::span<const Field<JointSpring>> fields<JointSpring>() {
  using S = JointSpring;
  static const std::array table = {
      field<S, &S::joint>(element_coordinate("joint", "coordinate it acts on", Need::required)),
      field<S, &S::relative_to>(
          element_coordinate("relative_to", "coordinate that is subtracted (anti-roll bar)", Need::optional)),
      field<S, &S::stiffness>({.name = "stiffness",
                               .shape = Shape::law,
                               .doc = "stiffness, or a table over the displacement from free",
                               .unit = "N m/rad or N/m",
                               .bound = Bound::not_negative}),
      field<S, &S::damping>({.name = "damping",
                             .shape = Shape::law,
                             .doc = "damping, or a table over the rate",
                             .unit = "N m s/rad or N s/m",
                             .bound = Bound::not_negative}),
      field<S, &S::free>({.name = "free",
                          .doc = "displacement without spring force",
                          .unit = "rad or m",
                          .fallback = 0,
                          .angle = true}),
      field<S, &S::preload>(
          {.name = "preload", .doc = "force added, against the coordinate", .unit = "N m or N", .fallback = 0}),
      field<S, &S::force>({.name = "force",
                           .shape = Shape::force,
                           .doc = "force added, against the coordinate, over `position` and `rate`",
                           .unit = "N m or N",
                           .locals = kJointSpringLocals}),
  };
  return table;
}

template <>
ElementSection section_of<JointSpring>() {
  return {"springs and dampers on coordinates",
          [] {
            return std::vector<ObjectKind>{
                kind_of<JointSpring>("joint_spring", "spring and damper on a coordinate or a difference of two")};
          },
          read_joint_springs, trouble_of_joint_spring, note_joint_springs};
}

}  // namespace mbgen::reading
