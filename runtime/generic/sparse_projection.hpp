#pragma once
// Rz of all coordinates by its entries (61), and the products of (63) that follow the path matrix.

#include <vector>

#include "runtime/generic/loop_algebra.hpp"

namespace mbgen {

/// An entry of Rz in the column of some direction.
struct RzEntry {
  int coordinate = 0;
  double value = 0;
};

/// Rz of one model. Columns of free joints stand; those of the blocks' directions are for the algebra to fill.
class SparseProjection {
 public:
  SparseProjection(const Model& model, const Topology& topology, const LoopShape& shape);
  std::vector<RzEntry>& column(int direction) { return rz_[static_cast<std::size_t>(direction)]; }
  /// Members of LoopAlgebra. Cost of reduce: entries of M in the rows of each direction's coordinates, and entries of
  /// the directions that it is coupled with.
  void reduce(const TreeMass& mass, const std::vector<double>& q, ReducedEquations& reduced);
  void add_rz_times(const Eigen::VectorXd& free, std::vector<double>& x) const;

 private:
  /// An entry of M in the row of some coordinate.
  struct MassEntry {
    int column = 0, source = 0;  ///< source: index into TreeMass
  };
  void couple_directions(const Topology& topology, const LoopShape& shape);

  std::vector<std::vector<MassEntry>> mass_rows_;  ///< columns of the coordinate's own group and of those below it
  std::vector<std::vector<RzEntry>> rz_;           ///< per direction
  std::vector<std::vector<int>> coupled_;          ///< per direction: those up to it that M couples it with
  std::vector<double> row_;
};

}  // namespace mbgen
