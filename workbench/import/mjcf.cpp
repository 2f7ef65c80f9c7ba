#include "workbench/import/mjcf.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "workbench/import/known.hpp"

namespace mbgen::importing {
namespace {

/// The first element of one of these names, anywhere inside, or nullptr.
const Element* find_any(const Element& element, std::initializer_list<std::string_view> names) {
  for (const Element& inner : element.children) {
    if (std::find(names.begin(), names.end(), inner.name) != names.end()) return &inner;
    if (const Element* found = find_any(inner, names)) return found;
  }
  return nullptr;
}

void refuse_empty(Reading& reading, const Element& root) {
  const Element* writer = find_any(root, {"composite", "flexcomp", "attach"});
  if (!writer) return problem(reading, root.spot, "model has no bodies", "they stand in <worldbody>");
  problem(reading, writer->spot,
          fmt::format("<{}> is not carried over, and there are no bodies without it", writer->name),
          "let MuJoCo 3 load and save the file: it writes the bodies out");
}

void note_losses(Mjcf& mjcf, const Element& root) {
  for (const auto& [text, loss] : mjcf.losses) {
    const std::string times = loss.count > 1 ? fmt::format(" ({} of them)", loss.count) : std::string();
    const std::size_t colon = text.find(':');
    note(mjcf.reading, loss.first, text.substr(0, colon) + times + text.substr(colon));
  }
  if (!mjcf.massless.empty())
    note(mjcf.reading, root.spot,
         fmt::format("without the mass of meshes {} {} massless", few_names(mjcf.massless),
                     mjcf.massless.size() == 1 ? "is" : "are"),
         "give each an <inertial>, as MuJoCo writes it when it saves a model");
}

}  // namespace

void import_mjcf(Reading& reading, const Element& written, Assembly& assembly) {
  Mjcf mjcf{reading, assembly};
  note_left_out(reading, written, kMjcf);
  check_words(reading, written);
  Element root = written;
  read_settings(mjcf, root);
  expand_replicates(mjcf, root);
  for (const Element& section : root.children) {
    if (section.name == "worldbody") read_bodies(mjcf, section);
  }
  if (assembly.bodies.size() == 1 && reading.problems.empty()) refuse_empty(reading, root);
  scale_masses(mjcf);
  if (!reading.problems.empty()) return;
  add_spring_dampers(mjcf);
  close_loops_of(mjcf, root);
  report_references(mjcf);
  for (const char* name : {"tendon", "equality", "actuator"}) {
    for (const Element& section : root.children) {
      if (section.name != name) continue;
      if (section.name == "tendon") read_tendons(mjcf, section);
      if (section.name == "equality" && mjcf.settings.has_equalities) read_equalities(mjcf, section);
      if (section.name == "actuator" && mjcf.settings.has_actuators) read_actuators(mjcf, section);
    }
  }
  for (const MjcfJoint& joint : mjcf.scalar_joints)
    if (joint.armature > 0) add_rotor(assembly, joint.coordinate, joint.armature);
  check_inertias(reading, assembly);
  note_losses(mjcf, written);
}

}  // namespace mbgen::importing
