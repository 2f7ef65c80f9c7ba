// Tables of fields: bushings.
#include <array>

#include "compiler/reader/presentation.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr std::array<std::string_view, 2> kFreedomLocals = {"deflection", "rate"};

FieldInfo freedom(std::string_view name, std::string_view doc) {
  return {.name = name, .shape = Shape::object, .doc = doc, .of = "bushing_freedom"};
}

FieldInfo matrix(std::string_view name, std::string_view doc, std::string_view unit) {
  return {.name = name, .shape = Shape::six_by_six, .doc = doc, .unit = unit};
}

/// Where a bushing is.
auto bushing_frame_fields() {
  using S = BushingFields;
  return std::array{
      field<S, &S::from>({.name = "from",
                          .shape = Shape::attachment,
                          .doc = "point of the frame in whose axes deflections count",
                          .need = Need::required}),
      field<S, &S::to>({.name = "to",
                        .shape = Shape::attachment,
                        .doc = "point of the frame that is deflected, on another body; at the reference at the point "
                               "of `from`, or the bushing is deflected there",
                        .need = Need::required}),
      field<S, &S::written_axis>({.name = "axis",
                                  .shape = Shape::axis,
                                  .doc = "its axis z, in the frame of `from`; default z",
                                  .by_points = true}),
      field<S, &S::axis2>({.name = "axis2",
                           .shape = Shape::axis,
                           .doc = "direction of its axis x, likewise, of which the part across `axis` counts; default: "
                                  "the letter after that of `axis`, or across a skew one",
                           .by_points = true}),
  };
}

/// Fields of the law.
auto bushing_law_fields() {
  using S = BushingFields;
  return std::array{
      field<S, &S::radial>(freedom("radial", "laws of tx and of ty, each by itself")),
      field<S, &S::tx>(freedom("tx", "displacement along its axis x, m")),
      field<S, &S::ty>(freedom("ty", "displacement along its axis y, m")),
      field<S, &S::tz>(freedom("tz", "displacement along its axis z, m")),
      field<S, &S::conical>(freedom("conical", "laws of rx and of ry, each by itself")),
      field<S, &S::rx>(freedom("rx", "component x of the rotation vector, rad")),
      field<S, &S::ry>(freedom("ry", "component y of the rotation vector, rad")),
      field<S, &S::rz>(freedom("rz", "component z of the rotation vector, rad")),
      field<S, &S::written_stiffness>(
          matrix("stiffness", "symmetric matrix over tx, ty, tz, rx, ry, rz, six rows of six", "N/m, N or N m/rad")),
      field<S, &S::written_damping>(
          matrix("damping", "symmetric matrix over the rates, likewise", "N s/m, N s or N m s/rad")),
  };
}

}  // namespace

template <>
std::span<const Field<BushingFields>> fields<BushingFields>() {
  static const std::array table = joined(bushing_frame_fields(), bushing_law_fields());
  return table;
}

template <>
std::span<const Field<BushingFreedom>> fields<BushingFreedom>() {
  using F = BushingFreedom;
  static const std::array table = {
      field<F, &F::stiffness>({.name = "stiffness",
                               .shape = Shape::law,
                               .doc = "stiffness, or a table of N or N m over the deflection (m or rad)",
                               .unit = "N/m or N m/rad"}),
      field<F, &F::damping>({.name = "damping",
                             .shape = Shape::law,
                             .doc = "damping, or a table of N or N m over the rate (m/s or rad/s)",
                             .unit = "N s/m or N m s/rad"}),
      field<F, &F::preload>({.name = "preload",
                             .doc = "force or moment added, against positive deflections",
                             .unit = "N or N m",
                             .fallback = 0}),
      field<F, &F::force>({.name = "force",
                           .shape = Shape::force,
                           .doc = "force or moment added, against positive deflections, over `deflection` and `rate`",
                           .unit = "N or N m",
                           .locals = kFreedomLocals}),
      field<F, &F::maxwell_stiffness>({.name = "maxwell_stiffness",
                                       .doc = "stiffness of a Maxwell branch beside them, for a stiffness that rises "
                                              "with frequency by it",
                                       .unit = "N/m or N m/rad",
                                       .bound = Bound::not_negative}),
      field<F, &F::maxwell_time>({.name = "maxwell_time",
                                  .doc = "relaxation time of the branch: its damping over its stiffness",
                                  .unit = "s",
                                  .bound = Bound::positive}),
  };
  return table;
}

}  // namespace mbgen::reading
