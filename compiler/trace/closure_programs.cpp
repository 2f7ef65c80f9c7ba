#include <optional>

#include "compiler/trace/each_program.hpp"
#include "compiler/trace/tracing.hpp"

namespace mbgen {
namespace {

/// Closure terms of the blocks over joint rates, in the form that the tracing is in.
class Closures {
 public:
  Closures(Tracing& tracing, const Kinematics<Expr>& k)
      : system_(tracing.system), k_(k), relative_(mbgen::at_rest<Expr>(tracing.system.topology)) {
    if (tracing.form == Form::matrix) return;
    work_.emplace(recursion_work(system_, tracing.recursion, k));
    rates_ = tracing.in(Step::velocities, [&] { return quasi_velocities(*work_); });
    units_.resize(system_.topology.blocks.size());
    for (const RecursionUnit& unit : tracing.recursion.units)
      if (unit.block >= 0) units_[unit.block] = &unit;
  }
  /// Residual and Jacobian.
  SparseClosure<Expr> at_rest(std::size_t b) {
    if (!work_) return sparse_closure(system_, k_, system_.topology.blocks[b], relative_);
    const RecursionUnit& unit = *units_[b];
    return near_closure(*work_, unit, PerBody<Spatial<Expr>>(unit), PerBody<BodyAcceleration<Expr>>(unit),
                        Columns::rates);
  }
  /// All terms.
  SparseClosure<Expr> moving(std::size_t b) {
    if (!work_) {
      set_relative_motion(system_, k_, system_.topology.blocks[b], relative_);
      return sparse_closure(system_, k_, system_.topology.blocks[b], relative_);
    }
    const RecursionUnit& unit = *units_[b];
    const PerBody<Spatial<Expr>> velocity = block_motion(*work_, unit, rates_);
    return near_closure(*work_, unit, velocity, rate_bias(*work_, unit, velocity), Columns::rates);
  }

