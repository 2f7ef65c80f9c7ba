// The generic solver as integrators see it: with notices of singular positions, and without jumps.

#include "mbgen/motion.hpp"

#include <algorithm>
#include <cmath>

#include "mbgen/solver/shortest.hpp"
#include "runtime/generic/equations.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {
namespace {

/// Status of a block by its smallest pivot. Fails: loop_singular.
Status notice_of_block(int b, const BlockAnalysis& analysis, const SparseRows& jacobian, int columns) {
  const PivotedBlock block(analysis, jacobian, columns, analysis.rank);
  if (block.factors().rank < analysis.rank) return {Code::loop_singular, b};
  return solver_detail::notice_of(b, analysis.typical_pivot, smallest_pivot(block.factors()), kPivotThreshold<double>);
}

/// Shortest correction of a block with Phi_z x = right_hand_side.
std::vector<double> shortest(const BlockFactors& factors, const std::vector<double>& right_hand_side) {
  const std::vector<std::vector<double>> rz = factors.rz();
  const int free = static_cast<int>(rz.empty() ? 0 : rz[0].size());
  std::vector<double> x(rz.size(), 0.0), flat, gram(static_cast<std::size_t>(free) * free), along(free);
  for (const std::vector<double>& row : rz) flat.insert(flat.end(), row.begin(), row.end());
  factors.solve(right_hand_side, x);
  const int coordinates = static_cast<int>(rz.size());
  factorise_gram(coordinates, free, flat.data(), gram.data());
  shorten(coordinates, free, flat.data(), gram.data(), along.data(), x.data());
  return x;
}

std::vector<double> negative(std::vector<double> values) {
  for (double& value : values) value = -value;
  return values;
}

/// -Phi_z v of a block.
std::vector<double> negative_product(const SparseRows& jacobian, const std::vector<int>& joints,
                                     const std::vector<double>& v) {
  std::vector<double> result;
  for (const SparseRow<double>& row : jacobian) result.push_back(-product(row, joints, v));
  return result;
}

/// Change of a block by its pivots that are not small: Phi_z x = right_hand_side.
std::vector<double> by_large_pivots(const BlockAnalysis& analysis, const SparseRows& jacobian,
                                    const std::vector<double>& right_hand_side, std::vector<double> x) {
  const double least = kSingular<double> * analysis.typical_pivot;
  const int columns = static_cast<int>(x.size());
  const PivotedBlock whole(analysis, jacobian, columns, analysis.rank);
  int count = 0;
  const auto pivot = [&](int k) { return std::abs(loop_detail::row_of(whole.factors(), k)[k]); };
  while (count < whole.factors().rank && pivot(count) >= least) ++count;
  const PivotedBlock limited(analysis, jacobian, columns, count);
  std::vector<double> work(jacobian.size());
  solve_dependent(limited.factors(), right_hand_side.data(), x.data(), work.data());
  return x;
}

/// Smallest pivot of a block over its typical value, zero where it has less than its rank.
double clearance_of(const BlockAnalysis& analysis, const SparseRows& jacobian, int columns) {
  const PivotedBlock block(analysis, jacobian, columns, analysis.rank);
  return block.factors().rank < analysis.rank ? 0 : smallest_pivot(block.factors()) / analysis.typical_pivot;
}

/// Whether a block is on the other side of a singular position, see changes_side.
bool sides_differ(const BlockAnalysis& analysis, const SparseRows& from, const SparseRows& to, int columns) {
  const PivotedBlock block(analysis, from, columns, analysis.rank);
  const LoopFactors& loop = block.factors();
  const std::vector<double> start = written_out(from, columns), end = written_out(to, columns);
  std::vector<double> product(static_cast<std::size_t>(loop.rank) * loop.rank);
  std::vector<int> row_places(loop.rank), column_places(loop.rank);
  std::vector<unsigned char> driven(static_cast<std::size_t>(columns), 0);
  for (const int c : analysis.driven) driven[static_cast<std::size_t>(c)] = 1;
  return changes_side(loop, start.data(), end.data(), driven.data(),
                      {product.data(), row_places.data(), column_places.data()});
}

Closures closures_at(const GenericState& state, GenericEquations& equations) {
  System<double>& system = equations.system(state);
  return equations.closures(system, kinematics(system));
}

/// Entries of a block's joints.
std::vector<double> of_joints(const std::vector<int>& joints, const std::vector<double>& values) {
  std::vector<double> result;
  for (const int j : joints) result.push_back(values[static_cast<std::size_t>(j)]);
  return result;
}

}  // namespace

