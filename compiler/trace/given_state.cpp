#include <algorithm>
#include <utility>

#include "compiler/formulation/reaction_loads.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/tyres.hpp"
#include "compiler/trace/each_program.hpp"
#include "compiler/trace/tracing.hpp"

namespace mbgen {
namespace {

/// A state with given accelerations, and the forces that its joints must still be given.
struct GivenState {
  std::vector<Expr> tau, zdd;
  Kinematics<Expr> kinematics;
  Velocities<Expr> velocities;
  AppliedForces<Expr> forces;
  Accelerations<Expr> accelerations;
  GatheredForces<Expr> missing;  ///< per coordinate equal to Phi_z' lambda less the drives
};

/// The sweeps of the form that the tracing is in, with given forces on the joints.
GivenState given_state(Tracing& tracing, std::vector<Expr> tau) {
  System<Expr>& system = tracing.system;
  const bool is_matrix = tracing.form == Form::matrix;
  GivenState s;
  s.tau = std::move(tau);
  s.zdd = tracing.inputs(Array::zdd, tracing.size());
  s.kinematics = tracing.poses();
  const Inertias<Expr> m =
      is_matrix ? tracing.in(Step::inertias, [&] { return inertias(system, s.kinematics); }) : Inertias<Expr>{};
  const MotionPoint point = is_matrix ? MotionPoint::frame_origin : MotionPoint::body_origin;
  s.velocities = tracing.in(Step::velocities, [&] { return velocities(system, s.kinematics, point); });
  s.forces = tracing.in(Step::forces, [&] { return applied_forces(system, s.kinematics, s.velocities); });
  const auto step = tracing.annotator.step(Step::accelerations);
  s.accelerations = accelerations(system, s.kinematics, s.velocities, s.zdd);
  if (is_matrix)
    s.missing.joint = tree_forces(system, s.kinematics, m, s.velocities, s.accelerations, s.forces, s.tau);
  else
    s.missing = gathered_forces(system, s.kinematics, s.velocities, s.accelerations, s.forces, s.tau);
  return s;
}

/// Multipliers of a block over joint rates: the paper's order.
BlockMultipliers<Expr> rate_multipliers(Tracing& tracing, const GivenState& s, std::size_t b) {
  const LoopBlock& block = tracing.system.topology.blocks[b];
  const LoopPartition& partition = tracing.analysis.blocks[b];
  const SparseClosure<Expr> closed =
      sparse_closure(tracing.system, s.kinematics, block, at_rest<Expr>(tracing.system.topology));
  const auto heading = within_block(tracing.annotator, b);
  BlockMultipliers<Expr> result;
  for (int j : block.joints) result.left.push_back(s.missing.joint[j]);
  const FrozenFactors<Expr> factors = factorise_frozen(closed.jacobian, partition, block.joints.size());
  result.quality = factors.quality;
  result.lambda = solve_frozen_transposed(factors, partition, result.left, closed.residual.size());
  take_off(closed.jacobian, result.lambda, result.left);
  return result;
}

/// Multipliers of every block, in the form that the tracing is in.
std::vector<BlockMultipliers<Expr>> all_multipliers(Tracing& tracing, const GivenState& s) {
  const std::size_t count = tracing.system.topology.blocks.size();
  std::vector<BlockMultipliers<Expr>> result(count);
  if (tracing.form == Form::matrix) {
    for (std::size_t b = 0; b < count; ++b) result[b] = rate_multipliers(tracing, s, b);
    return result;
  }
  const RecursionWork<Expr> work = recursion_work(tracing.system, tracing.recursion, s.kinematics);
  std::vector<Expr> applied = s.tau;
  for (std::size_t i = 0; i < applied.size(); ++i) applied[i] += s.forces.joint[i];
  for (const RecursionUnit& unit : tracing.recursion.units)
    if (unit.block >= 0)
      result[unit.block] = block_multipliers(work, unit, tracing.analysis.blocks[unit.block].quasi, s.missing, applied);
  return result;
}

/// Names the multipliers of a block after their loops in programs for reading.
void name_multipliers(Tracing& tracing, const LoopBlock& block, const std::vector<Expr>& lambda) {
  for (std::size_t first = 0; const int l : block.loops) {
    const Loop& loop = tracing.system.topology.loops[static_cast<std::size_t>(l)];
    const auto heading = tracing.annotator.detail_within(OwnerKind::loop, static_cast<std::size_t>(l));
    for (int e = 0; e < loop.equations; ++e)
      tracing.annotator.detail(lambda[first++], "lambda_", loop.name,
                               loop.equations > 1 ? "_" + std::to_string(e) : "");
  }
}

/// Driving force of every motion, from what the multipliers leave of the missing forces.
std::vector<Expr> driving_forces(const Tracing& tracing, const std::vector<Expr>& left) {
  std::vector<Expr> drive;
  for (const Drive<Expr>& d : tracing.drive) drive.push_back(-left[d.coordinate]);
  return drive;
}

bool looks_at_multipliers(const Model& model) {
  return !model.motions.empty() || std::any_of(model.outputs.begin(), model.outputs.end(), [](const Output& output) {
    return std::holds_alternative<ReactionOutput>(output.source) ||
           std::holds_alternative<MultiplierOutput>(output.source);
  });
}

/// Driving forces, where expressions look at one: what multipliers leave of the missing forces.
std::vector<Expr> observed_drives(Tracing& tracing, const GivenState& s, const std::vector<std::vector<Expr>>& lambda) {
  const System<Expr>& system = tracing.system;
  const bool are_seen = std::any_of(system.model.observed.begin(), system.model.observed.end(), [](const auto& one) {
    return std::holds_alternative<DriveOutput>(one.output.source);
  });
  if (!are_seen) return {};
  std::vector<Expr> left = s.missing.joint;
  for (std::size_t b = 0; b < lambda.size(); ++b) {
    const LoopBlock& block = system.topology.blocks[b];
    const SparseClosure<Expr> closed =
        sparse_closure(tracing.system, s.kinematics, block, at_rest<Expr>(system.topology));
    std::vector<Expr> of_block;
    for (const int j : block.joints) of_block.push_back(left[j]);
    take_off(closed.jacobian, lambda[b], of_block);
    for (std::size_t c = 0; c < block.joints.size(); ++c) left[block.joints[c]] = of_block[c];
  }
  return driving_forces(tracing, left);
}

/// The reactions that sampled values take, at given accelerations, without forces of a user on the joints.
std::vector<Expr> reaction_loads_at(Tracing& tracing) {
  const Topology& topology = tracing.system.topology;
  const GivenState s = given_state(tracing, std::vector<Expr>(topology.bodies.size(), Expr(0.0)));
  const auto step = tracing.annotator.step(Step::outputs);
  std::vector<std::vector<Expr>> lambda;
  if (!topology.loops.empty()) lambda = by_block(topology, tracing.inputs(Array::lambda, equation_count(topology)));
  const std::vector<Expr> drive = observed_drives(tracing, s, lambda);
  return reaction_loads(tracing.system, {s.kinematics, s.velocities, s.accelerations, s.forces, s.zdd, lambda, drive});
}

}  // namespace

Program trace_multipliers(const Model& model, const Topology& topology, const Analysis& analysis, Form form,
                          Spelling spelling) {
  Tracing tracing(Role::multipliers, model, topology, analysis, form, {}, spelling);
  const GivenState s = given_state(tracing, tracing.inputs(Array::tau, tracing.size()));
  const auto step = tracing.annotator.step(Step::multipliers);
  std::vector<std::vector<Expr>> lambda;
  std::vector<Expr> left = s.missing.joint;
  const std::vector<BlockMultipliers<Expr>> blocks = all_multipliers(tracing, s);
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    const LoopBlock& block = topology.blocks[b];
    lambda.push_back(blocks[b].lambda);
    name_multipliers(tracing, block, blocks[b].lambda);
    for (std::size_t c = 0; c < block.joints.size(); ++c) {
      left[block.joints[c]] = blocks[b].left[c];
      tracing.output(of_block(Array::missing, b), static_cast<int>(c), s.missing.joint[block.joints[c]]);
    }
    tracing.output_pivot(b, blocks[b].quality);
  }
  tracing.outputs(Array::lambda, in_loop_order(topology, lambda));
  tracing.outputs(Array::drive, driving_forces(tracing, left));
  return tracing.builder.finish_in_canonical_order();
}

