#include "runtime/generic/loop_algebra.hpp"

#include <algorithm>
#include <stdexcept>

namespace mbgen {

LoopShape loop_shape(const Topology& topology, const Analysis& analysis) {
  LoopShape shape;
  shape.coordinates = topology.size();
  shape.blocks.resize(topology.blocks.size());
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    const LoopBlock& source = topology.blocks[b];
    BlockShape& block = shape.blocks[b];
    block.joints = source.joints;
    block.driven = analysis.blocks[b].driven;
    for (int c = 0; c < static_cast<int>(block.joints.size()); ++c)
      if (std::find(block.driven.begin(), block.driven.end(), c) == block.driven.end()) block.movable.push_back(c);
    block.equations = source.equations;
    block.rank = analysis.blocks[b].rank;
    block.first_equation = shape.equations;
    shape.equations += block.equations;
  }
  for (const JointGroup& group : topology.groups) {
    if (group.block >= 0) {
      BlockShape& block = shape.blocks[group.block];
      block.first_direction = shape.directions;
      shape.directions += block.directions();
    } else if (!analysis.driven[group.joints[0]]) {
      shape.free_joints.push_back({group.joints[0], shape.directions++});
    }
  }
  return shape;
}

LoopAlgebra make_loop_algebra(const GenericAlgebra& choice, const Model& model, const Topology& topology,
                              const Analysis& analysis) {
  const bool is_qr = choice.factorisation == Factorisation::qr;
  switch (choice.library) {
    case LinearAlgebra::entries:
      return is_qr ? eigen_qr_algebra(topology, analysis) : entries_algebra(model, topology, analysis);
    case LinearAlgebra::eigen:
      return is_qr ? eigen_qr_algebra(topology, analysis) : eigen_lu_algebra(topology, analysis);
    case LinearAlgebra::blas:
      if (!is_qr) return blas_algebra(topology, analysis);
      break;
    case LinearAlgebra::sparse:
      if (!is_qr) return sparse_algebra(model, topology, analysis);
      break;
  }
  throw std::invalid_argument("QR is there with Eigen only");
}

}  // namespace mbgen
