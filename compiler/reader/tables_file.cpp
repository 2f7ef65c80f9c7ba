// Table of fields: the file with its sections, and the files that it includes.
#include <array>
#include <vector>

#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/included.hpp"
#include "compiler/reader/presentation.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

FieldInfo section(std::string_view name, std::string_view of, std::string_view doc) {
  return {.name = name, .shape = Shape::map, .doc = doc, .of = of};
}

template <class Kind>
Field<FileFields> section_row(KindOf<Kind> kind) {
  return field<FileFields, &SectionOf<Kind>::section>(section(kind.section, kind.key, section_of(Leader<Kind>()).doc));
}

template <class Fields>
Field<FileFields> section_row(Composition<Fields> composition) {
  const ComposedSection made = section_of(composition);
  return field<FileFields, &SectionOf<Fields>::section>(section(made.name, made.key, made.doc));
}

/// Sections before those of compositions.
std::vector<Field<FileFields>> first_sections() {
  using F = FileFields;
  return {
      field<F, &F::format>({.name = "mbgen",
                            .shape = Shape::number,
                            .doc = "version of the format, 1; may be absent in an included file"}),
      field<F, &F::name>({.name = "name", .shape = Shape::text, .doc = "name of the model; default: the file's name"}),
      field<F, &F::description>(prose_field("description", "of the model, for people")),
      field<F, &F::author>(prose_field("author", "who made the model")),
      field<F, &F::version>({.name = "version", .shape = Shape::text, .doc = "version of the model"}),
      field<F, &F::copyright>(prose_field("copyright", "of the model")),
      field<F, &F::licence>(prose_field("licence", "under which the model may be used")),
      field<F, &F::gravity>({.name = "gravity",
                             .shape = Shape::quantity_vector,
                             .doc = "gravity in global axes, default [0, 0, -9.81]",
                             .unit = "m/s^2",
                             .depends = Depends::parameters}),
      field<F, &F::include>({.name = "include",
                             .shape = Shape::paths,
                             .doc = "files of the same format whose content is merged in, relative to this file",
                             .of = "include"}),
      field<F, &F::parameters>({.name = "parameters",
                                .shape = Shape::parameters,
                                .doc = "named constants; tunable ones can be changed in the generated solver",
                                .of = "parameter"}),
      field<F, &F::inputs>(section("inputs", "input", "values given to the solver at every step")),
      field<F, &F::hardpoints>({.name = "hardpoints",
                                .shape = Shape::points,
                                .doc = "named positions, in global axes at the reference configuration; allowed for "
                                       "any position, and as points of any body",
                                .unit = "m",
                                .depends = Depends::parameters}),
      field<F, &F::tables>(section("tables", "named_table", "curves by points, for expressions: table('NAME', x)")),
      field<F, &F::maps>(section("maps", "map", "tables of two variables, for expressions: table('NAME', x, y)")),
      field<F, &F::bodies>(section("bodies", "body", "rigid bodies; \"ground\" is the fixed one")),
      field<F, &F::joints>(section("joints", "joint", "joints between bodies, tree or loop closing")),
      field<F, &F::rods>(section("rods", "rod", "bars with a spherical joint at each end")),
  };
}

/// Sections between those of compositions and those of elements.
std::vector<Field<FileFields>> middle_sections() {
  using F = FileFields;
  return {
      field<F, &F::states>(section("states", "state", "states of your own: their derivatives are expressions")),
      field<F, &F::sampled>(section("sampled", "sampled_value", "values set at instants: sampled controllers")),
      field<F, &F::values>({.name = "values",
                            .shape = Shape::overrides,
                            .doc = "expressions under a name, for use in several places, in any order"}),
      field<F, &F::sensors>(section("sensors", "sensor", "measured values: sampled, with the errors of a sensor")),
      field<F, &F::delays>(section("delays", "delay", "values as they were some time ago")),
      field<F, &F::couplings>(section("couplings", "coupling", "relations between coordinates: gears, racks, screws")),
  };
}

/// Sections after those of elements.
std::vector<Field<FileFields>> last_sections() {
  using F = FileFields;
  return {
      field<F, &F::roads>(
          section("roads", "road", "roads under tyres; without one a tyre is on a flat horizontal road")),
      field<F, &F::tyre_data>(section("tyre_data", "tyre_data", "coefficient sets of tyres")),
      field<F, &F::axles>(section("axles", "axle", "axles of a vehicle, for mbgen kc; without effect on the motion")),
      field<F, &F::vehicle>({.name = "vehicle",
                             .shape = Shape::object,
                             .doc = "the vehicle, for manoeuvres; without effect on the motion",
                             .of = "vehicle"}),
      field<F, &F::motions>(section("motions", "motion", "driven coordinates")),
      field<F, &F::outputs>(section("outputs", "output", "results to write at every step")),
      field<F, &F::shapes>(section("shapes", "shape", "shapes of bodies in pictures, without effect on the motion")),
      field<F, &F::initial>({.name = "initial", .shape = Shape::object, .doc = "initial state", .of = "initial"}),
      field<F, &F::solver>({.name = "solver", .shape = Shape::object, .doc = "time integration", .of = "solver"}),
      field<F, &F::instances>(section("instances", "instance", "subsystems: files that are placed in this one")),
  };
}

}  // namespace

template <>
std::span<const Field<FileFields>> fields<FileFields>() {
  static const std::vector<Field<FileFields>> table = [] {
    const auto middle = middle_sections(), last = last_sections();
    std::vector<Field<FileFields>> rows = first_sections();
    each_composition([&](auto composition) { rows.push_back(section_row(composition)); });
    rows.insert(rows.end(), middle.begin(), middle.end());
    each_section([&](auto kind) { rows.push_back(section_row(kind)); });
    rows.insert(rows.end(), last.begin(), last.end());
    return rows;
  }();
  return table;
}

template <>
std::span<const Field<IncludeFields>> fields<IncludeFields>() {
  using F = IncludeFields;
  static const std::array table = {
      field<F, &F::file>({.name = "file",
                          .shape = Shape::text,
                          .doc = "its path, relative to this file",
                          .need = Need::required,
                          .longest = 4096}),
      field<F, &F::remove>({.name = "remove",
                            .shape = Shape::paths,
                            .doc =
                                "JSON Pointers of items and sections that are left out, as \"/springs/front\"; in the "
                                "file and in all that it includes"}),
      field<F, &F::replace>({.name = "replace",
                             .shape = Shape::contents,
                             .doc = "JSON Pointers with the values that stand there instead of the file's"}),
  };
  return table;
}

}  // namespace mbgen::reading
