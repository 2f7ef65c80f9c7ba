// Tables of fields: anti-roll bars.
#include <array>

#include "compiler/reader/elements/anti_roll_bar.hpp"
#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

FieldInfo body_of_bar(std::string_view name, std::string_view doc) {
  return {.name = name, .shape = Shape::reference, .doc = doc, .need = Need::required, .of = "bodies"};
}

FieldInfo position_of_bar(std::string_view name, std::string_view doc, Need need) {
  return {
      .name = name, .shape = Shape::position, .doc = doc, .unit = "m", .need = need, .depends = Depends::parameters};
}

FieldInfo number_of_bar(std::string_view name, std::string_view doc, std::string_view unit, Bound bound,
                        std::optional<double> fallback = std::nullopt) {
  return {.name = name, .shape = Shape::number, .doc = doc, .unit = unit, .fallback = fallback, .bound = bound};
}

}  // namespace

template <>
std::span<const Field<AntiRollBarFields>> fields<AntiRollBarFields>() {
  using F = AntiRollBarFields;
  static const std::array table = {
      field<F, &F::body>(body_of_bar("body", "body in which the bar turns: the chassis, or an axle")),
      field<F, &F::left>(body_of_bar("left", "body at the other end of the left droplink: a knuckle, an arm, a strut")),
      field<F, &F::right>(body_of_bar("right", "body at the other end of the right droplink; may be the left one")),
      field<F, &F::pivot>(position_of_bar(
          "pivot",
          "left bearing, on the bar's axis; the axis goes from the right pivot to the left one; global axes at the "
          "reference",
          Need::required)),
      field<F, &F::arm>(position_of_bar("arm", "end of the left arm, where its droplink begins", Need::required)),
      field<F, &F::link>(position_of_bar("link", "end of the left droplink at the suspension", Need::required)),
      field<F, &F::right_pivot>(position_of_bar("right_pivot", "right bearing; default: mirror image", Need::optional)),
      field<F, &F::right_arm>(
          position_of_bar("right_arm", "end of the right arm; default: mirror image", Need::optional)),
      field<F, &F::right_link>(
          position_of_bar("right_link", "end of the right droplink; default: mirror image", Need::optional)),
      field<F, &F::mirror>({.name = "mirror",
                            .shape = Shape::word,
                            .doc = "plane between left and right, through the origin of the file",
                            .fallback_word = "xz",
                            .words = kMirrors}),
      field<F, &F::stiffness>(
          {.name = "stiffness",
           .shape = Shape::law,
           .doc = "torque over the angle between the arms, or a table of the torque over that angle",
           .unit = "N m/rad"}),
      field<F, &F::link_stiffness>(number_of_bar("link_stiffness",
                                                 "force in a droplink over the difference of the travels of both "
                                                 "droplinks, along them, at the reference",
                                                 "N/m", Bound::positive)),
      field<F, &F::section>({.name = "section",
                             .shape = Shape::object,
                             .doc = "its cross-section, of which the torsional stiffness follows; the arms are rigid",
                             .of = "bar_section"}),
      field<F, &F::damping>(
          {.name = "damping", .shape = Shape::law, .doc = "of the angle between the arms", .unit = "N m s/rad"}),
      field<F, &F::mass>(
          number_of_bar("mass", "of the whole bar, as a thin rod along axis and arms", "kg", Bound::not_negative, 0)),
      field<F, &F::link_mass>(number_of_bar("link_mass", "of each droplink", "kg", Bound::not_negative, 0)),
  };
  return table;
}

template <>
std::span<const Field<BarSectionFields>> fields<BarSectionFields>() {
  using F = BarSectionFields;
  constexpr double kSteel = 79.3e9;  // Pa
  static const std::array table = {
      field<F, &F::diameter>({.name = "diameter",
                              .shape = Shape::number,
                              .doc = "outer diameter",
                              .unit = "m",
                              .need = Need::required,
                              .bound = Bound::positive}),
      field<F, &F::inner_diameter>(number_of_bar("inner_diameter", "of a hollow bar", "m", Bound::not_negative, 0)),
      field<F, &F::length>(
          number_of_bar("length", "that is twisted; default: from pivot to pivot", "m", Bound::positive)),
      field<F, &F::shear_modulus>(number_of_bar("shear_modulus", "default: steel", "Pa", Bound::positive, kSteel)),
  };
  return table;
}

ComposedSection section_of(Composition<AntiRollBarFields>) {
  return {
      "anti_roll_bars", "anti_roll_bar", "anti-roll bars: two half bars, torsion between them, droplinks",
      [] {
        return std::vector<ObjectKind>{
            kind_of<AntiRollBarFields>("anti_roll_bar",
                                       "an anti-roll bar by three points of its left side; exactly one of stiffness, "
                                       "link_stiffness and section",
                                       {"stiffness", "link_stiffness", "section"}),
            kind_of<BarSectionFields>("bar_section", "round cross-section of an anti-roll bar")};
      },
      compose_bars};
}

}  // namespace mbgen::reading
