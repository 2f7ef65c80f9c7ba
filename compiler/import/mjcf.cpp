#include "compiler/import/mjcf.hpp"

#include <fmt/format.h>

#include <array>

namespace mbgen::importing {
namespace {

struct UnreadSection {
  std::string_view name, reason;
};
constexpr std::array<UnreadSection, 11> kUnreadSections = {{{"asset", "looks and meshes are not read"},
                                                            {"contact", "there is no contact"},
                                                            {"sensor", "outputs are chosen in the model"},
                                                            {"tendon", "forces and limits of tendons are missing"},
                                                            {"keyframe", "the initial state is chosen in the model"},
                                                            {"visual", ""},
                                                            {"statistic", ""},
                                                            {"size", ""},
                                                            {"custom", "its meaning is not defined"},
                                                            {"deformable", "bodies are rigid"},
                                                            {"extension", "plugins are not read"}}};

void read_section(Mjcf& mjcf, const Element& section) {
  if (section.name == "worldbody" || section.name == "compiler" || section.name == "option" ||
      section.name == "default" || section.name == "equality" || section.name == "actuator") {
    return;
  }
  for (const UnreadSection& unread : kUnreadSections) {
    if (unread.name != section.name) continue;
    if (!unread.reason.empty() && !section.children.empty()) {
      note(mjcf.reading, section.spot, fmt::format("<{}> is not carried over: {}", section.name, unread.reason));
    }
    return;
  }
  note(mjcf.reading, section.spot, fmt::format("<{}> is not carried over: it is unknown", section.name));
}

}  // namespace

void import_mjcf(Reading& reading, const Element& root, Assembly& assembly) {
  Mjcf mjcf{reading, assembly};
  read_settings(mjcf, root);
  for (const Element& section : root.children) {
    if (section.name == "worldbody") read_bodies(mjcf, section);
  }
  for (const Element& section : root.children) {
    if (section.name == "equality") read_equalities(mjcf, section);
    if (section.name == "actuator") read_actuators(mjcf, section);
    read_section(mjcf, section);
  }
  if (assembly.bodies.size() == 1 && reading.problems.empty()) {
    problem(reading, root.spot, "model has no bodies", "they stand in <worldbody>");
  }
  scale_masses(mjcf);
  check_inertias(reading, assembly);
  for (const auto& [text, loss] : mjcf.losses) {
    const std::string times = loss.count > 1 ? fmt::format(" ({} of them)", loss.count) : std::string();
    const std::size_t colon = text.find(':');
    note(reading, loss.first, text.substr(0, colon) + times + text.substr(colon));
  }
}

}  // namespace mbgen::importing
