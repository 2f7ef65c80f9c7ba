#pragma once
// Rods with mass that close loops (theory.md section 5).

#include "compiler/formulation/kinematics.hpp"

namespace mbgen {

/// Calls use(rod of the model, its constants) for every rod of a block that couples its ends by m_jk, with its loop as
/// the owner of the values.
template <class T, class Use>
void each_coupling_rod(const System<T>& system, const LoopBlock& block, const Use& use) {
  for (int l : block.loops) {
    const Loop& loop = system.topology.loops[l];
    if (loop.kind != ClosureKind::rod || is_zero(system.constants.rods[loop.rod].coupling)) continue;
    const auto heading = within_loop(system.annotator, l);
    use(system.model.rods[loop.rod], system.constants.rods[loop.rod]);
  }
}

}  // namespace mbgen
