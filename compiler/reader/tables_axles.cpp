// Table of fields: axles.
#include <array>

#include "compiler/reader/presentation.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

/// In the order of Axle::End.
constexpr std::array<std::string_view, 2> kAxleEnds = {"front", "rear"};
/// In the order of TorqueSupport.
constexpr std::array<std::string_view, 2> kSupports = {"carrier", "body"};

/// "springs and forces": sections of elements that a rig can remove.
std::string removable_sections() {
  std::vector<std::string> sections;
  each_kind([&](auto kind) {
    if (can_be_silent(kind)) sections.emplace_back(kind.section);
  });
  return enumeration(sections);
}

FieldInfo positive(std::string_view name, std::string_view doc, Bound bound = Bound::positive,
                   std::string_view unit = "m") {
  return {.name = name, .shape = Shape::number, .doc = doc, .unit = unit, .bound = bound};
}

}  // namespace

template <>
std::span<const Field<AxleWheelFields>> fields<AxleWheelFields>() {
  using F = AxleWheelFields;
  static const std::array table = {
      field<F, &F::tyre>({.name = "tyre",
                          .shape = Shape::reference,
                          .doc = "tyre of the wheel, which gives centre, axis and radius",
                          .of = "tyres"}),
      field<F, &F::written_centre>({.name = "centre",
                                    .shape = Shape::attachment,
                                    .doc = "wheel centre, a point of the wheel body on its axis, of a wheel without a "
                                           "tyre"}),
      field<F, &F::written_axis>(
          {.name = "axis", .shape = Shape::axis, .doc = "spin axis in the wheel frame; default y", .by_points = true}),
      field<F, &F::written_radius>(
          positive("radius", "from the centre to the contact patch, loaded; default: the tyre's unloaded radius")),
      field<F, &F::steering_axis>(
          {.name = "steering_axis", .shape = Shape::attachments, .doc = "lower and upper point of the steering axis"}),
  };
  return table;
}

template <>
std::span<const Field<AxleFields>> fields<AxleFields>() {
  using F = AxleFields;
  static const std::string without_doc = removable_sections() + " removed by the rig: those in place of the road";
  static const std::array table = {
      field<F, &F::written_body>({.name = "body",
                                  .shape = Shape::reference,
                                  .doc = "body fixed by the rig, default ground",
                                  .fallback_word = "ground",
                                  .of = "bodies"}),
      field<F, &F::written_left>({.name = "left", .shape = Shape::object, .doc = "the left wheel", .of = "axle_wheel"}),
      field<F, &F::written_right>({.name = "right",
                                   .shape = Shape::object,
                                   .doc = "the right wheel; with one wheel the other side is its mirror",
                                   .of = "axle_wheel"}),
      field<F, &F::written_steer>({.name = "steer",
                                   .shape = Shape::coordinate,
                                   .doc = "coordinate that steers: a rack, a pitman arm, a steering wheel; or the "
                                          "input that a driven one follows: the angle of a steering wheel"}),
      field<F, &F::end>({.name = "end",
                         .shape = Shape::word,
                         .doc = "end of the vehicle: the sign of anti-dive and its kin",
                         .fallback_word = "front",
                         .words = kAxleEnds}),
      field<F, &F::wheelbase>(positive("wheelbase",
                                       "of the vehicle; for Ackermann's angles and anti-dive; default: the distance to "
                                       "the only axle at the other end")),
      field<F, &F::centre_of_gravity_height>(
          positive("centre_of_gravity_height", "of the vehicle above the road; for anti-dive")),
      field<F, &F::brake_share>(
          positive("brake_share", "of the vehicle's braking force at this axle, 0 to 1", Bound::not_negative, "1")),
      field<F, &F::drive_share>(
          positive("drive_share", "of the vehicle's driving force at this axle, 0 to 1", Bound::not_negative, "1")),
      field<F, &F::brakes_on>({.name = "brakes_on",
                               .shape = Shape::word,
                               .doc = "support of a brake's torque: carrier, or body with inboard brakes",
                               .fallback_word = "carrier",
                               .words = kSupports}),
      field<F, &F::drive_on>({.name = "drive_on",
                              .shape = Shape::word,
                              .doc = "support of the drive's torque: body, or carrier of a rigid axle with its gear",
                              .fallback_word = "body",
                              .words = kSupports}),
      field<F, &F::written_without>({.name = "without", .shape = Shape::paths, .doc = without_doc}),
  };
  return table;
}

}  // namespace mbgen::reading
