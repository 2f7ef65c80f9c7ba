#include "compiler/solver/titles.hpp"

#include <fmt/format.h>

#include "compiler/topology/names.hpp"

namespace mbgen {
namespace {

struct StepTitle {
  const char* text;
  const char* in_matrix_form = nullptr;  ///< where it is another one
};

/// By step.
constexpr StepTitle kStepTitles[] = {
    {""},
    {"step 1: poses and axes b", "step 1: poses, axes b, accumulated inertias MR (50)"},
    {"step 2: closure Jacobian Phi_z and its factors (60)"},
    {"step 3: Rz (61)"},
    {"step 4: velocities", "step 4: velocities Z (36)"},
    {"step 5: applied forces Q (48)"},
    {"step 6: c and dRz/dt zd (62)"},
    {"step 7: inertias of the bodies and forces on joints",
     "step 7: accelerations Zdot and accumulated forces QR - PR (51), (52)"},
    {"step 8: elimination from the leaves to the root (63)", "step 8: Rz' M Rz and right-hand side (63)"},
    {"step 9: accelerations from the root to the leaves (63), (62)",
     "step 9: independent and all accelerations (63), (62)"},
    {"step 9: multipliers of the closures and driving forces"},
    {"step 9: outputs, energies, power"},
    {"tangents of the force elements and factors of the implicit equations"},
};

/// Name of a block by its loops.
std::string block_name(const Topology& topology, const LoopBlock& block) {
  const std::string& first = topology.loops[static_cast<std::size_t>(block.loops.front())].name;
  const std::string& last = topology.loops[static_cast<std::size_t>(block.loops.back())].name;
  return block.loops.size() > 1 ? first + " .. " + last : first;
}

std::string section_title(Form form, const Topology& topology, const Section& section) {
  const StepTitle& step = kStepTitles[static_cast<std::size_t>(section.step)];
  const std::string title = form == Form::matrix && step.in_matrix_form ? step.in_matrix_form : step.text;
  if (section.block < 0) return title;
  return title + ", " + block_name(topology, topology.blocks[static_cast<std::size_t>(section.block)]);
}

std::string tree_body_title(const Topology& topology, std::size_t i) {
  const TreeBody& body = topology.bodies[i];
  return fmt::format("{}: {}, {}, {}", body.name, body.coordinate, name_of(body.kind),
                     body_name(topology, body.parent));
}

template <auto elements>
std::string name_in(const Model& model, std::size_t i) {
  return (model.*elements)[i].name;
}

/// Names of the model's own parts.
constexpr std::pair<OwnerKind, std::string (*)(const Model&, std::size_t)> kNames[] = {
    {OwnerKind::body, name_in<&Model::bodies>},    {OwnerKind::joint, name_in<&Model::joints>},
    {OwnerKind::motion, name_in<&Model::motions>}, {OwnerKind::output, name_in<&Model::outputs>},
    {OwnerKind::state, name_in<&Model::states>},   {OwnerKind::sampled, name_in<&Model::sampled>}};

std::string owner_title(const Model& model, const Topology& topology, const Owner& owner) {
  const auto i = static_cast<std::size_t>(owner.index);
  if (owner.kind == OwnerKind::tree_body) return tree_body_title(topology, i);
  if (owner.kind == OwnerKind::loop) return topology.loops[i].name;
  if (owner.kind == OwnerKind::loop_block) return fmt::format("loop block {}", i);
  for (const auto& [kind, name_of_part] : kNames)
    if (kind == owner.kind) return name_of_part(model, i);
  std::string title;
  with_kind(place_of_kind(owner.kind), [&](auto kind) { title = kind.list(model)[i].name; });
  return title;
}

}  // namespace

Titles titles_of(Form form, const Model& model, const Topology& topology) {
  return {[=, &topology](const Section& section) { return section_title(form, topology, section); },
          [&](const Owner& owner) { return owner_title(model, topology, owner); }};
}

}  // namespace mbgen
