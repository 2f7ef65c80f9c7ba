#include "compiler/analysis/contradiction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "compiler/algebra/dense.hpp"
#include "compiler/analysis/misalignment.hpp"
#include "compiler/analysis/self_stress.hpp"
#include "compiler/analysis/violation.hpp"

namespace mbgen {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kShake = 0.3;        // rad, or times the lever arm: opens every loop
constexpr double kIdentity = 1e-9;    // residual, from rounding, of an equation that always holds
constexpr double kWeakLoop = 0.01;    // margin of a loop that moves but for a joint, with equations to spare
constexpr double kJointStill = 1e-6;  // share of a freedom below which a joint has none, as in certificate.cpp
constexpr int kFlatRank = 2;          // equations that close a loop of a flat linkage
constexpr double kDoubtful = 1e-4;    // margin of others that move: points of 4 digits open a redundant equation so far
constexpr double kHeld = 1e-6;        // margin where nothing is in doubt: closed to 1e-11, the position is sure to 1e-5

/// The direction in which a part with one equation less moves: the one that its weakest equation hinders least.
VectorXd easiest_direction(const MatrixXd& jacobian, const std::vector<int>& kept, int rank) {
  VectorXd direction = right_singular_vectors(jacobian).vectors.col(rank - 1);
  if (!kept.empty()) {
    const MatrixXd free = null_space(jacobian(kept, Eigen::all), rank - 1);
    direction = (free * (free.transpose() * direction)).eval();
  }
  return direction / direction.cwiseAbs().maxCoeff();
}

/// Rows of velocities alone are never open: the way that they slip on a motion stands for what they hinder.
void add_slip(const LoopBlock& block, const PartView& view, std::size_t s, const std::vector<double>& from,
              const std::vector<double>& to, VectorXd& residual) {
  if (view.late.empty()) return;
  VectorXd way(view.part.columns.size());
  for (Eigen::Index c = 0; c < way.size(); ++c) {
    const int j = block.joints[view.part.columns[static_cast<std::size_t>(c)]];
    way[c] = (to[j] - from[j]) / view.column_scale[c];
  }
  for (const int r : view.late) residual[r] = view.jacobians[s].row(r).dot(way) / view.row_scale[r];
}

/// Leaves out the weakest equation that counts as rank and all redundant ones, moves the part by a finite step with the
/// others closed, and says which of those left out opens most.
Violation release(NumericSystem& numbers, std::size_t b, const PartView& view, std::size_t s,
                  const std::vector<double>& start) {
  const LoopBlock& block = numbers.topology().blocks[b];
  const std::vector<int> kept = strongest_rows(view.jacobians[s], view.rank - 1, view.late);
  const VectorXd direction = easiest_direction(view.jacobians[s], kept, view.rank);
  std::vector<std::vector<int>> equations(numbers.topology().blocks.size());
  for (int r : kept) equations[b].push_back(view.part.rows[r]);
  VectorXd residual = kStep * (view.jacobians[s] * direction).cwiseQuotient(view.row_scale);  // to first order
  Violation violation;
  direction.cwiseAbs().maxCoeff(&violation.coordinate);
  violation.motion = kStep * view.column_scale[violation.coordinate];
  violation.coordinate = block.joints[view.part.columns[violation.coordinate]];
  for (double step = kStep; step > kShortestStep; step /= 2) {
    std::vector<double> z = start;
    move(block, view, step * direction, z);
    const Configuration moved = close_equations(numbers, std::move(z), equations);
    int coordinate = 0;
    const double length = distance(block, view, start, moved.z, coordinate);
    if (!moved.closed[b] || length < step / 2 || length > 2 * step) continue;
    residual = moved.residuals[b](view.part.rows);
    add_slip(block, view, s, start, moved.z, residual);
    violation.coordinate = coordinate;
    violation.motion = std::abs(moved.z[coordinate] - start[coordinate]);
    break;
  }
  residual.cwiseAbs().maxCoeff(&violation.equation);
  violation.residual = std::abs(residual[violation.equation]);
  violation.equation = view.part.rows[violation.equation];
  return violation;
}

/// True when the combinations of equations that are redundant at a closed position stay satisfied with all loops open:
/// geometry makes them hold, as out of the plane of a flat truss, and no length or angle can contradict them.
bool always_hold(NumericSystem& numbers, std::size_t b, const PartView& view, std::size_t s,
                 const std::vector<double>& start) {
  const MatrixXd left = left_singular_vectors(view.jacobians[s]).vectors;
  const MatrixXd redundant = left.rightCols(view.jacobians[s].rows() - view.rank);
  std::mt19937_64 random(20120403);
  for (int trial = 0; trial < 3; ++trial) {
    VectorXd direction(view.part.columns.size());
    for (double& d : direction) d = kShake * (static_cast<double>(random() >> 11) * 0x1p-52 - 1.0);
    Configuration open;
    open.z = start;
    move(numbers.topology().blocks[b], view, direction, open.z);
    evaluate_closures(numbers, open);
    const VectorXd residual = view.row_scale.cwiseProduct(open.residuals[b](view.part.rows));
    if (!((redundant.transpose() * residual).cwiseAbs().maxCoeff() < kIdentity)) return false;
  }
  return true;
}

/// True when a loop would have one freedom more, were it not for one axis that the others do not share: a loop of pins
/// and slides never turns about such an axis.
bool one_axis_locks(const Model& model, const Topology& topology, const PartView& view) {
  if (view.part.loops.size() > 1 || view.rank <= kFlatRank) return false;
  const std::optional<Misalignment> off = misaligned_joint(model, topology, view.part.loops);
  return off && (view.locked() || (off->all_single && off->angle < kMeantParallel));
}

/// True when a single loop moves, but not one of its joints: as with pins that are nearly parallel.
bool costs_a_joint(const PartView& view, std::size_t s) {
  if (view.part.loops.size() > 1) return false;
  const MatrixXd free = null_space(view.jacobians[s], view.rank);
  return (free.rowwise().norm().array() < kJointStill).any();
}

/// Whether nothing moves and no axis is nearly parallel to the others: redundant equations were found to agree before.
bool is_structure(const Model& model, const Topology& topology, const PartView& view) {
  if (!view.locked()) return false;
  const std::optional<Misalignment> off = misaligned_joint(model, topology, view.part.loops);
  return !off || off->angle >= kMeantParallel;
}

/// Fault of the equations that hold a part; empty for none. Where all equations are independent, only a position
/// that they do not determine is wrong.
std::string fault(NumericSystem& numbers, std::size_t b, const PartView& view, std::size_t s,
                  const std::vector<double>& start) {
  const Topology& topology = numbers.topology();
  const std::vector<int>& loops = view.part.loops;
  const bool surplus = static_cast<int>(view.part.rows.size()) > view.rank;
  if (surplus && view.locked() && !always_hold(numbers, b, view, s, start) &&
      !redundancy_holds(numbers, b, view, s, start))
    return fmt::format("redundant equations of {} contradict each other: {} equations hold {} coordinate{}",
                       loops_text(topology, loops), view.part.rows.size(), view.part.columns.size(),
                       view.part.columns.size() == 1 ? "" : "s");
  if (surplus && one_axis_locks(numbers.model(), topology, view))
    return "one axis " + (view.locked() ? "keeps " + loops_text(topology, loops) + " from moving"
                                        : "costs " + loops_text(topology, loops) + " a freedom");
  const double least = is_structure(numbers.model(), topology, view)         ? kHeld
                       : surplus && !view.locked() && costs_a_joint(view, s) ? kWeakLoop
                                                                             : kDoubtful;
  if (view.margin(view.best()) >= least) return "";
  const std::string names = loops_text(topology, loops);
  if (view.locked()) return fmt::format("{} cannot move but {} barely held", names, loops.size() == 1 ? "is" : "are");
  return fmt::format("{} {} a freedom to an equation that barely holds", names, loops.size() == 1 ? "loses" : "lose");
}

/// The contradiction in a part, if there is one.
Diagnostics contradiction(NumericSystem& numbers, std::size_t b, const PartView& view,
                          const std::vector<ClosureEquation>& equations,
                          const std::vector<Configuration>& configurations) {
  if (view.rank == 0) return {};
  const std::size_t s = view.ranks[0] == view.rank ? 0 : view.best();
  const std::vector<double>& start = configurations[view.configurations[s]].z;
  const std::string wrong = fault(numbers, b, view, s, start);
  if (wrong.empty()) return {};
  const Violation violation = release(numbers, b, view, s, start);
  if (!(violation.residual > kContradiction)) return {};  // nothing opens: the equations agree
  return {
      refusal(numbers.model(), numbers.topology(), view.part.loops, wrong, violation, equations[violation.equation])};
}

}  // namespace

