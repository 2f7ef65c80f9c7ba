#include "runtime/generic/model_closures.hpp"

#include <algorithm>

namespace mbgen {
namespace {

int column_of(const LoopBlock& block, int joint) {
  return static_cast<int>(std::lower_bound(block.joints.begin(), block.joints.end(), joint) - block.joints.begin());
}

}  // namespace

ModelClosures::ModelClosures(const Topology& topology) : topology_(topology) {
  for (const LoopBlock& block : topology.blocks) {
    loops_.emplace_back();
    for (const int l : block.loops) {
      const Loop& loop = topology.loops[l];
      Place place{l, {}, {}};
      if (loop.kind != ClosureKind::coupling) {
        for (const int j : loop.joints) {
          place.movers.push_back({j, on_path(topology, loop.body_from, j), j == loop.length});
          place.columns.push_back(column_of(block, j));
        }
      }
      loops_.back().push_back(std::move(place));
    }
  }
}

void ModelClosures::evaluate(System<double>& system, const Kinematics<double>& k, const RelativeMotion<double>& motion,
                             Closures& closures) const {
  closures.resize(loops_.size());
  for (std::size_t b = 0; b < loops_.size(); ++b) {
    const LoopBlock& block = topology_.blocks[b];
    SparseClosure<double>& closed = closures[b];
    closed.residual.clear();
    closed.acceleration.clear();
    closed.jacobian.resize(static_cast<std::size_t>(block.equations));
    for (const Place& place : loops_[b]) {
      const Loop& loop = topology_.loops[place.loop];
      if (loop.kind == ClosureKind::coupling) {
        SparseClosure<double> one;
        add_coupling(
            system, loop, [&](int joint) { return column_of(block, joint); }, one);
        closed.jacobian[closed.residual.size()] = std::move(one.jacobian[0]);
        closed.residual.push_back(one.residual[0]);
        closed.acceleration.push_back(one.acceleration[0]);
        continue;
      }
      for (const detail::Row<double>& row : detail::loop_rows(system, k, motion, loop, block.base)) {
        SparseRow<double>& entries = closed.jacobian[closed.residual.size()];
        entries.columns = place.columns;
        entries.values.clear();
        for (const Mover& m : place.movers)
          entries.values.push_back(m.is_length    ? -1.0
                                   : m.moves_from ? dot(k.column[m.joint], row.wrench_from)
                                                  : -dot(k.column[m.joint], row.wrench_to));
        closed.residual.push_back(row.residual);
        closed.acceleration.push_back(-row.acceleration);
      }
    }
  }
}

}  // namespace mbgen
