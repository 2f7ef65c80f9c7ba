#include "compiler/analysis/self_stress.hpp"

#include <algorithm>
#include <random>

#include "compiler/algebra/dense.hpp"
#include "compiler/analysis/violation.hpp"

namespace mbgen {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kNoShare = 1e-7;  // of a kept row in a redundant one
constexpr int kDirections = 3;     // of motion that are tried

bool overlap(const std::vector<int>& a, const std::vector<int>& b) {
  return std::any_of(a.begin(), a.end(), [&](int row) { return contains(b, row); });
}

/// Some rows of a part that cannot move, seen at a position.
struct PartPosition {
  NumericSystem& numbers;
  std::size_t b;
  const PartView& view;
  const MatrixXd& jacobian;  // of the part, free of units
  const std::vector<double>& start;
};

/// The largest residual of redundant rows (local to the part) after a finite step along `direction` with the kept ones
/// closed, or a negative number when none can be made.
double opened(const PartPosition& at, const DependentRows& rows, const VectorXd& direction, double longest) {
  const LoopBlock& block = at.numbers.topology().blocks[at.b];
  std::vector<std::vector<int>> closing(at.numbers.topology().blocks.size());
  for (int r : rows.kept) closing[at.b].push_back(at.view.part.rows[r]);
  for (double step = longest; step > kShortestStep; step /= 2) {
    std::vector<double> z = at.start;
    move(block, at.view, step * direction, z);
    const Configuration moved = close_equations(at.numbers, std::move(z), closing);
    int coordinate = 0;
    const double length = distance(block, at.view, at.start, moved.z, coordinate);
    if (!moved.closed[at.b] || length < step / 2 || length > 2 * step) continue;
    const VectorXd left = residual_left(moved, at.b)(at.view.part.rows);
    return left(rows.redundant).cwiseAbs().maxCoeff();
  }
  return -1;
}

/// Loops of a part that have one of these rows.
std::vector<int> loops_of(const Topology& topology, const LoopBlock& block, const PartView& view,
                          const DependentRows& rows) {
  std::vector<int> loops;
  int first = 0;
  for (int l : block.loops) {
    const int end = first + topology.loops[l].equations;
    for (const std::vector<int>* some : {&rows.kept, &rows.redundant})
      for (int r : *some)
        if (view.part.rows[r] >= first && view.part.rows[r] < end && !contains(loops, l)) loops.push_back(l);
    first = end;
  }
  return loops;
}

/// Whether the rows leave the joints of their loops a freedom, and the dependent rows agree along it.
bool agree(const PartPosition& at, const DependentRows& rows, const BlockPart& loops) {
  std::vector<int> movable;
  for (std::size_t c = 0; c < at.view.part.columns.size(); ++c)
    if (contains(loops.columns, at.view.part.columns[c])) movable.push_back(static_cast<int>(c));
  if (movable.size() <= rows.kept.size()) return false;
  const MatrixXd free = rows.kept.empty()
                            ? MatrixXd(MatrixXd::Identity(movable.size(), movable.size()))
                            : null_space(at.jacobian(rows.kept, movable), static_cast<int>(rows.kept.size()));
  std::mt19937_64 random(20120407);
  bool stepped = false;
  for (int d = 0; d < kDirections; ++d) {
    VectorXd weights(free.cols());
    for (double& w : weights) w = static_cast<double>(random() >> 11) * 0x1p-52 - 1.0;
    VectorXd direction = VectorXd::Zero(at.jacobian.cols());
    direction(movable) = free * weights;
    direction /= direction.cwiseAbs().maxCoeff();
    const double residual = opened(at, rows, direction, kStep);
    if (residual > kContradiction && !(opened(at, rows, direction, kStep / 8) < kJump * residual)) return false;
    stepped = stepped || residual >= 0;
  }
  return stepped;
}

/// All rows of some loops of a part: the rows with pivots by full pivoting, and the others.
DependentRows rows_of(const PartPosition& at, const BlockPart& loops) {
  std::vector<int> rows, late;
  for (std::size_t r = 0; r < at.view.part.rows.size(); ++r) {
    if (!contains(loops.rows, at.view.part.rows[r])) continue;
    if (contains(at.view.late, static_cast<int>(r))) late.push_back(static_cast<int>(rows.size()));
    rows.push_back(static_cast<int>(r));
  }
  const MatrixXd jacobian = at.jacobian(rows, Eigen::all);
  const VectorXd sigma = singular_values(jacobian);
  const std::vector<int> kept =
      strongest_rows(jacobian, static_cast<int>((sigma.array() > kLeastSingularValue).count()), late);
  DependentRows result;
  for (std::size_t r = 0; r < rows.size(); ++r)
    (contains(kept, static_cast<int>(r)) ? result.kept : result.redundant).push_back(rows[r]);
  return result;
}

}  // namespace

std::vector<DependentRows> dependent_rows(const MatrixXd& matrix, int rank, const std::vector<int>& late) {
  const std::vector<int> kept = strongest_rows(matrix, rank, late);
  const MatrixXd basis = matrix(kept, Eigen::all).transpose();
  const MatrixXd all_shares = rank > 0 ? overdetermined_solution(basis, matrix.transpose()) : MatrixXd();
  std::vector<DependentRows> components;
  for (int r = 0; r < matrix.rows(); ++r) {
    if (contains(kept, r)) continue;
    DependentRows joined{{}, {r}};
    if (rank > 0) {
      for (int k = 0; k < rank; ++k)
        if (std::abs(all_shares(k, r)) > kNoShare) joined.kept.push_back(kept[k]);
    }
    for (auto other = components.begin(); other != components.end();) {
      const bool touches = overlap(other->kept, joined.kept);
      if (touches) {
        joined.redundant.insert(joined.redundant.end(), other->redundant.begin(), other->redundant.end());
        for (int k : other->kept)
          if (!contains(joined.kept, k)) joined.kept.push_back(k);
      }
      other = touches ? components.erase(other) : other + 1;
    }
    std::sort(joined.kept.begin(), joined.kept.end());
    components.push_back(std::move(joined));
  }
  return components;
}

bool redundancy_holds(NumericSystem& numbers, std::size_t b, const PartView& view, std::size_t s,
                      const std::vector<double>& start) {
  const LoopBlock& block = numbers.topology().blocks[b];
  const PartPosition at{numbers, b, view, view.jacobians[s], start};
  const std::vector<DependentRows> components = dependent_rows(at.jacobian, view.rank, view.late);
  return std::all_of(components.begin(), components.end(), [&](const DependentRows& rows) {
    const BlockPart loops = block_part(numbers.topology(), block, loops_of(numbers.topology(), block, view, rows));
    // By chance a dependence may leave out a row here that it needs elsewhere.
    return agree(at, rows, loops) || agree(at, rows_of(at, loops), loops);
  });
}

}  // namespace mbgen