Diagnostics contradictions(NumericSystem& numbers, std::size_t b, const PartView& whole,
                           const std::vector<int>& immobile, const std::vector<ClosureEquation>& equations,
                           const std::vector<Configuration>& configurations) {
  const Topology& topology = numbers.topology();
  const LoopBlock& block = topology.blocks[b];
  std::vector<std::vector<int>> sets;
  for (int l : block.loops) sets.push_back({l});
  const std::size_t alone = sets.size();
  std::vector<int> locked;
  for (int l : block.loops) {
    const std::vector<int>& columns = block_part(topology, block, {l}).columns;
    if (std::all_of(columns.begin(), columns.end(), [&](int c) { return contains(immobile, c); })) locked.push_back(l);
  }
  for (std::vector<int>& group : connected(topology, locked))
    if (group.size() > 1) sets.push_back(std::move(group));
  if (block.loops.size() > 1 && !is_large(block)) sets.push_back(block.loops);
  Diagnostics problems;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (i >= alone && !problems.empty()) break;                       // loops together repeat what a loop alone said
    const PartView part = sets[i] == block.loops && !is_large(block)  // the view of a large block has no Jacobians
                              ? whole
                              : view(numbers, b, block_part(topology, block, sets[i]), equations, configurations);
    for (Diagnostic& problem : contradiction(numbers, b, part, equations, configurations)) {
      const auto same = [&](const Diagnostic& other) { return other.where.pointer == problem.where.pointer; };
      if (std::none_of(problems.begin(), problems.end(), same)) problems.push_back(std::move(problem));
    }
  }
  return problems;
}

}  // namespace mbgen
