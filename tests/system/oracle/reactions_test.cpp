// Reactions of joints and rods and the forces of drives against Simbody. Where closures are redundant neither engine's
// choice of reactions is the right one (mbgen gives some equations zero, Simbody takes the smallest multipliers).
// Inside such a loop block only what is unique is compared: in a planar one forces in the plane and moments about its
// normal, in any other nothing. Joints outside carry the same either way.

#include <Eigen/Geometry>
#include <cstdio>
#include <optional>

#include "tests/system/oracle/oracle_support.hpp"

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
  std::optional<Vector3d> normal;  ///< of a planar redundant block
};

/// The normal of the plane in which all joints of a block move: parallel to pins, square to slides; nothing else moves.
std::optional<Vector3d> plane_of(const Mechanism& m, const LoopBlock& block) {
  if (block.base != kGround) return {};
  std::optional<Vector3d> normal;
  for (const int j : block.joints) {
    const TreeBody& body = m.topology.bodies[j];
    if (body.kind == FreedomKind::revolute && !normal) normal = Vector3d(body.axis.data());
  }
  if (!normal) return {};
  for (const int j : block.joints) {
    const TreeBody& body = m.topology.bodies[j];
    const Vector3d axis(body.axis.data());
    const double off = body.kind == FreedomKind::revolute ? normal->cross(axis).norm() : std::abs(normal->dot(axis));
    if (off > 1e-12) return {};
  }
  return normal;
}

/// Comparable reactions; no fixed joints (bodies that are fixed to each other are one body in Simbody).
std::vector<Probe> comparable(const Mechanism& m) {
  std::vector<int> block_of_tree(m.topology.bodies.size(), -1), block_of_loop(m.topology.loops.size(), -1);
  for (std::size_t b = 0; b < m.topology.blocks.size(); ++b) {
    if (!has_redundant_equations(m, b)) continue;
    for (const int j : m.topology.blocks[b].joints) block_of_tree[j] = static_cast<int>(b);
    for (const int l : m.topology.blocks[b].loops) block_of_loop[l] = static_cast<int>(b);
  }
  std::vector<Probe> probes;
  const auto add = [&](Probe probe, int redundant_block) {
    if (redundant_block >= 0) probe.normal = plane_of(m, m.topology.blocks[redundant_block]);
    if (redundant_block < 0 || probe.normal) probes.push_back(probe);
  };
  for (std::size_t i = 0; i < m.topology.bodies.size(); ++i) {
    const int joint = m.topology.bodies[i].joint;
    if (i + 1 < m.topology.bodies.size() && m.topology.bodies[i + 1].joint == joint) continue;
    add({m.model.joints[joint].name, 6 * static_cast<std::size_t>(joint), static_cast<int>(i), -1, {}},
        block_of_tree[i]);
  }
  for (std::size_t l = 0; l < m.topology.loops.size(); ++l) {
    const Loop& loop = m.topology.loops[l];
    if (loop.coupling >= 0) continue;  // no body feels it alone: joints pass its forces on
    const std::size_t place = loop.joint >= 0 ? static_cast<std::size_t>(loop.joint)
                                              : m.model.joints.size() + static_cast<std::size_t>(loop.rod);
    add({loop.name, 6 * place, -1, static_cast<int>(l), {}}, block_of_loop[l]);
  }
  return probes;
}

/// Largest difference of what can be compared, N or N m.
double difference(const Mechanism& m, const Probe& probe, Vector3d force, Vector3d moment) {
  if (probe.normal) {
    force -= probe.normal->dot(force) * *probe.normal;
    moment = probe.normal->dot(moment) * *probe.normal;
  }
  const bool is_rod = probe.closure >= 0 && m.topology.loops[probe.closure].rod >= 0;
  return std::max(force.cwiseAbs().maxCoeff(), is_rod ? 0.0 : moment.cwiseAbs().maxCoeff());
}

class EveryReactionInSimbody : public InSimbody<std::string> {};

TEST_P(EveryReactionInSimbody, IsTheSame) {
  const Mechanism m = probed(GetParam());
  GenericSolver solver(m.model, m.topology, m.analysis);
  foreign::SimbodyMechanism simbody = in_simbody(m);
  const std::vector<double> tau = random_tau(m, 5);
  const std::vector<Probe> probes = comparable(m);
  if (probes.empty() && m.model.motions.empty()) GTEST_SKIP() << "all of it is one redundant loop block in space";
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
      const double off = difference(m, probe, force - w.force, moment - w.moment);
      ASSERT_TRUE(std::isfinite(off)) << probe.name;
      if (off > error) worst = probe.name;
      error = std::max(error, off);
      scale = std::max({scale, force.cwiseAbs().maxCoeff(), moment.cwiseAbs().maxCoeff()});
    }
    const std::vector<double> drives = solver.driving_forces(state, tau, derivative);
    for (std::size_t d = 0; d < drives.size(); ++d) {
      const double off = std::abs(drives[d] - theirs.drives[d]);
      ASSERT_TRUE(std::isfinite(off)) << m.model.motions[d].name;
      if (off > error) worst = m.model.motions[d].name;
      error = std::max(error, off);
      scale = std::max(scale, std::abs(drives[d]));
    }
  }
  std::printf("%s: %zu joints and rods carry what Simbody says, %.1e relative (%s)\n", m.model.name.c_str(),
              probes.size(), error / std::max(scale, 1e-9), worst.c_str());
  EXPECT_LT(error, 1e-9 * std::max(scale, 1.0)) << worst;
}

INSTANTIATE_TEST_SUITE_P(Models, EveryReactionInSimbody, ::testing::ValuesIn(models_in_simbody()), test_name);

}  // namespace
}  // namespace mbgen
