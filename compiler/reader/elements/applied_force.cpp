// Forces and torques on bodies.
#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

template <>
std::span<const Field<AppliedForce>> fields<AppliedForce>();

namespace {

void read_forces(Reader& reader, const Entries& entries) {
  read_list(reader, entries, reader.model.forces, [](Reader& r, const Value& value, AppliedForce& force) {
    if (!has_any(value, {"force", "torque"})) report(r, value, "applied force has neither \"force\" nor \"torque\"");
    if (force.at.body >= 0 && force.at.body == r.model.ground)
      report(r, *find(value, "at"), "a force on ground has no effect");
    place_force(r, force);
  });
}

}  // namespace

template <>
std::span<const Field<AppliedForce>> fields<AppliedForce>() {
  using S = AppliedForce;
  static const std::array table = {
      field<S, &S::at>(element_end("at", "point the force acts at")),
      field<S, &S::force>({.name = "force", .shape = Shape::quantity_vector, .doc = "force", .unit = "N"}),
      field<S, &S::torque>({.name = "torque", .shape = Shape::quantity_vector, .doc = "torque", .unit = "N m"}),
      field<S, &S::in_body_axes>({.name = "axes",
                                  .shape = Shape::word,
                                  .doc = "axes of the components",
                                  .fallback_word = "global",
                                  .words = kFrames}),
  };
  return table;
}

ElementSection section_of(Leader<AppliedForce>) {
  return {"forces and torques on bodies",
          [] { return std::vector<ObjectKind>{kind_of<AppliedForce>("force", "force and torque on a body")}; },
          read_forces};
}

}  // namespace mbgen::reading
