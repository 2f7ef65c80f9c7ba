// Tables of fields: tyres, their coefficients, envelopes and patches.
#include <array>

#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr std::array<std::string_view, 3> kTyreModels = {"pac89", "pac2002", "mf61"};
constexpr std::array<std::string_view, 2> kCombinedSlips = {"set", "ellipse"};

}  // namespace

template <>
std::span<const Field<TyreDataFields>> fields<TyreDataFields>() {
  using S = TyreDataFields;
  static const std::array table = {
      field<S, &S::written_model>({.name = "model",
                                   .shape = Shape::word,
                                   .doc = "form of the magic formula",
                                   .need = Need::required,
                                   .words = kTyreModels}),
      field<S, &S::coefficients>({.name = "coefficients",
                                  .shape = Shape::coefficients,
                                  .doc = "pac2002 and mf61: values by their .tir names; pac89: arrays a, b and c",
                                  .need = Need::required}),
  };
  return table;
}

template <>
std::span<const Field<TyreEnvelope>> fields<TyreEnvelope>() {
  using S = TyreEnvelope;
  const auto number = [](std::string_view name, std::string_view doc, double fallback) {
    return constant_info(name, doc, "1", fallback, Bound::positive, Depends::nothing);
  };
  static const std::array table = {
      field<S, &S::base>(number(
          "base", "distance of front and rear cams; of a .tir file with ELLIPS_SHIFT that times its contact length",
          0.4)),
      field<S, &S::length>(number("length", "half axis of a cam along the road; of a .tir file its ELLIPS_LENGTH", 1)),
      field<S, &S::height>(number(
          "height", "half axis of a cam upwards, higher than what it rolls over; of a .tir file its ELLIPS_HEIGHT", 1)),
      field<S, &S::order>(number(
          "order", "exponent of a cam's outline, at least 1, 2: an ellipse; of a .tir file its ELLIPS_ORDER", 1.8)),
      field<S, &S::width>(number("width", "width of the tyre on the road", 0.6)),
      field<S, &S::steps>(
          number("steps",
                 "how finely a cam sees the road: places that are looked at from below wheel to cam centre, whole", 1)),
  };
  return table;
}

template <>
std::span<const Field<TyrePatch>> fields<TyrePatch>() {
  using S = TyrePatch;
  const auto number = [](std::string_view name, std::string_view doc, std::string_view unit) {
    return FieldInfo{.name = name, .doc = doc, .unit = unit, .bound = Bound::positive};
  };
  static const std::array table = {
      field<S, &S::stiffness>(number("stiffness",
                                     "torsional, of the patch under `load`; it grows with the load to the power 3/2; "
                                     "default of turn slip: from its coefficients and YAW_STIFFNESS",
                                     "N m/rad")),
      field<S, &S::radius>(number("radius",
                                  "moment of a patch that turns on the spot, over its friction, under `load`; it grows "
                                  "with the root of the load; default of turn slip: QCRP1 times UNLOADED_RADIUS",
                                  "m")),
      field<S, &S::load>(number("load", "of one tyre, under which these hold; default: FNOMIN of the set", "N")),
  };
  return table;
}