Status GenericSolver::notice(const GenericState& state) const {
  const Closures closures = closures_at(state, *equations_);
  Status result;
  for (std::size_t b = 0; b < closures.size(); ++b) {
    const Status of_block = notice_of_block(static_cast<int>(b), equations_->analysis.blocks[b], closures[b].jacobian,
                                            equations_->columns(b));
    if (!of_block.ok()) return of_block;
    result = graver(result, of_block);
  }
  return result;
}

Status GenericSolver::notice_of_factors(const GenericState& state) const {
  const GenericEquations& equations = *equations_;
  const bool is_known = equations.algebra.smallest_pivot &&
                        std::all_of(equations.analysis.blocks.begin(), equations.analysis.blocks.end(),
                                    [](const BlockAnalysis& block) { return block.late.equations.empty(); });
  if (!is_known) return notice(state);
  Status result;
  for (std::size_t b = 0; b < equations.analysis.blocks.size(); ++b)
    result = graver(result, solver_detail::notice_of(static_cast<int>(b), equations.analysis.blocks[b].typical_pivot,
                                                     equations.algebra.smallest_pivot(b), kPivotThreshold<double>));
  return result;
}

Status GenericSolver::without_jump(const GenericState& closed, GenericState& state, bool is_factorised) const {
  for (std::size_t b = 0; b < equations_->topology.blocks.size(); ++b) {
    for (const int j : equations_->topology.blocks[b].joints) {
      const bool jumps = !(std::abs(closed.z[j] - state.z[j]) <= kLargestCorrection<double>);
      if (jumps && !equations_->analysis.driven[j]) return {Code::loop_not_closed, static_cast<int>(b)};
    }
  }
  const Status status = is_factorised ? notice_of_factors(closed) : notice(closed);
  if (status.ok()) state = closed;
  return status;
}

Status GenericSolver::solve_motion(const GenericState& state, GenericDerivative& derivative) const {
  const Status status = accelerations(state, std::vector<double>(state.z.size(), 0.0), derivative);
  return status.ok() ? notice_of_factors(state) : status;
}

Status GenericSolver::project_motion(GenericState& state) const {
  GenericState closed = state;
  const Status status = project(closed);
  return status.ok() ? without_jump(closed, state, true) : status;
}

Status GenericSolver::project_nearest(GenericState& state) const {
  if (const Status status = equations_->check_arguments(state, {}); !status.ok()) return status;
  GenericState closed = state;
  double previous = INFINITY;
  for (bool gains = true; gains;) {
    System<double>& system = equations_->system(closed);
    if (const Status status = GenericEquations::follow_motions(system, closed); !status.ok()) return status;
    const Closures& closures = equations_->closures_to_factorise(system, kinematics(system), equations_->rest);
    double size = 0;
    for (const SparseClosure<double>& block : closures) size = std::max(size, largest_absolute(block.residual));
    gains = size > 0 && size < 0.5 * previous;
    previous = size;
    for (std::size_t b = 0; b < closures.size(); ++b) {
      const std::vector<int>& joints = equations_->topology.blocks[b].joints;
      if (!gains && !(largest_absolute(closures[b].residual) <= kRoundingFloor<double>)) {
        return {Code::loop_not_closed, static_cast<int>(b)};
      }
      const BlockFactors factors = equations_->factors(b, closures[b]);
      if (factors.rank() < equations_->analysis.blocks[b].rank) return {Code::loop_singular, static_cast<int>(b)};
      // Positions while they gain, then velocities.
      const std::vector<double> open =
          gains ? negative(closures[b].residual) : negative_product(closures[b].jacobian, joints, closed.zd);
      const std::vector<double> x = shortest(factors, open);
      for (std::size_t c = 0; c < joints.size(); ++c) (gains ? closed.z : closed.zd)[joints[c]] += x[c];
    }
  }
  const Status status = equations_->check_arguments(closed, {});
  return status.ok() ? without_jump(closed, state, false) : status;
}

