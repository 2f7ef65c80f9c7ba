// Springs and dampers between two points.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

template <>
std::span<const Field<PointSpring>> fields<PointSpring>();

namespace {

constexpr std::array<std::string_view, 2> kPointSpringLocals = {"length", "rate"};

void read_springs(Reader& reader, const Entries& entries) {
  read_list(reader, entries, reader.model.springs, [](Reader& r, const Value& value, const PointSpring& spring) {
    check_ends(r, value, spring.from, spring.to);
    if (!has_any(value, {"stiffness", "damping", "preload", "force"})) {
      report(r, value, "spring has no stiffness, damping, preload or force");
    }
  });
}

std::string trouble_of_spring(const Model& model, std::size_t index) {
  const PointSpring& spring = model.springs[index];
  if (spring.force) return kByExpression;
  return look_at_motion(model, spring.stiffness, spring.preload, spring.free_length) ? kByMotion : "";
}

/// Notes springs with a length at zero force far from their length: probably a free length in millimetres, or a preload
/// over a stiffness in N/mm.
void note_springs(Reader& reader) {
  constexpr double kFactor = 50;  // of the reference length; springs of machines stretch by less than five
  for (const PointSpring& spring : reader.model.springs) {
    if (spring.from.body < 0 || spring.to.body < 0 || spring.from.point < 0 || spring.to.point < 0) continue;
    const Vector3 from = reference_position(reader.model, spring.from),
                  to = reference_position(reader.model, spring.to);
    const double length = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    const auto* stiffness = spring.stiffness ? std::get_if<Quantity>(&*spring.stiffness) : nullptr;
    const std::string name = in_quotes(spring.name);
    if (!(length > 0)) continue;  // coinciding ends have their own note
    const double free = spring.free_length ? spring.free_length->value : 0;
    if (free > kFactor * length) {
      note_at(reader, spring.where,
              fmt::format("\"free_length\" of spring {} is {:.4g} m, its length at the reference {:.4g} m", name, free,
                          length),
              "lengths are in m");
    } else if (stiffness && stiffness->value > 0 &&
               std::abs(spring.preload.value) > kFactor * length * stiffness->value) {
      note_at(reader, spring.where,
              fmt::format("spring {} has {:.4g} N of preload over {:.4g} N/m: it is without force {:.4g} m from its "
                          "length at the reference, {:.4g} m",
                          name, std::abs(spring.preload.value), stiffness->value,
                          std::abs(spring.preload.value) / stiffness->value, length),
              "stiffness is in N/m");
    }
  }
}

}  // namespace

template <>
std::span<const Field<PointSpring>> fields<PointSpring>() {
  using S = PointSpring;
  static const std::array table = {
      field<S, &S::from>(element_end("from", "one end")),
      field<S, &S::to>(element_end("to", "other end, on another body")),
      field<S, &S::stiffness>({.name = "stiffness",
                               .shape = Shape::law,
                               .doc = "stiffness, or a table of N over the extension (length minus free_length, m)",
                               .unit = "N/m",
                               .bound = Bound::not_negative}),
      field<S, &S::damping>({.name = "damping",
                             .shape = Shape::law,
                             .doc = "damping, or a table of N over the rate of length (m/s)",
                             .unit = "N s/m",
                             .bound = Bound::not_negative}),
      field<S, &S::free_length>({.name = "free_length",
                                 .doc = "length without spring force; default: the distance at the reference",
                                 .unit = "m",
                                 .bound = Bound::not_negative}),
      field<S, &S::preload>({.name = "preload", .doc = "force added, tension positive", .unit = "N", .fallback = 0}),
      field<S, &S::force>({.name = "force",
                           .shape = Shape::force,
                           .doc = "force added, tension positive, over `length` (m) and `rate` (m/s)",
                           .unit = "N",
                           .locals = kPointSpringLocals}),
  };
  return table;
}

ElementSection section_of(Leader<PointSpring>) {
  return {
      "springs and dampers between two points",
      [] { return std::vector<ObjectKind>{kind_of<PointSpring>("spring", "spring and damper between two points")}; },
      read_springs, trouble_of_spring, note_springs};
}

}  // namespace mbgen::reading
