// Tables of fields: beams.
#include <array>

#include "compiler/reader/elements/beam.hpp"
#include "compiler/reader/elements/sections.hpp"

namespace mbgen::reading {
namespace {

FieldInfo size_of_section(std::string_view name, std::string_view doc, std::string_view unit = "m") {
  return {.name = name, .shape = Shape::number, .doc = doc, .unit = unit, .bound = Bound::positive};
}

FieldInfo object_of_beam(std::string_view name, std::string_view doc, std::string_view kind, Need need) {
  return {.name = name, .shape = Shape::object, .doc = doc, .need = need, .of = kind};
}

}  // namespace

template <>
std::span<const Field<BeamFields>> fields<BeamFields>() {
  using F = BeamFields;
  constexpr double kSegments = 8;
  static const std::array table = {
      field<F, &F::points>({.name = "points",
                            .shape = Shape::positions,
                            .doc = "names and positions along the beam, in order, at least two; the beam is straight "
                                   "between them",
                            .need = Need::required}),
      field<F, &F::section>(object_of_beam("section", "its cross-section", "beam_section", Need::required)),
      field<F, &F::material>(object_of_beam("material", "default: steel", "beam_material", Need::optional)),
      field<F, &F::segments>({.name = "segments",
                              .shape = Shape::number,
                              .doc = "number of all segments, at least one between two points",
                              .unit = "1",
                              .fallback = kSegments,
                              .bound = Bound::positive}),
      field<F, &F::up>(
          {.name = "up",
           .shape = Shape::vector,
           .doc = "direction of the section's axis z, as far as it is perpendicular to the beam; default z"}),
      field<F, &F::damping>({.name = "damping",
                             .shape = Shape::number,
                             .doc = "damping over stiffness: a mode of circular frequency w has the damping ratio "
                                    "w damping / 2",
                             .unit = "s",
                             .fallback = 0,
                             .bound = Bound::not_negative}),
      field<F, &F::supports>({.name = "supports",
                              .shape = Shape::map,
                              .doc = "points that are joined to bodies; the others move freely",
                              .of = "beam_support"}),
      field<F, &F::on>({.name = "on",
                        .shape = Shape::reference,
                        .doc = "body against which the first point of a beam without supports counts its coordinates; "
                               "default: ground",
                        .of = "bodies"}),
  };
  return table;
}

template <>
std::span<const Field<BeamSectionFields>> fields<BeamSectionFields>() {
  using F = BeamSectionFields;
  static const std::array table = {
      field<F, &F::shape>({.name = "shape",
                           .shape = Shape::word,
                           .doc = "of the section: round and tube (diameter), box (width along y, height along z), i "
                                  "(upright along z), or general (A, Iy, Iz, J)",
                           .need = Need::required,
                           .words = kBeamShapes}),
      field<F, &F::diameter>(size_of_section("diameter", "outer diameter")),
      field<F, &F::wall>(size_of_section("wall", "thickness of a tube's or box's wall; a box without it is solid")),
      field<F, &F::width>(size_of_section("width", "along its axis y")),
      field<F, &F::height>(size_of_section("height", "along its axis z, `up`")),
      field<F, &F::flange>(size_of_section("flange", "thickness of an i's flanges")),
      field<F, &F::web>(size_of_section("web", "thickness of an i's web")),
      field<F, &F::area>(size_of_section("A", "area", "m^2")),
      field<F, &F::iy>(size_of_section("Iy", "second moment about y: bending along z", "m^4")),
      field<F, &F::iz>(size_of_section("Iz", "second moment about z: bending along y", "m^4")),
      field<F, &F::j>(size_of_section("J", "torsion constant", "m^4")),
  };
  return table;
}

template <>
std::span<const Field<BeamMaterial>> fields<BeamMaterial>() {
  using F = BeamMaterial;
  constexpr double kYoungs = 210e9, kShear = 80.8e9, kSteel = 7850;
  const auto number = [](std::string_view name, std::string_view doc, std::string_view unit, double fallback) {
    return constant_info(name, doc, unit, fallback, Bound::positive, Depends::parameters);
  };
  static const std::array table = {
      field<F, &F::youngs_modulus>(number("E", "Young's modulus", "Pa", kYoungs)),
      field<F, &F::shear_modulus>(number("G", "shear modulus", "Pa", kShear)),
      field<F, &F::density>(number("density", "mass over volume", "kg/m^3", kSteel)),
  };
  return table;
}

template <>
std::span<const Field<BeamSupportFields>> fields<BeamSupportFields>() {
  using F = BeamSupportFields;
  static const std::array table = {
      field<F, &F::body>({.name = "body",
                          .shape = Shape::reference,
                          .doc = "body that the point is joined to",
                          .need = Need::required,
                          .of = "bodies"}),
      field<F, &F::type>({.name = "type",
                          .shape = Shape::word,
                          .doc = "welded, pinned (spherical), or hinge (revolute about `axis`)",
                          .fallback_word = "welded",
                          .words = kBeamSupports}),
      field<F, &F::axis>({.name = "axis", .shape = Shape::axis, .doc = "of a hinge"}),
  };
  return table;
}

ComposedSection section_of(Composition<BeamFields>) {
  return {"beams", "beam", "beams that bend and twist: bodies with elastic connections",
          [] {
            return std::vector<ObjectKind>{
                kind_of<BeamFields>("beam", "a beam through points, of segments that bend and twist"),
                kind_of<BeamSectionFields>("beam_section", "cross-section of a beam"),
                kind_of<BeamMaterial>("beam_material", "material of a beam"),
                kind_of<BeamSupportFields>("beam_support", "joint of a beam's point with a body")};
          },
          compose_beams};
}

}  // namespace mbgen::reading
