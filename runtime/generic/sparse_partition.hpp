#pragma once
// Which columns of all loops depend on which, as one sparse system that KLU factorises.

#include <memory>
#include <vector>

#include "runtime/generic/klu_factors.hpp"
#include "runtime/generic/loop_algebra.hpp"

namespace mbgen {

/// Local columns and equations of one block: as many dependent columns as equations.
struct BlockPartition {
  std::vector<int> equations, dependent, free;
};

/// Phi_d of all blocks as one matrix, and the columns beside it. Free directions of different blocks have no row in
/// common, so they share the columns of one right-hand side.
class PartitionedJacobian {
 public:
  PartitionedJacobian(const Topology& topology, const LoopShape& shape, std::vector<BlockPartition> partition);

  /// Takes the values of a state. Result: smallest over largest pivot of Phi_d.
  double factorise(const Closures& closures);
  /// Sets the dependent entries of x, per coordinate, so that Phi_z x = right_hand_side.
  void solve(const PerBlock& right_hand_side, std::vector<double>& x);
  /// Phi_d^-1 Phi_i: row k belongs to dependent_coordinates()[k], column q to the q-th direction of its block.
  const std::vector<double>& dependence();

  const std::vector<BlockPartition>& partition() const { return partition_; }
  int rank() const { return static_cast<int>(dependent_coordinates_.size()); }
  /// Row of Phi_d at which a block begins.
  int first_row(std::size_t block) const { return first_row_[block]; }

 private:
  struct Entry {
    int block, equation, column;
  };
  /// An entry beside Phi_d.
  struct OtherEntry {
    Entry source;
    int row;         ///< of Phi_d
    int coordinate;  ///< of its column
    int direction;   ///< of its block, -1 when driven
    double value;
  };
  void add_column(const LoopShape& shape, const std::vector<std::vector<bool>>& touches, int block, int column,
                  int direction);

  std::vector<BlockPartition> partition_;
  std::vector<int> first_row_, dependent_coordinates_;
  std::vector<Entry> entries_;  ///< of Phi_d, column by column
  std::vector<OtherEntry> others_;
  std::unique_ptr<KluFactors> factors_;
  int directions_ = 0;  ///< most of any block
  std::vector<double> dependence_, b_;
};

}  // namespace mbgen
