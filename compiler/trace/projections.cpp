#include "compiler/trace/projections.hpp"

#include "compiler/trace/tracing.hpp"

namespace mbgen {

Role role_of(Partition partition) {
  return partition == Partition::frozen ? Role::accelerations : Role::accelerations_chosen;
}

GroupProjection<Expr> chosen_projection(Tracing& tracing, std::size_t block) {
  GroupProjection<Expr> chosen;
  const int free = static_cast<int>(tracing.analysis.blocks[block].independent.size());
  const int columns = static_cast<int>(tracing.system.topology.blocks[block].joints.size());
  for (int c = 0; c < columns; ++c) {
    chosen.zdd_star.push_back(tracing.input(of_block(Array::zdd_star, block), c));
    chosen.rz.emplace_back();
    for (int q = 0; q < free; ++q) chosen.rz.back().push_back(tracing.input(of_block(Array::Rz, block), c * free + q));
  }
  return chosen;
}

GroupProjection<Expr> single_projection(const Tracing& tracing, int joint) {
  for (const Drive<Expr>& d : tracing.drive)
    if (d.coordinate == joint) return {{{}}, {d.acceleration}};
  return {{{Expr(1.0)}}, {Expr(0.0)}};
}

}  // namespace mbgen