 private:
  System<Expr>& system_;
  const Kinematics<Expr>& k_;
  RelativeMotion<Expr> relative_;
  std::optional<RecursionWork<Expr>> work_;  ///< the recursive form alone
  std::vector<Expr> rates_;
  std::vector<const RecursionUnit*> units_;  ///< per block
};

/// Phi_z zd per equation.
std::vector<Expr> rates_of(const System<Expr>& system, const SparseClosure<Expr>& closed, const LoopBlock& block) {
  std::vector<Expr> rates;
  for (const SparseRow<Expr>& row : closed.jacobian) {
    rates.emplace_back(0.0);
    for (std::size_t i = 0; i < row.columns.size(); ++i)
      rates.back() += row.values[i] * system.zd(block.joints[row.columns[i]]);
  }
  return rates;
}

/// Consistent velocities of a block: per coordinate, of the dependent ones. given: independent coordinates, then driven
/// ones; zd: per coordinate, of these. Where partitions are chosen again, Rz becomes an output: steps shorten
/// corrections with it.
std::vector<Expr> consistent_velocities(Tracing& tracing, const SparseClosure<Expr>& closed,
                                        const FrozenFactors<Expr>& factors, std::size_t b,
                                        const std::vector<int>& given, const std::vector<Expr>& zd) {
  const BlockAnalysis& partition = tracing.analysis.blocks[b];
  if (!chooses_again(tracing.system.topology)) {
    const std::vector<Expr> still(closed.residual.size(), Expr(0.0));
    return solve_frozen(factors, partition, moved_over(closed.jacobian, still, given, zd), zd.size());
  }
  const auto rz = tracing.in(Step::projection, [&] { return frozen_rz(factors, partition, zd.size(), given); });
  name_rz(tracing.system, {tracing.system.topology, tracing.system.topology.blocks[b].joints}, rz);
  const std::size_t free = partition.independent.size();
  std::vector<Expr> velocity;
  for (std::size_t c = 0; c < zd.size(); ++c) {
    for (std::size_t q = 0; q < free; ++q)
      tracing.output(of_block(Array::Rz, b), static_cast<int>(c * free + q), rz[c][q]);
    velocity.emplace_back(0.0);
    for (std::size_t q = 0; q < given.size(); ++q) velocity.back() += rz[c][q] * zd[given[q]];
  }
  return velocity;
}

}  // namespace

Program trace_closure(const Model& model, const Topology& topology, const Analysis& analysis, Form form,
                      Spelling spelling) {
  Tracing tracing(Role::closure, model, topology, analysis, form, {}, spelling);
  System<Expr>& system = tracing.system;
  std::vector<Expr> dz(topology.size(), Expr(0.0)), zd = system.environment.zd, residual;
  tracing.in(Step::inertias, [&] {
    for (const Drive<Expr>& d : tracing.drive) {
      dz[d.coordinate] = d.position - system.z(d.coordinate);
      zd[d.coordinate] = d.velocity;
    }
  });
  const Kinematics<Expr> k = tracing.poses();
  Closures closures(tracing, k);
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    const LoopBlock& block = topology.blocks[b];
    const BlockAnalysis& partition = analysis.blocks[b];
    const auto [closed, factors] = tracing.in(Step::jacobian, [&] {
      SparseClosure<Expr> rows = closures.at_rest(b);
      FrozenFactors<Expr> pivots = factorise_frozen(rows.jacobian, partition, block.joints.size());
      name_pivots(system, {topology, block.joints}, partition, pivots);
      return std::pair(std::move(rows), std::move(pivots));
    });
    const auto step = tracing.annotator.step(Step::velocities);
    const auto heading = within_block(tracing.annotator, b);
    std::vector<Expr> open, known_z, known_zd;
    for (const Expr& value : closed.residual) open.push_back(-value);
    for (int j : block.joints) {
      known_z.push_back(dz[j]);
      known_zd.push_back(zd[j]);
    }
    std::vector<int> known = partition.independent;
    known.insert(known.end(), partition.driven.begin(), partition.driven.end());
    const auto correction = solve_frozen(
        factors, partition, moved_over(closed.jacobian, open, partition.driven, known_z), block.joints.size());
    const auto velocity = consistent_velocities(tracing, closed, factors, b, known, known_zd);
    for (int c : partition.dependent) {
      dz[block.joints[c]] = correction[c];
      zd[block.joints[c]] = velocity[c];
    }
    residual.insert(residual.end(), closed.residual.begin(), closed.residual.end());
    tracing.output_pivot(b, factors.quality);
  }
  for (const Drive<Expr>& d : tracing.drive) residual.push_back(dz[d.coordinate]);
  tracing.outputs(Array::residual, residual);
  tracing.outputs(Array::dz, dz);
  tracing.outputs(Array::zd, zd);
  return tracing.builder.finish_in_canonical_order();
}

Program trace_closure_terms(const Model& model, const Topology& topology, const Analysis& analysis, Form form,
                            Spelling spelling) {
  Tracing tracing(Role::closure_terms, model, topology, analysis, form, {}, spelling);
  System<Expr>& system = tracing.system;
  const Kinematics<Expr> k = tracing.poses();
  Closures closures(tracing, k);
  const bool again = chooses_again(topology);
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    const LoopBlock& block = topology.blocks[b];
    const auto step = tracing.annotator.step(Step::jacobian);
    const SparseClosure<Expr> closed = closures.moving(b);
    tracing.outputs(of_block(Array::Phi, b), closed.residual);
    tracing.outputs(of_block(Array::c, b), closed.acceleration);
    if (!again) {
      tracing.outputs(of_block(Array::rate, b), rates_of(system, closed, block));
      continue;
    }
    const SlotGroup group = of_block(Array::Jz, b);
    int first = 0;
    for (const SparseRow<Expr>& row : closed.jacobian) {
      for (int c = 0; c < static_cast<int>(block.joints.size()); ++c) tracing.output(group, first++, row.at(c));
    }
  }
  for (const Drive<Expr>& d : tracing.drive) tracing.output(Array::driven_acceleration, d.coordinate, d.acceleration);
  return tracing.builder.finish_in_canonical_order();
}

}  // namespace mbgen
