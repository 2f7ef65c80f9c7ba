// MJCF: attributes that take one of a few words. Another word would silently mean the default.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "workbench/import/mjcf.hpp"

namespace mbgen::importing {
namespace {

constexpr std::array<std::string_view, 2> kTruths = {"true", "false"}, kAngles = {"degree", "radian"},
                                          kCoordinates = {"local", "global"}, kSwitches = {"enable", "disable"};
constexpr std::array<std::string_view, 3> kTruthsOrAuto = {"true", "false", "auto"};

struct Words {
  std::string_view attribute;
  std::span<const std::string_view> allowed;
};
constexpr std::array<Words, 12> kWords = {{{"angle", kAngles},
                                           {"coordinate", kCoordinates},
                                           {"inertiafromgeom", kTruthsOrAuto},
                                           {"autolimits", kTruths},
                                           {"balanceinertia", kTruths},
                                           {"limited", kTruthsOrAuto},
                                           {"ctrllimited", kTruthsOrAuto},
                                           {"forcelimited", kTruthsOrAuto},
                                           {"actlimited", kTruthsOrAuto},
                                           {"active", kTruths},
                                           {"mocap", kTruths},
                                           {"shellinertia", kTruths}}};

void check(Reading& reading, const Attribute& attribute, std::span<const std::string_view> allowed) {
  if (std::find(allowed.begin(), allowed.end(), attribute.value) != allowed.end()) return;
  std::string known;
  for (const std::string_view word : allowed) known += fmt::format("{}{}", known.empty() ? "" : ", ", word);
  problem(reading, attribute.spot, fmt::format("{} takes no {}", attribute.name, quoted_text(attribute.value)),
          "known: " + known);
}

void check_inside(Reading& reading, const Element& element) {
  for (const Attribute& attribute : element.attributes) {
    if (element.name == "flag") check(reading, attribute, kSwitches);
    for (const Words& words : kWords)
      if (attribute.name == words.attribute) check(reading, attribute, words.allowed);
  }
  for (const Element& inner : element.children) check_inside(reading, inner);
}

}  // namespace

void check_words(Reading& reading, const Element& root) {
  static constexpr std::array<std::string_view, 7> sections = {"compiler", "option", "default", "worldbody",
                                                               "equality", "tendon", "actuator"};
  for (const Element& section : root.children)
    if (std::find(sections.begin(), sections.end(), section.name) != sections.end()) check_inside(reading, section);
}

}  // namespace mbgen::importing