Program trace_outputs(const Model& model, const Topology& topology, const Analysis& analysis, Form form,
                      Spelling spelling) {
  Tracing tracing(Role::outputs, model, topology, analysis, form, {}, spelling);
  System<Expr>& system = tracing.system;
  const GivenState s = given_state(tracing, tracing.inputs(Array::tau, tracing.size()));
  const auto step = tracing.annotator.step(Step::outputs);
  std::vector<std::vector<Expr>> lambda;
  std::vector<Expr> drive;
  if (topology.loops.empty()) {
    drive = driving_forces(tracing, s.missing.joint);
  } else if (looks_at_multipliers(model)) {
    lambda = by_block(topology, tracing.inputs(Array::lambda, equation_count(topology)));
    drive = tracing.inputs(Array::drive, static_cast<int>(tracing.drive.size()));
  }
  std::vector<int> driven;
  for (const Drive<Expr>& d : tracing.drive) driven.push_back(d.coordinate);
  const SolvedState<Expr> solved{s.kinematics, s.velocities, s.accelerations, s.forces, s.zdd, lambda, drive};
  tracing.outputs(Array::y, output_values(system, solved));
  const Energies<Expr> e = energies(system, solved, s.tau, driven);
  tracing.outputs(Array::energy, {e.kinetic, e.potential});
  tracing.outputs(Array::power, {e.power});
  return tracing.builder.finish_in_canonical_order();
}

