#pragma once
// A model of mbgen side by side with the same model in a foreign engine.

#include "compiler/reader/read_model.hpp"
#include "tests/support/mechanism_support.hpp"
#include "tests/system/oracle/force_elements_of.hpp"
#include "tests/system/oracle/simbody_mechanism.hpp"

namespace mbgen::testing {

/// The model without what no foreign engine has: tyres, ropes and contacts, with the outputs that ask for them, and
/// Maxwell branches.
inline Model without_tyres(Model model) {
  std::erase_if(model.frictions,
                [](const JointFriction& f) { return f.has_bristle() || f.normal >= 0 || f.load >= 0; });
  model.spring_frictions.clear();
  model.rod_frictions.clear();
  model.tyres.clear();
  model.ropes.clear();
  model.contacts.clear();
  for (Bushing& bushing : model.bushings)
    for (std::optional<BushingFreedom>& own : bushing.freedoms)
      if (own) own->maxwell_stiffness.reset();
  std::erase_if(model.outputs, [](const Output& output) {
    const auto* element = std::get_if<ElementOutput>(&output.source);
    return element && (element->kind == kKindIndex<Tyre> || element->kind == kKindIndex<Rope> ||
                       element->kind == kKindIndex<SurfaceContact>);
  });
  return model;
}

/// Analyses a model that is not as its file says; a failure stops the test with its diagnostics.
inline Mechanism analysed_model(Model model) {
  Result<Topology> topology = build_topology(model);
  if (!topology) throw std::runtime_error(to_text(topology.problems()));
  Result<Analysis> analysis = analyse(model, *topology);
  if (!analysis) throw std::runtime_error(to_text(analysis.problems()));
  return {std::move(model), *topology, *analysis};
}

/// A model of the project without tyres.
inline Mechanism load_without_tyres(const std::string& relative) {
  Result<Model> model = read_model_file(source_path(relative));
  if (!model) throw std::runtime_error(to_text(model.problems()));
  return analysed_model(without_tyres(*model));
}

/// Whether discs or blades do not stay upright: Simbody's rows of no slip act at a place of a carriage.
inline bool tilts(const Model& model) {
  const auto needs_carriage = [](const Joint& joint) {
    return joint.type == JointType::rolling_disc || joint.type == JointType::knife_edge;
  };
  const auto is_in_space = [](const Joint& joint) {
    return joint.type == JointType::free || joint.type == JointType::spherical || joint.type == JointType::universal;
  };
  return std::ranges::any_of(model.joints, needs_carriage) && std::ranges::any_of(model.joints, is_in_space);
}

/// Models of all_models() without homokinetic joints, rods that change their length, discs that tilt and states of
/// their own, which Simbody has not, and without joints that are driven at their cuts: it takes no body without mass at
/// the end of a branch.
inline std::vector<std::string> models_in_simbody() {
  std::vector<std::string> paths = all_models();
  std::erase_if(paths, [](const std::string& path) {
    const Result<Model> model = read_model_file(source_path(path));
    const auto is_homokinetic = [](const Joint& joint) { return joint.type == JointType::homokinetic; };
    const auto is_driven = [](const Rod& rod) { return rod.drive >= 0; };
    const auto is_driven_at_cut = [](const Joint& joint) { return joint.closure >= 0; };
    return model &&
           (tilts(*model) || !model->states.empty() || !model->sampled.empty() ||
            std::ranges::any_of(model->joints, is_homokinetic) ||
            std::ranges::any_of(model->joints, is_driven_at_cut) || std::ranges::any_of(model->rods, is_driven));
  });
  return paths;
}

/// Requires: no tyres, and nothing that Simbody has not.
inline foreign::SimbodyMechanism in_simbody(const Mechanism& m) {
  const Result<foreign::ForceElements> elements = foreign::force_elements_of(m.model, m.topology);
  if (!elements) throw std::runtime_error(to_text(elements.problems()));
  return foreign::SimbodyMechanism(foreign::reference_mechanism(m.model, m.topology), *elements);
}

inline foreign::ForeignState foreign_state(const GenericState& state, const std::vector<double>& tau = {}) {
  return {state.z, state.zd, tau, state.t};
}

inline bool has_redundant_equations(const Mechanism& m, std::size_t block) {
  return !m.analysis.blocks[block].redundant_equations.empty();
}

/// A test of one model or course that needs Simbody.
template <class Parameter>
class InSimbody : public ::testing::TestWithParam<Parameter> {
 protected:
  void SetUp() override {
    if (!foreign::SimbodyMechanism::is_available()) GTEST_SKIP() << "Simbody (libsimbody-dev) is not installed";
  }
};

}  // namespace mbgen::testing