template <>
std::span<const Field<TyreFields>> fields<TyreFields>() {
  using S = TyreFields;
  const auto number = [](std::string_view name, std::string_view doc, std::string_view unit,
                         std::optional<double> fallback, Bound bound) {
    return FieldInfo{.name = name, .doc = doc, .unit = unit, .fallback = fallback, .bound = bound};
  };
  static const std::array table = {
      field<S, &S::centre>(element_end("centre", "wheel centre, a point of the wheel body on its axis")),
      field<S, &S::axis>(
          {.name = "axis",
           .shape = Shape::axis,
           .doc = "spin axis in the wheel frame, to the left; default: axis of the joint in which the wheel turns, "
                  "else y",
           .by_points = true}),
      field<S, &S::data>(
          {.name = "data", .shape = Shape::reference, .doc = "name of the coefficient set", .of = "tyre_data"}),
      field<S, &S::tir>({.name = "tir",
                         .shape = Shape::text,
                         .doc = "file of PAC2002 or Magic Formula 5.2, 6.1 or 6.2 with the coefficients, relative to "
                                "this file; also the default of radius, stiffness, damping, rolling_resistance, "
                                "pressure and relaxation"}),
      field<S, &S::side>({.name = "side",
                          .shape = Shape::number,
                          .doc = "1: coefficients as they are; -1: mirrored",
                          .fallback = 1,
                          .depends = Depends::nothing}),
      field<S, &S::count>({.name = "count",
                           .shape = Shape::number,
                           .doc = "tyres side by side, 2 for twins",
                           .fallback = 1,
                           .bound = Bound::positive,
                           .depends = Depends::nothing}),
      field<S, &S::radius>(number("radius", "unloaded radius; default: UNLOADED_RADIUS of a pac2002 or mf61 set", "m",
                                  std::nullopt, Bound::positive)),
      field<S, &S::stiffness>({.name = "stiffness",
                               .doc = "vertical stiffness of one tyre; default: VERTICAL_STIFFNESS of a .tir file",
                               .unit = "N/m",
                               .bound = Bound::positive}),
      field<S, &S::damping>(number("damping", "vertical damping of one tyre", "N s/m", 0, Bound::not_negative)),
      field<S, &S::written_road>({.name = "road",
                                  .shape = Shape::reference,
                                  .doc = "road under the tyre; default: the only one, without any a flat one",
                                  .of = "roads"}),
      field<S, &S::enveloping>({.name = "enveloping",
                                .shape = Shape::object,
                                .doc = "contact by an envelope of the road, for short obstacles; default: in one point",
                                .of = "tyre_envelope"}),
      field<S, &S::road_height>(
          number("road_height", "global z of a flat road; raises one of `roads` under this tyre", "m", 0, Bound::none)),
      field<S, &S::friction>(number("friction", "scales the friction of the set", "1", 1, Bound::not_negative)),
      field<S, &S::rolling_resistance>(number("rolling_resistance",
                                              "moment over load and radius; default of an mf61 set: its QSY1", "1",
                                              0.007, Bound::not_negative)),
      field<S, &S::pressure>({.name = "pressure",
                              .doc = "inflation pressure, of an mf61 set alone; default: INFLPRES of a .tir file, else "
                                     "NOMPRES",
                              .unit = "Pa",
                              .bound = Bound::positive}),
      field<S, &S::relaxation_x>(number(
          "relaxation_x",
          "relaxation length of longitudinal slip, whatever the load; default: over the load where the set gives "
          "it (PTX1, LONGITUDINAL_STIFFNESS)",
          "m", 0.3, Bound::positive)),
      field<S, &S::relaxation_y>(
          number("relaxation_y",
                 "relaxation length of lateral slip, whatever the load; default: over the load where the set gives it "
                 "(PTY1, LATERAL_STIFFNESS)",
                 "m", 0.6, Bound::positive)),
      field<S, &S::low_speed>(number("low_speed", "speed below which slip is damped so that the wheel comes to rest",
                                     "m/s", 2, Bound::positive)),
      field<S, &S::combined_slip>(
          {.name = "combined_slip",
           .shape = Shape::word,
           .doc = "forces of slip along and across together: by the set's coefficients, or by a friction ellipse in "
                  "their place, as pac89 always has it",
           .fallback_word = "set",
           .words = kCombinedSlips}),
      field<S, &S::written_turn_slip>(
          {.name = "turn_slip",
           .shape = Shape::boolean,
           .doc = "turn slip of an mf61 set acts; default: as USE_MODE of a .tir file asks by its last digit, 5, else "
                  "not"}),
      field<S, &S::written_parking>({.name = "parking",
                                     .shape = Shape::object,
                                     .doc =
                                         "moment of the patch against turning, as of a parked wheel that is steered; "
                                         "default: none, with turn slip that of its coefficients",
                                     .of = "tyre_patch"}),
  };
  return table;
}

}  // namespace mbgen::reading
