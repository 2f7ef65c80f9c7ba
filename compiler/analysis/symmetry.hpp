#pragma once
// Left and right of a mechanism: a mirror plane, and which body and coordinate is the mirror image of which.

#include <vector>

#include "compiler/formulation/constants.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// A reflection in the plane normal . x = offset, global at the reference configuration, that takes joints of the tree
/// to joints of the tree. It need not take all: a body without image has none on it either. Loops and forces are not
/// compared.
struct Mirror {
  Vector3 normal{};         ///< unit; zero: the mechanism has no mirror
  double offset = 0;        ///< m
  std::vector<int> image;   ///< per tree body: its mirror image, itself on the plane, -1: none; its own inverse
  std::vector<int> sign;    ///< per tree body: z of the image is sign z, 1 or -1; 0 without image
  std::vector<bool> equal;  ///< per tree body: its mass, centre of mass and inertia are those of its image, reflected
  bool found() const { return normal != Vector3{}; }
};

/// The plane that takes most bodies to other ones. Compared are kind, origin and axis of the joints, to kMirrorShare of
/// the mechanism's extent. Cost: quadratic in the bodies with mass.
Mirror find_mirror(const Topology& topology, const Constants<double>& constants);

/// The same of a model at default parameters.
Mirror find_mirror(const Model& model, const Topology& topology);

/// Whether a set of a block's columns (local, ascending) holds the image of each that has its image in the block, and
/// there is a pair to speak of.
bool is_symmetric(const Mirror& mirror, const LoopBlock& block, const std::vector<int>& columns);

}  // namespace mbgen