Program trace_sampled(const Model& model, const Topology& topology, const Analysis& analysis, Form form,
                      Spelling spelling) {
  Tracing tracing(Role::sampled, model, topology, analysis, form, {}, spelling);
  System<Expr>& system = tracing.system;
  std::vector<Expr> loads;
  if (takes_reactions(model)) {
    loads = reaction_loads_at(tracing);
  } else {
    const Kinematics<Expr> k = tracing.poses();
    const MotionPoint point = form == Form::matrix ? MotionPoint::frame_origin : MotionPoint::body_origin;
    const Velocities<Expr> v = tracing.in(Step::velocities, [&] { return velocities(system, k, point); });
    see_values(system, k, v);
  }
  const auto step = tracing.annotator.step(Step::outputs);
  const std::vector<Expr> due = tracing.inputs(Array::due, static_cast<int>(model.sampled.size()));
  tracing.outputs(Array::held, sampled_states(system, due, loads));
  return tracing.builder.finish_in_canonical_order();
}

Program trace_ground_places(const Model& model, const Topology& topology, const Analysis& analysis, Form form,
                            Spelling spelling) {
  Tracing tracing(Role::ground_places, model, topology, analysis, form, {}, spelling);
  const Kinematics<Expr> k = tracing.poses();
  const auto step = tracing.annotator.step(Step::outputs);
  std::vector<Expr> places;
  for (const int tyre : tyres_on_host(model)) {
    const Place<Expr> centre = place_of(tracing.system, model.tyres[tyre].centre);
    const Vector<Expr> position = position_in(tracing.system, k, centre, kGround);
    places.insert(places.end(), {position.x, position.y});
  }
  tracing.outputs(Array::place, places);
  return tracing.builder.finish_in_canonical_order();
}

}  // namespace mbgen
