#pragma once
// The generic runtime's demand on linear algebra: the loops' part of steps 2, 3, 6 and 8 of the paper's tables, behind
// one table of functions, so that a library is chosen once and its types stay in its own file.

#include <Eigen/Dense>
#include <functional>
#include <memory>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "mbgen/status.hpp"
#include "runtime/generic/algebra_choice.hpp"
#include "runtime/generic/model_closures.hpp"
#include "runtime/generic/tree_mass.hpp"

namespace mbgen {

/// Values per loop block and equation.
using PerBlock = std::vector<std::vector<double>>;

/// Sizes of one loop block, and where it stands in the whole.
struct BlockShape {
  std::vector<int> joints;   ///< coordinate of each column
  std::vector<int> movable;  ///< columns that may be dependent: all but the driven ones
  std::vector<int> driven;   ///< columns
  int equations = 0;
  int rank = 0;             ///< generic, hence also the number of dependent columns
  int first_equation = 0;   ///< of all equations, block after block
  int first_direction = 0;  ///< of all free directions
  int directions() const { return static_cast<int>(movable.size()) - rank; }
};

/// A coordinate outside all loops that no motion drives: a free direction of its own.
struct FreeJoint {
  int coordinate = 0, direction = 0;
};

/// Sizes that every linear algebra needs. Free directions stand group by group, parents first.
struct LoopShape {
  int coordinates = 0, equations = 0, directions = 0;
  std::vector<BlockShape> blocks;
  std::vector<FreeJoint> free_joints;
};
LoopShape loop_shape(const Topology& topology, const Analysis& analysis);

/// Rz' M Rz zdd_free = Rz' q (63), lower triangle.
struct ReducedEquations {
  Eigen::MatrixXd mass;
  Eigen::VectorXd right_hand_side;
};

/// Linear algebra for one model. It keeps the factors of the state that it was given last, so it serves one thread.
struct LoopAlgebra {
  /// Chooses dependent columns and factorises Phi_d of every block (60). Driven columns are never dependent.
  /// Fails: loop_singular, where a block has less than its generic rank.
  std::function<Status(const Closures& closures)> factorise;
  /// Rz of all coordinates (61). Requires: factorise.
  std::function<void()> form_rz;
  /// Sets the dependent entries of x, per coordinate, so that Phi_z x = right_hand_side (62). Requires: factorise.
  std::function<void(const PerBlock& right_hand_side, std::vector<double>& x)> solve;
  /// Products of (63), q per coordinate. Requires: form_rz.
  std::function<void(const TreeMass& mass, const std::vector<double>& q, ReducedEquations& reduced)> reduce;
  /// x += Rz free, x per coordinate. Requires: form_rz.
  std::function<void(const Eigen::VectorXd& free, std::vector<double>& x)> add_rz_times;
  /// The smallest pivot of a block by full pivoting. Empty where pivots are chosen otherwise. Requires: factorise.
  std::function<double(std::size_t block)> smallest_pivot;
  /// Rz of one block, [column][free direction]. Empty where all blocks are taken as one. Requires: factorise.
  std::function<std::vector<std::vector<double>>(std::size_t block)> rz_of;
};

/// Solves block by block: factors[b].solve(right_hand_side, x of the block's joints). local: memory of the caller.
template <class Factors>
void solve_blocks(const std::vector<BlockShape>& blocks, const std::vector<Factors>& factors,
                  const PerBlock& right_hand_side, std::vector<double>& local, std::vector<double>& x) {
  for (std::size_t b = 0; b < factors.size(); ++b) {
    const std::vector<int>& joints = blocks[b].joints;
    local.resize(joints.size());
    for (std::size_t c = 0; c < joints.size(); ++c) local[c] = x[joints[c]];
    factors[b].solve(right_hand_side[b], local);
    for (std::size_t c = 0; c < joints.size(); ++c) x[joints[c]] = local[c];
  }
}

/// The functions of a type that has members of these names.
template <class Loops>
LoopAlgebra algebra_of(const std::shared_ptr<Loops>& loops) {
  return {[loops](const Closures& closures) { return loops->factorise(closures); },
          [loops] { loops->form_rz(); },
          [loops](const PerBlock& right_hand_side, std::vector<double>& x) { loops->solve(right_hand_side, x); },
          [loops](const TreeMass& mass, const std::vector<double>& q, ReducedEquations& reduced) {
            loops->reduce(mass, q, reduced);
          },
          [loops](const Eigen::VectorXd& free, std::vector<double>& x) { loops->add_rz_times(free, x); },
          {},
          {}};
}
template <class Loops, class... Data>
LoopAlgebra algebra_of(const Data&... data) {
  return algebra_of(std::make_shared<Loops>(data...));
}

/// Each block for itself: LU with full pivoting by the entries of its rows, sparse products. It refers to the model and
/// the topology.
LoopAlgebra entries_algebra(const Model& model, const Topology& topology, const Analysis& analysis);
/// Dense, each block for itself: LU with full pivoting, products by Eigen.
LoopAlgebra eigen_lu_algebra(const Topology& topology, const Analysis& analysis);
/// The same with Householder QR and column pivoting.
LoopAlgebra eigen_qr_algebra(const Topology& topology, const Analysis& analysis);
/// Dense, all loops in one matrix as in the paper: its LU by columns with row swapping, products by dgemm.
LoopAlgebra blas_algebra(const Topology& topology, const Analysis& analysis);
/// All loops in one sparse matrix, factorised by KLU with a partition that is kept while it is good, sparse products.
LoopAlgebra sparse_algebra(const Model& model, const Topology& topology, const Analysis& analysis);

/// The one that is asked for. QR is Eigen's, also where no library is asked for.
/// Fails: std::invalid_argument for QR with another library.
LoopAlgebra make_loop_algebra(const GenericAlgebra& choice, const Model& model, const Topology& topology,
                              const Analysis& analysis);

}  // namespace mbgen
