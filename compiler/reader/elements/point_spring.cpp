// Springs and dampers between two points.
#include <array>

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

}  // namespace

template <>
std::span<const Field<PointSpring>> fields<PointSpring>() {
  using S = PointSpring;
  static const std::array table = {
      field<S, &S::from>(element_end("from", "one end")),
      field<S, &S::to>(element_end("to", "other end, on another body")),
      field<S, &S::stiffness>({.name = "stiffness",
                               .shape = Shape::law,
                               .doc = "stiffness, or a table of N over the extension (length less free_length, m)",
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

template <>
ElementSection section_of<PointSpring>() {
  return {
      "springs and dampers between two points",
      [] { return std::vector<ObjectKind>{kind_of<PointSpring>("spring", "spring and damper between two points")}; },
      read_springs, trouble_of_spring};
}

}  // namespace mbgen::reading
