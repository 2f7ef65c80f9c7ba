#include "compiler/analysis/part.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "compiler/algebra/dense.hpp"

namespace mbgen {
namespace {

constexpr double kSmallest = 1e-6;   // m; below it all joints of a part share one point
constexpr double kUncertainty = 10;  // of a singular value, per rad of uncertainty of the position

/// Diagonal of the box around the joints and ends of a part at the reference, m.
double size_of(const NumericSystem& numbers, const LoopBlock& block, const BlockPart& part) {
  const Model& model = numbers.model();
  const Topology& topology = numbers.topology();
  Eigen::AlignedBox3d box;
  const auto add = [&box](const Vector<double>& p) { box.extend(Eigen::Vector3d(p.x, p.y, p.z)); };
  for (int c : part.columns) add(numbers.constants().origin[block.joints[c]]);
  for (int l : part.loops) {
    const Loop& loop = topology.loops[l];
    if (loop.kind == ClosureKind::coupling) continue;
    for (const Attachment& at : loop.rod >= 0 ? std::array{model.rods[loop.rod].from, model.rods[loop.rod].to}
                                              : std::array{model.joints[loop.joint].from, model.joints[loop.joint].to})
      add(numbers.reference_position(at));
  }
  const double size = box.diagonal().norm();
  return size < kSmallest ? 1.0 : size;
}

/// Largest derivative of a relation in all configurations, 1 where it has none: the model gives its factors any size.
double largest_slope(const PartView& view, Eigen::Index row) {
  double largest = 0;
  for (const Eigen::MatrixXd& jacobian : view.jacobians)
    for (Eigen::Index c = 0; c < jacobian.cols(); ++c)
      largest = std::max(largest, std::abs(jacobian(row, c)) * view.column_scale[static_cast<std::size_t>(c)]);
  return largest > 0 ? largest : 1.0;
}

}  // namespace

bool contains(const std::vector<int>& values, int value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

BlockPart block_part(const Topology& topology, const LoopBlock& block, const std::vector<int>& loops) {
  BlockPart part{loops, {}, {}};
  int row = 0;
  for (int l : block.loops)
    for (int e = 0; e < topology.loops[l].equations; ++e, ++row)
      if (contains(loops, l)) part.rows.push_back(row);
  for (std::size_t c = 0; c < block.joints.size(); ++c)
    if (std::any_of(loops.begin(), loops.end(),
                    [&](int l) { return contains(topology.loops[l].joints, block.joints[c]); }))
      part.columns.push_back(static_cast<int>(c));
  return part;
}

std::vector<std::vector<int>> connected(const Topology& topology, const std::vector<int>& loops) {
  const auto share = [&](int a, int b) {
    const std::vector<int>& joints = topology.loops[a].joints;
    return std::any_of(joints.begin(), joints.end(), [&](int j) { return contains(topology.loops[b].joints, j); });
  };
  std::vector<std::vector<int>> groups;
  for (int loop : loops) {
    std::vector<int> joined{loop};
    for (auto group = groups.begin(); group != groups.end();) {
      const bool touches = std::any_of(group->begin(), group->end(), [&](int other) { return share(other, loop); });
      if (touches) joined.insert(joined.end(), group->begin(), group->end());
      group = touches ? groups.erase(group) : group + 1;
    }
    std::sort(joined.begin(), joined.end());
    groups.push_back(std::move(joined));
  }
  return groups;
}

double PartView::margin(std::size_t s) const {
  if (rank == 0) return 0;
  return singular_values[s][rank - 1] / std::max(1.0, singular_values[s][0]);
}

std::size_t PartView::best() const {
  std::size_t best = 0;
  for (std::size_t s = 1; s < jacobians.size(); ++s)
    if (margin(s) > margin(best)) best = s;
  return best;
}

PartView view(const NumericSystem& numbers, std::size_t b, const BlockPart& part,
              const std::vector<ClosureEquation>& equations, const std::vector<Configuration>& configurations) {
  const LoopBlock& block = numbers.topology().blocks[b];
  PartView v;
  v.part = part;
  const std::vector<int> of_velocities = velocity_rows(numbers.model(), numbers.topology(), block);
  for (std::size_t r = 0; r < part.rows.size(); ++r)
    if (contains(of_velocities, part.rows[r])) v.late.push_back(static_cast<int>(r));
  for (std::size_t i = 0; i < configurations.size(); ++i) {
    if (!configurations[i].closed[b]) continue;
    v.configurations.push_back(static_cast<int>(i));
    v.jacobians.push_back(configurations[i].blocks[b].part(part.rows, part.columns));
  }
  std::vector<bool> revolute;
  for (int c : part.columns)
    revolute.push_back(numbers.topology().bodies[block.joints[c]].kind == FreedomKind::revolute);
  const double size = size_of(numbers, block, part);
  v.row_scale.resize(part.rows.size());
  v.column_scale.resize(part.columns.size());
  for (std::size_t c = 0; c < revolute.size(); ++c) v.column_scale[c] = revolute[c] ? 1.0 : size;
  for (std::size_t r = 0; r < part.rows.size(); ++r) {
    const ResidualUnit unit = equations[part.rows[r]].unit;
    v.row_scale[r] = unit == ResidualUnit::metre         ? 1 / size
                     : unit == ResidualUnit::of_relation ? 1 / largest_slope(v, static_cast<Eigen::Index>(r))
                                                         : 1.0;
  }
  for (std::size_t i = 0; i < v.jacobians.size(); ++i) {
    Eigen::MatrixXd& j = v.jacobians[i];
    j = v.row_scale.asDiagonal() * j * v.column_scale.asDiagonal();
    v.singular_values.push_back(singular_values(j));
    const Eigen::VectorXd& correction = configurations[v.configurations[i]].corrections[b];
    const double uncertain = correction(part.columns).cwiseQuotient(v.column_scale).cwiseAbs().maxCoeff();
    const double tolerance = std::max(kLeastSingularValue, kUncertainty * uncertain);
    v.ranks.push_back(static_cast<int>((v.singular_values.back().array() > tolerance).count()));
    v.rank = std::max(v.rank, v.ranks.back());
  }
  return v;
}

Eigen::MatrixXd null_space(const Eigen::MatrixXd& matrix, int rank) {
  return right_singular_vectors(matrix).vectors.rightCols(matrix.cols() - rank);
}

namespace {

std::vector<int> rows_by_pivots(const Eigen::MatrixXd& matrix, int count) {
  const std::vector<int> order = pivot_places(matrix);
  std::vector<int> rows;
  for (Eigen::Index r = 0; r < matrix.rows(); ++r)
    if (order[r] < count) rows.push_back(static_cast<int>(r));
  return rows;
}

}  // namespace

std::vector<int> strongest_rows(const Eigen::MatrixXd& matrix, int count, const std::vector<int>& late) {
  if (late.empty()) return rows_by_pivots(matrix, count);
  Eigen::MatrixXd early = matrix;
  early(late, Eigen::all).setZero();
  const auto rank = static_cast<int>((singular_values(early).array() > kLeastSingularValue).count());
  std::vector<int> rows = rows_by_pivots(early, std::min(count, rank));
  if (count <= rank) return rows;
  const Eigen::MatrixXd free = rank > 0 ? null_space(early(rows, Eigen::all), rank)
                                        : Eigen::MatrixXd(Eigen::MatrixXd::Identity(matrix.cols(), matrix.cols()));
  for (const int r : rows_by_pivots(matrix(late, Eigen::all) * free, count - rank)) rows.push_back(late[r]);
  std::sort(rows.begin(), rows.end());
  return rows;
}

}  // namespace mbgen