Status GenericSolver::project_crossing(GenericState& state, double& clearance) const {
  if (const Status status = equations_->check_arguments(state, {}); !status.ok()) return status;
  const double tolerance = kSlightCorrection<double> * equations_->model.solver.closure_tolerance;
  GenericState closed = state;
  double previous = INFINITY;
  clearance = INFINITY;
  for (bool is_open = true, is_first = true; is_open; is_first = false) {
    System<double>& system = equations_->system(closed);
    if (const Status status = GenericEquations::follow_motions(system, closed); !status.ok()) return status;
    const Closures closures = equations_->closures(system, kinematics(system));
    double size = 0;
    int open = -1;
    for (std::size_t b = 0; b < closures.size(); ++b) {
      const double of_block = largest_absolute(closures[b].residual);
      if (!(of_block <= size)) size = of_block, open = static_cast<int>(b);
    }
    is_open = !(size <= tolerance);
    for (std::size_t b = 0; is_first && b < closures.size(); ++b)
      clearance = std::min(clearance,
                           clearance_of(equations_->analysis.blocks[b], closures[b].jacobian, equations_->columns(b)));
    if (is_open && !(size < 0.5 * previous)) return {Code::loop_singular, open};
    previous = size;
    for (std::size_t b = 0; b < closures.size(); ++b) {
      const BlockAnalysis& analysis = equations_->analysis.blocks[b];
      const std::vector<int>& joints = equations_->topology.blocks[b].joints;
      const std::vector<double> still(joints.size(), 0.0), none(closures[b].residual.size(), 0.0);
      const std::vector<double> x =
          is_open ? by_large_pivots(analysis, closures[b].jacobian, negative(closures[b].residual), still)
                  : by_large_pivots(analysis, closures[b].jacobian, none, of_joints(joints, closed.zd));
      for (std::size_t c = 0; c < joints.size(); ++c) {
        if (is_open)
          closed.z[joints[c]] += x[c];
        else
          closed.zd[joints[c]] = x[c];
      }
    }
  }
  const Status status = equations_->check_arguments(closed, {});
  if (status.ok()) state = closed;
  return status;
}

int GenericSolver::changed_side(const GenericState& from, const GenericState& to) const {
  const Closures start = closures_at(from, *equations_), end = closures_at(to, *equations_);
  for (std::size_t b = 0; b < start.size(); ++b) {
    const BlockAnalysis& analysis = equations_->analysis.blocks[b];
    if (sides_differ(analysis, start[b].jacobian, end[b].jacobian, equations_->columns(b))) return static_cast<int>(b);
  }
  return -1;
}

Status GenericSolver::watch_way(const GenericState& from, const GenericState& to, double h,
                                const WayLimits& limits) const {
  double moved = 0;
  std::vector<LoopWay> ways;
  for (const LoopBlock& block : equations_->topology.blocks) {
    LoopWay& way = ways.emplace_back();
    for (const int j : block.joints) {
      way.add(from.zd[j], to.zd[j]);
      moved += (to.z[j] - from.z[j]) * (to.z[j] - from.z[j]);
    }
  }
  if (limits.least > 0 && moved <= limits.least * limits.least) return {};
  const Closures start = closures_at(from, *equations_), end = closures_at(to, *equations_);
  for (std::size_t b = 0; b < ways.size(); ++b) {
    const BlockAnalysis& analysis = equations_->analysis.blocks[b];
    const int columns = equations_->columns(b);
    const double clearance =
        std::min(clearance_of(analysis, start[b].jacobian, columns), clearance_of(analysis, end[b].jacobian, columns));
    if (h * ways[b].fastest <= limits.most * clearance) continue;
    const std::size_t fixed = static_cast<std::size_t>(analysis.rank) + analysis.driven.size();
    const bool is_free = equations_->topology.blocks[b].joints.size() > fixed || limits.aside == 0;
    if (is_free && ways[b].turns(limits)) return {Code::loop_singular, static_cast<int>(b)};
    if (sides_differ(analysis, start[b].jacobian, end[b].jacobian, columns))
      return {Code::singular_met, static_cast<int>(b)};
  }
  return {};
}

}  // namespace mbgen
