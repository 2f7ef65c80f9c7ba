// Reactions of joints and rods and the forces of drives against Simbody. Where closures are redundant neither engine's
// choice of reactions is the right one (mbgen gives some equations zero, Simbody takes the smallest multipliers), so
// joints inside such loop blocks are left out; those outside carry the same either way.

#include <cstdio>

#include "tests/oracle/oracle_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;
using Eigen::Vector3d;

/// Appends force and moment of a joint or a rod (the other -1) on its `to` body, global axes.
void add_reaction_outputs(Model& model, int joint, int rod) {
  for (const auto what : {ReactionOutput::What::force, ReactionOutput::What::moment})
    for (int axis = 0; axis < 3; ++axis) {
      ReactionOutput source;
      source.what = what;
      source.joint = joint;
      source.rod = rod;
      source.axis = axis;
      model.outputs.push_back({"probe" + std::to_string(model.outputs.size()), {}, "", source});
    }
}

/// The model with a probe of six outputs for every joint and rod in place of its own outputs.
Mechanism probed(const std::string& path) {
  Model model = load_without_tyres(path).model;
  model.outputs.clear();
  for (std::size_t j = 0; j < model.joints.size(); ++j) add_reaction_outputs(model, static_cast<int>(j), -1);
  for (std::size_t r = 0; r < model.rods.size(); ++r) add_reaction_outputs(model, -1, static_cast<int>(r));
  return analysed_model(std::move(model));
}

/// A joint or rod and where Simbody's reaction of it is.
struct Probe {
  std::string name;
  std::size_t output = 0;  ///< first of six
  int tree = -1, closure = -1;
};

/// What can be compared: joints of the tree and closures outside redundant loop blocks, no fixed joints (bodies that
/// are fixed to each other are one body in Simbody).
std::vector<Probe> comparable(const Mechanism& m) {
  std::vector<bool> tree(m.topology.bodies.size(), true), closed(m.topology.loops.size(), true);
  for (std::size_t b = 0; b < m.topology.blocks.size(); ++b) {
    if (!has_redundant_equations(m, b)) continue;
    for (const int j : m.topology.blocks[b].joints) tree[j] = false;
    for (const int l : m.topology.blocks[b].loops) closed[l] = false;
  }
  std::vector<Probe> probes;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const int joint = m.topology.bodies[i].joint;
    const bool last = i + 1 == tree.size() || m.topology.bodies[i + 1].joint != joint;
    if (last && tree[i])
      probes.push_back({m.model.joints[joint].name, 6 * static_cast<std::size_t>(joint), static_cast<int>(i), -1});
  }
  for (std::size_t l = 0; l < closed.size(); ++l) {
    if (!closed[l]) continue;
    const Loop& loop = m.topology.loops[l];
    const std::size_t place = loop.joint >= 0 ? static_cast<std::size_t>(loop.joint)
                                              : m.model.joints.size() + static_cast<std::size_t>(loop.rod);
    probes.push_back({loop.name, 6 * place, -1, static_cast<int>(l)});
  }
  return probes;
}

class EveryReactionInSimbody : public InSimbody<std::string> {};

TEST_P(EveryReactionInSimbody, IsTheSame) {
  const Mechanism m = probed(GetParam());
  GenericSolver solver(m.model, m.topology, m.analysis);
  foreign::SimbodyMechanism simbody = in_simbody(m);
  const std::vector<double> tau = random_tau(m, 5);
  const std::vector<Probe> probes = comparable(m);
  if (probes.empty() && m.model.motions.empty()) GTEST_SKIP() << "all of it is one redundant loop block";
  double error = 0, scale = 0;
  std::string worst;
  for (GenericState state : random_states(m, 3)) {
    solver.set_inputs(foreign::inputs_at(m.model, state.t));
    ASSERT_TRUE(solver.project(state).ok());
    GenericDerivative derivative;
    ASSERT_TRUE(solver.accelerations(state, tau, derivative).ok());
    const std::vector<double> y = solver.outputs(state, tau, derivative).y;
    const foreign::ForeignReactions theirs = simbody.reactions(foreign_state(state, tau));
    for (const Probe& probe : probes) {
      const foreign::Wrench& w = probe.tree >= 0 ? theirs.joints[probe.tree] : theirs.closures[probe.closure];
      const Vector3d force(&y[probe.output]), moment(&y[probe.output + 3]);
      const double difference = std::max((force - w.force).cwiseAbs().maxCoeff(),
                                         probe.closure >= 0 && m.topology.loops[probe.closure].rod >= 0
                                             ? 0.0
                                             : (moment - w.moment).cwiseAbs().maxCoeff());
      if (difference > error) worst = probe.name;
      error = std::max(error, difference);
      scale = std::max({scale, force.cwiseAbs().maxCoeff(), moment.cwiseAbs().maxCoeff()});
    }
    const std::vector<double> drives = solver.driving_forces(state, tau, derivative);
    for (std::size_t d = 0; d < drives.size(); ++d) {
      if (std::abs(drives[d] - theirs.drives[d]) > error) worst = m.model.motions[d].name;
      error = std::max(error, std::abs(drives[d] - theirs.drives[d]));
      scale = std::max(scale, std::abs(drives[d]));
    }
  }
  std::printf("%s: %zu joints and rods carry what Simbody says, %.1e relative (%s)\n", m.model.name.c_str(),
              probes.size(), error / std::max(scale, 1e-9), worst.c_str());
  EXPECT_LT(error, 1e-9 * std::max(scale, 1.0)) << worst;
}

INSTANTIATE_TEST_SUITE_P(Models, EveryReactionInSimbody, ::testing::ValuesIn(all_models()), test_name);

}  // namespace
}  // namespace mbgen
