// Generalised forces on coordinates.
#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

template <>
std::span<const Field<JointForce>> fields<JointForce>();

namespace {

void read_joint_forces(Reader& reader, const Entries& entries) {
  read_list(reader, entries, reader.model.joint_forces, [](Reader& r, const Value& value, const JointForce& force) {
    refuse_reversed(r, member_or_object(value, "joint").place, force.joint);
  });
}

}  // namespace

template <>
std::span<const Field<JointForce>> fields<JointForce>() {
  using S = JointForce;
  static const std::array table = {
      field<S, &S::joint>(element_coordinate("joint", "coordinate it acts on", Need::required)),
      field<S, &S::force>({.name = "force", .doc = "generalised force", .unit = "N m or N", .need = Need::required}),
  };
  return table;
}

ElementSection section_of(Leader<JointForce>) {
  return {
      "generalised forces on coordinates",
      [] { return std::vector<ObjectKind>{kind_of<JointForce>("joint_force", "generalised force on a coordinate")}; },
      read_joint_forces};
}

}  // namespace mbgen::reading
