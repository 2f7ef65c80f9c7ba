// Table of fields: bump stops.
#include <array>

#include "compiler/reader/presentation.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr std::array<std::string_view, 2> kStopLocals = {"penetration", "rate"};
/// In the order of BumpStop::Side.
constexpr std::array<std::string_view, 4> kSides = {"compression", "extension", "above", "below"};

/// Where a stop is.
auto stop_place_fields() {
  using S = BumpStopFields;
  return std::array{
      field<S, &S::written_from>({.name = "from", .shape = Shape::attachment, .doc = "one end"}),
      field<S, &S::written_to>({.name = "to", .shape = Shape::attachment, .doc = "other end, on another body"}),
      field<S, &S::spring>({.name = "spring",
                            .shape = Shape::reference,
                            .doc = "spring or air spring whose ends are those of the stop",
                            .of = "springs"}),
      field<S, &S::written_joint>({.name = "joint",
                                   .shape = Shape::coordinate,
                                   .doc = "coordinate that the stop is on; zero at the reference"}),
      field<S, &S::written_axis>({.name = "axis",
                                  .shape = Shape::axis,
                                  .doc =
                                      "direction along which the way of `to` counts, in the frame of `from`; default: "
                                      "along the line between the points",
                                  .by_points = true}),
      field<S, &S::written_side>({.name = "side",
                                  .shape = Shape::word,
                                  .doc = "between points compression (default) or extension, with `axis` the way "
                                         "against it or along it; of a coordinate above or below",
                                  .words = kSides}),
  };
}

/// Fields of the law.
auto stop_law_fields() {
  using S = BumpStopFields;
  return std::array{
      field<S, &S::clearance>(
          {.name = "clearance",
           .doc = "way from the reference configuration to the contact; below zero: in contact there",
           .unit = "m or rad",
           .need = Need::required,
           .angle = true}),
      field<S, &S::stiffness>({.name = "stiffness",
                               .shape = Shape::law,
                               .doc =
                                   "factor of the penetration to the power of `exponent`, or a table of N or N m over "
                                   "the penetration (m or rad)",
                               .unit = "N/m^exponent or N m/rad^exponent",
                               .bound = Bound::not_negative}),
      field<S, &S::exponent>({.name = "exponent",
                              .shape = Shape::number,
                              .doc = "power of the penetration, at least 1",
                              .fallback = 1,
                              .depends = Depends::nothing}),
      field<S, &S::damping>({.name = "damping",
                             .doc = "share by which the force rises per speed of the penetration, in contact only",
                             .unit = "s/m or s/rad",
                             .fallback = 0,
                             .bound = Bound::not_negative}),
      field<S, &S::force>({.name = "force",
                           .shape = Shape::force,
                           .doc = "force added in contact, over `penetration` (m or rad) and `rate`",
                           .unit = "N or N m",
                           .locals = kStopLocals}),
  };
}

}  // namespace

template <>
std::span<const Field<BumpStopFields>> fields<BumpStopFields>() {
  static const std::array table = joined(stop_place_fields(), stop_law_fields());
  return table;
}

}  // namespace mbgen::reading
