#include "compiler/analysis/analysis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "compiler/analysis/actuation.hpp"
#include "compiler/analysis/block_structure.hpp"
#include "compiler/analysis/branch.hpp"
#include "compiler/analysis/certificate.hpp"
#include "compiler/analysis/contradiction.hpp"
#include "compiler/analysis/freedom_walk.hpp"
#include "compiler/analysis/large_block.hpp"
#include "compiler/analysis/many_directions.hpp"
#include "compiler/analysis/partition.hpp"
#include "compiler/analysis/pivots_along.hpp"
#include "compiler/analysis/position_rank.hpp"
#include "compiler/analysis/quasi_partition.hpp"
#include "compiler/analysis/redundant_residuals.hpp"
#include "compiler/analysis/sampling.hpp"
#include "compiler/model/vectors.hpp"

namespace mbgen {
namespace {

constexpr int kWantedConfigurations = 24;

/// One walk there and back again is enough for large blocks.
int wanted_configurations(const Topology& topology) {
  if (topology.blocks.empty()) return 4;
  return std::all_of(topology.blocks.begin(), topology.blocks.end(), is_large) ? 2 * kWalkLength
                                                                               : kWantedConfigurations;
}

Diagnostic problem(const Where& where, std::string message, std::string hint) {
  return {where, std::move(message), std::move(hint), {}};
}

/// The equation of a block that stays open most at the best that Newton found.
Diagnostic open_loop(const Model& model, const Topology& topology, const LoopBlock& block,
                     const Eigen::VectorXd& residual) {
  int worst = 0;
  for (int e = 0; e < residual.size(); ++e)
    if (!(std::abs(residual[e]) <= std::abs(residual[worst]))) worst = e;
  const ClosureEquation equation = closure_equations(model, topology, block)[worst];
  const Loop& loop = topology.loops[equation.loop];
  return problem(
      where_of(model, loop),
      fmt::format("loop {} cannot be closed near the reference configuration: it stays open by {} ({}, {})",
                  quoted(loop.name), opening_text(equation.unit, opening(model, topology, equation, residual[worst])),
                  equation.name, equation.meaning),
      loop.coupling >= 0
          ? "check its relation, which coordinates of zero must nearly meet, and whether others contradict it"
          : "check the points and axes of the joints in this loop, and whether its equations contradict each other");
}

std::vector<int> driven_columns(const LoopBlock& block, const std::vector<bool>& driven) {
  std::vector<int> columns;
  for (std::size_t c = 0; c < block.joints.size(); ++c)
    if (driven[block.joints[c]]) columns.push_back(static_cast<int>(c));
  return columns;
}

std::vector<int> free_columns(const LoopBlock& block, const std::vector<bool>& driven) {
  std::vector<int> columns;
  for (std::size_t c = 0; c < block.joints.size(); ++c)
    if (!driven[block.joints[c]]) columns.push_back(static_cast<int>(c));
  return columns;
}

/// Where the generic rank was seen.
std::vector<Eigen::MatrixXd> regular_jacobians(const PartView& whole) {
  std::vector<Eigen::MatrixXd> jacobians;
  for (std::size_t s = 0; s < whole.jacobians.size(); ++s)
    if (whole.ranks[s] == whole.rank) jacobians.push_back(whole.jacobians[s]);
  return jacobians;
}

/// "a, b and c".
std::string in_a_row(const std::vector<std::string>& names) {
  if (names.size() < 2) return fmt::format("{}", fmt::join(names, ""));
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

/// The motion that drives a column of a block.
const Motion& motion_of(const Model& model, const LoopBlock& block, const Analysis& analysis, int column) {
  return model.motions[analysis.motion_of[block.joints[column]]];
}

/// Driven columns of which each follows from the others: without any one of them the rest would be free to move.
std::vector<int> dependent_columns(const LoopBlock& block, const PartView& whole, std::vector<int> driven) {
  const std::vector<Eigen::MatrixXd> jacobians = regular_jacobians(whole);
  const auto over_constrain = [&](const std::vector<int>& set) {
    std::vector<int> others;
    for (int c = 0; c < static_cast<int>(block.joints.size()); ++c)
      if (std::find(set.begin(), set.end(), c) == set.end()) others.push_back(c);
    return others.empty() || generic_rank(jacobians, others) < whole.rank;
  };
  for (std::size_t i = driven.size(); i-- > 0;) {
    std::vector<int> fewer = driven;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (over_constrain(fewer)) driven = fewer;
  }
  return driven;
}

/// Motions of coordinates that a loop holds, which no freedom moves.
Diagnostics motions_of_locked(const Model& model, const Topology& topology, const LoopBlock& block,
                              const std::vector<int>& immobile, const Analysis& analysis) {
  const auto is_held = [&](int c) { return std::find(immobile.begin(), immobile.end(), c) != immobile.end(); };
  std::vector<std::string> moving;
  for (const int c : free_columns(block, analysis.driven))
    if (!is_held(c)) moving.push_back(topology.bodies[block.joints[c]].coordinate);
  const std::string others = moving.empty() ? "; nothing of this loop moves by itself"
                                            : fmt::format(", or drive one that moves: {}", fmt::join(moving, ", "));
  Diagnostics problems;
  for (const int c : driven_columns(block, analysis.driven)) {
    if (!is_held(c)) continue;
    problems.push_back(problem(motion_of(model, block, analysis, c).where,
                               fmt::format("coordinate {} is driven, but its loop holds it: no freedom moves it",
                                           quoted(topology.bodies[block.joints[c]].coordinate)),
                               "remove the motion" + others));
  }
  return problems;
}

/// Motions that leave a loop block less than its rank. immobile: columns that no freedom moves.
Diagnostics too_many_motions(const Model& model, const Topology& topology, const LoopBlock& block,
                             const PartView& whole, const std::vector<int>& immobile, const Analysis& analysis) {
  Diagnostics locked = motions_of_locked(model, topology, block, immobile, analysis);
  if (!locked.empty()) return locked;
  // Subsets of a large block are not tried: its driven coordinates are named together.
  const std::vector<int> all = driven_columns(block, analysis.driven);
  const std::vector<int> driven = is_large(block) ? all : dependent_columns(block, whole, all);
  std::vector<std::string> coordinates, motions;
  const Motion* last = nullptr;
  for (const int c : driven) {
    const Motion& motion = motion_of(model, block, analysis, c);
    if (!last || &motion > last) last = &motion;
    coordinates.push_back(topology.bodies[block.joints[c]].coordinate);
    motions.push_back(motion.name);
  }
  const int freedoms = static_cast<int>(block.joints.size()) - whole.rank;
  const std::string why = is_large(block)
                              ? fmt::format("and its {} do not bear them together",
                                            freedoms == 1 ? "one freedom" : fmt::format("{} freedoms", freedoms))
                              : fmt::format("and each follows from the other{}", coordinates.size() > 2 ? "s" : "");
  return {problem(
      last->where, fmt::format("motions over-constrain a loop: {} are driven, {}", in_a_row(coordinates), why),
      fmt::format("remove one of the motions {}, or drive a coordinate that the loop leaves free", in_a_row(motions)))};
}

/// Motions that leave a block less than its generic rank.
Diagnostics over_constrained(const Model& model, const Topology& topology, const LoopBlock& block,
                             const PartView& whole, const std::vector<int>& immobile, const Analysis& analysis) {
  const std::vector<int> driven = driven_columns(block, analysis.driven);
  if (driven.empty()) return {};
  const std::vector<int> free = free_columns(block, analysis.driven);
  const int reached = free.empty() ? 0 : generic_rank(regular_jacobians(whole), free);
  if (reached >= whole.rank) return {};
  return too_many_motions(model, topology, block, whole, immobile, analysis);
}

/// Findings about the blocks; one entry per block.
struct Findings {
  std::vector<std::vector<ClosureEquation>> equations;
  std::vector<std::vector<RankCount>> other_modes;
  std::vector<PartView> views;
  Diagnostics problems;
};

/// The same of a large block, see large_block.hpp.
BlockAnalysis analyse_large_block(NumericSystem& numbers, std::size_t b,
                                  const std::vector<Configuration>& configurations, const Analysis& analysis,
                                  Findings& found) {
  const Model& model = numbers.model();
  const Topology& topology = numbers.topology();
  const LoopBlock& block = topology.blocks[b];
  const std::vector<ClosureEquation>& equations = found.equations[b];
  found.views.push_back(large_view(numbers, b, configurations));
  const PartView& whole = found.views.back();
  const Certificate certificate = certify_large(topology, b, whole, equations, configurations);
  Diagnostics problems = contradictions(numbers, b, whole, certificate.immobile, equations, configurations);
  if (problems.empty()) problems = large_contradictions(model, topology, b, equations, configurations);
  const std::vector<int> driven = driven_columns(block, analysis.driven);
  BlockAnalysis result = choose_large_partition(block, b, whole, driven, configurations);
  if (problems.empty() && result.rank < whole.rank)
    problems = too_many_motions(model, topology, block, whole, certificate.immobile, analysis);
  if (!problems.empty()) {
    found.problems.insert(found.problems.end(), problems.begin(), problems.end());
    return {};
  }
  if (chooses_again(block)) {
    const MotionAlong along = motion_along(numbers, b, configurations[0], result);
    const int free = free_coordinate_along(along, result);
    if (!along.ways.empty() && free != result.independent[0]) {
      BlockAnalysis other = choose_large_partition(block, b, whole, driven, configurations, {free});
      if (other.rank == result.rank) result = std::move(other);
    }
    order_along_motion(along, block.joints.size(), result);
  }
  for (int e : result.redundant_equations) result.redundant_names.push_back(equations[e].name);
  result.certificate = certificate;
  return result;
}

/// Rank, certificate and partition of block `b`; its problems go to `found`. like: see choose_partition.
BlockAnalysis analyse_block(NumericSystem& numbers, std::size_t b, const std::vector<Configuration>& configurations,
                            std::span<const PartitionCandidate> like, const Analysis& analysis, Findings& found) {
  const Model& model = numbers.model();
  const Topology& topology = numbers.topology();
  const LoopBlock& block = topology.blocks[b];
  const std::vector<ClosureEquation>& equations = found.equations[b];
  if (!configurations[0].closed[b]) {
    found.problems.push_back(open_loop(model, topology, block, configurations[0].residuals[b]));
    return {};
  }
  if (is_large(block)) return analyse_large_block(numbers, b, configurations, analysis, found);
  found.views.push_back(view(numbers, b, block_part(topology, block, block.loops), equations, configurations));
  const PartView& whole = found.views.back();
  Certificate certificate = certify(topology, block, whole, configurations);
  add_other_modes(certificate, found.other_modes[b]);
  Diagnostics problems = contradictions(numbers, b, whole, certificate.immobile, equations, configurations);
  if (problems.empty()) problems = over_constrained(model, topology, block, whole, certificate.immobile, analysis);
  if (!problems.empty()) {
    found.problems.insert(found.problems.end(), problems.begin(), problems.end());
    return {};
  }
  std::vector<Eigen::MatrixXd> jacobians;
  for (int i : whole.configurations) jacobians.push_back(configurations[i].blocks[b].jacobian);
  const std::vector<int> driven = driven_columns(block, analysis.driven);
  const LateRows late = late_rows(jacobians, whole.rank, driven, velocity_rows(model, topology, block));
  BlockAnalysis result = choose_partition(jacobians, whole.rank, driven, like, late);
  if (chooses_again(block))
    prefer_along_motion(motion_along(numbers, b, configurations[0], result), block.joints.size(), result);
  for (int e : result.redundant_equations) result.redundant_names.push_back(equations[e].name);
  result.certificate = certificate;
  return result;
}

/// Completes the certificates by the residuals of the equations that the partitions left out.
void complete_certificates(NumericSystem& numbers, const std::vector<Configuration>& configurations, Analysis& analysis,
                           Findings& found) {
  std::vector<std::vector<int>> kept;
  for (const BlockAnalysis& block : analysis.blocks) {
    kept.emplace_back();
    for (const Pivot& pivot : block.pivots) kept.back().push_back(pivot.equation);
    std::sort(kept.back().begin(), kept.back().end());
  }
  const std::vector<RedundantResiduals> residuals =
      redundant_residuals(numbers, found.views, kept, found.equations, configurations);
  for (std::size_t b = 0; b < residuals.size(); ++b) {
    if (is_large(numbers.topology().blocks[b])) continue;
    certify_redundant(analysis.blocks[b].certificate, analysis.blocks[b].redundant_equations, found.equations[b],
                      residuals[b].steps, residuals[b].residual);
    found.problems.insert(found.problems.end(), residuals[b].problems.begin(), residuals[b].problems.end());
  }
}

/// Diagonal of the box around all joints and centres of mass at the reference, m.
double extent_of(const Model& model) {
  Box box;
  for (const Joint& joint : model.joints) box.add(reference_position(model, joint.to));
  for (const Body& body : model.bodies) {
    Vector3 at = body.pose.origin;
    for (std::size_t i = 0; i < 9; ++i) at[i / 3] += body.pose.rotation[i] * body.com[i % 3].value;
    if (body.mass.value > 0) box.add(at);
  }
  return box.diagonal();
}

/// Per tree joint: inertia, from rounding alone, of a motion of all its bodies that has none.
std::vector<double> rounding_of_inertia(const Model& model, const Topology& topology) {
  constexpr double kRounding = 1e-14;
  const double extent = extent_of(model);
  std::vector<double> carried(topology.bodies.size(), 0.0);  // kg
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    if (topology.tree_body[b] >= 0) carried[topology.tree_body[b]] += model.bodies[b].mass.value;
  std::vector<double> rounding(topology.bodies.size());
  for (int i = topology.size() - 1; i >= 0; --i) {
    const TreeBody& body = topology.bodies[i];
    if (body.parent >= 0) carried[body.parent] += carried[i];
    rounding[i] = kRounding * carried[i] * (body.kind == FreedomKind::revolute ? extent * extent : 1);
  }
  return rounding;
}

/// Inertia that each free direction moves in a position.
std::vector<double> moved_inertia(NumericSystem& numbers, const Analysis& analysis, const std::vector<double>& z) {
  System<double>& system = numbers.at(z);
  const Topology& topology = system.topology;
  const std::vector<int> free = free_coordinates(topology, analysis);
  if (has_many_directions(free.size(), least_operations(topology, analysis).recursive))
    return inertias_by_recursion(system, analysis, free);
  const Kinematics<double> k = kinematics(system);
  const ReducedSystem<double> reduced =
      reduced_system(system, k, inertias(system, k), frozen_directions(system, k, analysis.blocks, analysis.driven),
                     std::vector<double>(topology.bodies.size(), 0.0));
  return solve_reduced(system, reduced).inertia;
}

/// Coordinates whose free motion has no inertia in every configuration, existence condition (9).
std::vector<int> without_inertia(NumericSystem& numbers, const Model& model, const Topology& topology,
                                 const Analysis& analysis, const std::vector<Configuration>& configurations) {
  const std::vector<int> names = free_coordinates(topology, analysis);
  const std::vector<double> rounding = rounding_of_inertia(model, topology);
  std::vector<bool> moved(names.size(), false);
  for (const Configuration& configuration : configurations) {
    const std::vector<double> inertia = moved_inertia(numbers, analysis, configuration.z);
    bool all = true;
    for (std::size_t q = 0; q < names.size(); ++q) {
      moved[q] = moved[q] || inertia[q] > rounding[names[q]];
      all = all && moved[q];
    }
    if (all) break;
  }
  std::vector<int> missing;
  for (std::size_t q = 0; q < names.size(); ++q)
    if (!moved[q]) missing.push_back(names[q]);
  return missing;
}

void mark_drives(const Model& model, const Topology& topology, Analysis& analysis) {
  analysis.driven.assign(topology.bodies.size(), false);
  analysis.motion_of.assign(topology.bodies.size(), -1);
  for (std::size_t m = 0; m < model.motions.size(); ++m)
    if (const int i = tree_coordinate(topology, model.motions[m].joint); i >= 0) {
      analysis.driven[i] = true;
      analysis.motion_of[i] = static_cast<int>(m);
    }
}

}  // namespace

Result<Analysis> analyse(const Model& model, const Topology& topology) {
  Analysis analysis;
  mark_drives(model, topology, analysis);
  NumericSystem numbers(model, topology);
  std::vector<Configuration> configurations = closed_configurations(numbers, wanted_configurations(topology));
  Findings found;
  for (const LoopBlock& block : topology.blocks) found.equations.push_back(closure_equations(model, topology, block));
  found.other_modes = stay_on_branch(numbers, found.equations, configurations);
  int position_rank_sum = 0;
  const std::vector<int> firsts = first_of_structure(numbers);
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    std::span<const PartitionCandidate> like;
    if (firsts[b] < static_cast<int>(b)) like = analysis.blocks[firsts[b]].candidates;
    analysis.blocks.push_back(analyse_block(numbers, b, configurations, like, analysis, found));
    analysis.blocks.back().first_alike = firsts[b];
    analysis.independent_equations += analysis.blocks.back().rank;
    if (found.problems.empty())
      position_rank_sum += position_rank(numbers, b, found.views.back(), analysis.blocks.back().rank, configurations);
  }
  if (!found.problems.empty()) return found.problems;
  set_quasi_partitions(numbers, configurations, analysis);
  complete_certificates(numbers, configurations, analysis, found);
  if (!found.problems.empty()) return found.problems;
  analysis.closed_configurations =
      static_cast<int>(std::count_if(configurations.begin(), configurations.end(), [](const Configuration& c) {
        return std::find(c.closed.begin(), c.closed.end(), false) == c.closed.end();
      }));
  analysis.ranks = ranks_together(found.views, configurations);
  analysis.degrees_of_freedom = topology.size() - analysis.independent_equations;
  analysis.position_freedoms = topology.size() - position_rank_sum;
  Diagnostics problems;
  for (int i : without_inertia(numbers, model, topology, analysis, configurations)) {
    const Joint& joint = model.joints[topology.bodies[i].joint];
    problems.push_back(problem(joint.where,
                               fmt::format("coordinate \"{}\" moves no inertia: its acceleration is not determined",
                                           topology.bodies[i].coordinate),
                               "give a body above this joint mass and inertia, or drive or remove the joint"));
  }
  if (!problems.empty()) return problems;
  set_actuation(numbers, configurations, analysis);
  return analysis;
}

}  // namespace mbgen
