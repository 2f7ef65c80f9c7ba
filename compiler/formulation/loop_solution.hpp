#pragma once
// The frozen solution of a loop block: elimination in an order that the analysis chose, tiny and without decisions.

#include <map>
#include <set>
#include <string>

#include "compiler/formulation/closure.hpp"
#include "compiler/formulation/column_names.hpp"
#include "compiler/formulation/loop_partition.hpp"

namespace mbgen {

/// Rz and the particular accelerations of one joint group (61), (62): zd = Rz zd_free, zdd = zdd_star + Rz zdd_free.
template <class T>
struct GroupProjection {
  std::vector<std::vector<T>> rz;  ///< [coordinate of the group][free direction]
  std::vector<T> zdd_star;         ///< accelerations under zero free accelerations, driven ones prescribed
};

/// LU factors of the dependent Jacobian in the frozen order, and the monitor of its pivots. Row k belongs to pivot k.
template <class T>
struct FrozenFactors {
  std::vector<SparseRow<T>> rows;    ///< its equation after elimination, without the pivot; `columns` as in the block
  std::vector<SparseRow<T>> upper;   ///< of them those at later pivots, `columns` are pivot numbers
  std::vector<SparseRow<T>> lower;   ///< factors of earlier pivot rows, `columns` are pivot numbers
  std::vector<T> pivot, reciprocal;  ///< and 1 / pivot
  T quality{1.0};                    ///< smallest |pivot| / reference
};

namespace detail {

/// Number of the pivot of each column, -1 for none.
inline std::vector<int> pivot_numbers(const LoopPartition& partition, std::size_t coordinates) {
  std::vector<int> number(coordinates, -1);
  for (std::size_t k = 0; k < partition.pivots.size(); ++k)
    number[partition.pivots[k].coordinate] = static_cast<int>(k);
  return number;
}

/// A row under elimination.
template <class T>
struct WorkingRow {
  const std::vector<int>& pivot_number;
  std::map<int, T> entries = {};
  std::set<int> pivots = {};  ///< numbers of those at which it has entries

  void set(int column, const T& value) {
    if (is_zero(value)) return take(column);
    entries.insert_or_assign(column, value);
    if (pivot_number[column] >= 0) pivots.insert(pivot_number[column]);
  }
  void take(int column) {
    entries.erase(column);
    pivots.erase(pivot_number[column]);
  }
  T at(int column) const {
    const auto entry = entries.find(column);
    return entry == entries.end() ? T(0.0) : entry->second;
  }
};

/// The transpose of square sparse rows.
template <class T>
std::vector<SparseRow<T>> transposed(const std::vector<SparseRow<T>>& rows) {
  std::vector<SparseRow<T>> columns(rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t i = 0; i < rows[r].columns.size(); ++i)
      columns[rows[r].columns[i]].push_back(static_cast<int>(r), rows[r].values[i]);
  return columns;
}

/// value - row . x
template <class T>
T less_product(T value, const SparseRow<T>& row, const std::vector<T>& x) {
  for (std::size_t i = 0; i < row.columns.size(); ++i) value = value - row.values[i] * x[row.columns[i]];
  return value;
}

/// Solves U y = y, in place, per pivot.
template <class T>
void substitute_back(const FrozenFactors<T>& f, std::vector<T>& y) {
  for (std::size_t k = y.size(); k-- > 0;) y[k] = less_product(y[k], f.upper[k], y) * f.reciprocal[k];
}

/// Values per pivot at their coordinates, zero at the others.
template <class T>
std::vector<T> at_coordinates(const LoopPartition& partition, const std::vector<T>& y, std::size_t coordinates) {
  std::vector<T> x(coordinates, T(0.0));
  for (std::size_t k = 0; k < y.size(); ++k) x[partition.pivots[k].coordinate] = y[k];
  return x;
}

}  // namespace detail

/// The reciprocal references of a block's pivots without names.
struct UnnamedScales {
  template <class T>
  T operator()(std::size_t /*pivot*/, const T& scale) const {
    return scale;
  }
};

/// Factorises Phi_d by the frozen pivots; independent columns are carried along (60). coordinates: of the block.
/// named(k, scale): the reciprocal reference of pivot k, with its name. Cost: as the entries met.
template <class T, class Scales = UnnamedScales>
FrozenFactors<T> factorise_frozen(const std::vector<SparseRow<T>>& jacobian, const LoopPartition& partition,
                                  std::size_t coordinates, const Scales& named = {}) {
  using std::abs;
  using std::min;
  FrozenFactors<T> f;
  const std::vector<int> pivot_number = detail::pivot_numbers(partition, coordinates);
  for (std::size_t k = 0; k < partition.pivots.size(); ++k) {
    const int pivot_column = partition.pivots[k].coordinate;
    const SparseRow<T>& equation = jacobian[partition.pivots[k].equation];
    detail::WorkingRow<T> row{pivot_number};
    for (std::size_t i = 0; i < equation.columns.size(); ++i) row.set(equation.columns[i], equation.values[i]);
    SparseRow<T> lower, kept, upper;
    while (!row.pivots.empty() && *row.pivots.begin() < static_cast<int>(k)) {
      const int m = *row.pivots.begin(), column = partition.pivots[m].coordinate;
      const T factor = row.at(column) * f.reciprocal[m];
      row.take(column);
      const SparseRow<T>& above = f.rows[m];
      for (std::size_t i = 0; i < above.columns.size(); ++i)
        row.set(above.columns[i], row.at(above.columns[i]) - factor * above.values[i]);
      lower.push_back(m, factor);
    }
    const T pivot = row.at(pivot_column);
    row.take(pivot_column);
    for (int later : row.pivots) upper.push_back(later, row.at(partition.pivots[later].coordinate));
    for (const auto& [column, value] : row.entries) kept.push_back(column, value);
    f.pivot.push_back(pivot);
    f.reciprocal.push_back(T(1.0) / pivot);
    const T ratio = abs(pivot) * named(k, T(1.0 / partition.pivots[k].reference));
    f.quality = k == 0 ? ratio : min(f.quality, ratio);
    f.rows.push_back(std::move(kept));
    f.upper.push_back(std::move(upper));
    f.lower.push_back(std::move(lower));
  }
  return f;
}

/// Names the reciprocal references of pivots in programs for reading. column: of the block.
template <class T>
auto scale_names(const System<T>& system, const ColumnNames& column, const LoopPartition& partition) {
  return [&, column](std::size_t k, T scale) {
    system.annotator.bound(scale, "1 over the median size of this pivot in the sampled positions", "per_reference_",
                           column(partition.pivots[k].coordinate));
    return scale;
  };
}

/// Names the factors of a block in programs for reading: after the coordinates of their pivots and of their columns.
template <class T>
void detail_factors(const System<T>& system, const ColumnNames& column, const LoopPartition& partition,
                    const FrozenFactors<T>& factors) {
  if (!system.annotator.has_details()) return;
  const auto pivot = [&](std::size_t k) -> const std::string& { return column(partition.pivots[k].coordinate); };
  for (std::size_t k = 0; k < factors.pivot.size(); ++k) {
    const SparseRow<T>&row = factors.rows[k], &lower = factors.lower[k];
    for (std::size_t i = 0; i < row.columns.size(); ++i)
      system.annotator.detail(row.values[i], "U_", pivot(k), "_", column(row.columns[i]));
    for (std::size_t i = 0; i < lower.columns.size(); ++i)
      system.annotator.detail(lower.values[i], "L_", pivot(k), "_", pivot(static_cast<std::size_t>(lower.columns[i])));
    system.annotator.detail(factors.reciprocal[k], "per_pivot_", pivot(k));
  }
}

/// Names the pivots of a block after their columns.
template <class T>
void name_pivots(const System<T>& system, const ColumnNames& column, const LoopPartition& partition,
                 const FrozenFactors<T>& factors) {
  detail_factors(system, column, partition, factors);
  for (std::size_t k = 0; k < factors.pivot.size(); ++k)
    system.annotator.name(factors.pivot[k], "pivot_", column(partition.pivots[k].coordinate));
}

/// Names Rz of a block (61) after its rows and the free directions.
template <class T>
void name_rz(const System<T>& system, const ColumnNames& row, const std::vector<std::vector<T>>& rz) {
  for (std::size_t c = 0; c < rz.size(); ++c)
    for (std::size_t q = 0; q < rz[c].size(); ++q)
      system.annotator.name(rz[c][q], "Rz_", row(c), "_", std::to_string(q));
}

/// Names z* of a block (62) after its columns.
template <class T>
void name_zdd_star(const System<T>& system, const ColumnNames& column, const std::vector<T>& zdd_star) {
  for (std::size_t c = 0; c < zdd_star.size(); ++c) system.annotator.name(zdd_star[c], "zdd_star_", column(c));
}

/// Solves Phi_d x_d = right_hand_side (60) for the dependent coordinates; right_hand_side per equation of the block.
/// Result: per coordinate of the block, zero at the others.
template <class T>
std::vector<T> solve_frozen(const FrozenFactors<T>& f, const LoopPartition& partition,
                            const std::vector<T>& right_hand_side, std::size_t coordinates) {
  std::vector<T> y;
  for (std::size_t k = 0; k < partition.pivots.size(); ++k)
    y.push_back(detail::less_product(right_hand_side[partition.pivots[k].equation], f.lower[k], y));
  detail::substitute_back(f, y);
  return detail::at_coordinates(partition, y, coordinates);
}

/// Solves Phi_d' lambda = right_hand_side (theory.md section 4); right_hand_side per coordinate of the block (dependent
/// entries used). Result: per equation of the block, zero at redundant ones.
template <class T>
std::vector<T> solve_frozen_transposed(const FrozenFactors<T>& f, const LoopPartition& partition,
                                       const std::vector<T>& right_hand_side, std::size_t equations) {
  const std::size_t rank = partition.pivots.size();
  const std::vector<SparseRow<T>> upper = detail::transposed(f.upper), lower = detail::transposed(f.lower);
  std::vector<T> y(rank, T(0.0));
  for (std::size_t k = 0; k < rank; ++k)  // U' y = right_hand_side
    y[k] = detail::less_product(right_hand_side[partition.pivots[k].coordinate], upper[k], y) * f.reciprocal[k];
  for (std::size_t k = rank; k-- > 0;) y[k] = detail::less_product(y[k], lower[k], y);  // L' lambda = y
  std::vector<T> lambda(equations, T(0.0));
  for (std::size_t k = 0; k < rank; ++k) lambda[partition.pivots[k].equation] = y[k];
  return lambda;
}

/// Right-hand side with given coordinates moved over: right_hand_side - Phi_given x_given.
template <class T>
std::vector<T> moved_over(const std::vector<SparseRow<T>>& jacobian, std::vector<T> right_hand_side,
                          const std::vector<int>& given, const std::vector<T>& x) {
  std::vector<int> place(x.size(), -1);  // in `given`: products are taken in its order
  for (std::size_t i = 0; i < given.size(); ++i) place[given[i]] = static_cast<int>(i);
  for (std::size_t e = 0; e < jacobian.size(); ++e) {
    std::vector<std::pair<int, T>> products;
    for (std::size_t i = 0; i < jacobian[e].columns.size(); ++i)
      if (const int c = jacobian[e].columns[i]; place[c] >= 0 && !is_zero(jacobian[e].values[i]))
        products.emplace_back(place[c], jacobian[e].values[i]);
    std::sort(products.begin(), products.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [at, entry] : products) right_hand_side[e] = right_hand_side[e] - entry * x[given[at]];
  }
  return right_hand_side;
}

/// Rz of a block by the frozen order (61), or the same for other coordinates that are not dependent.
template <class T>
std::vector<std::vector<T>> frozen_rz(const FrozenFactors<T>& factors, const LoopPartition& partition,
                                      std::size_t coordinates, const std::vector<int>& given) {
  std::vector<std::vector<T>> rz(coordinates);
  for (int free : given) {
    std::vector<T> y;
    for (const SparseRow<T>& row : factors.rows) y.push_back(-row.at(free));
    detail::substitute_back(factors, y);
    std::vector<T> column = detail::at_coordinates(partition, y, coordinates);
    column[free] = T(1.0);
    for (std::size_t c = 0; c < coordinates; ++c) rz[c].push_back(column[c]);
  }
  return rz;
}
template <class T>
std::vector<std::vector<T>> frozen_rz(const FrozenFactors<T>& factors, const LoopPartition& partition,
                                      std::size_t coordinates) {
  return frozen_rz(factors, partition, coordinates, partition.independent);
}

/// zdd_star of a block by the frozen order: dependent accelerations for zero free and given driven ones (62).
template <class T>
std::vector<T> frozen_zdd_star(const FrozenFactors<T>& factors, const LoopPartition& partition,
                               const SparseClosure<T>& closure, const std::vector<T>& driven_acceleration) {
  const std::size_t coordinates = driven_acceleration.size();
  std::vector<T> x = solve_frozen(
      factors, partition, moved_over(closure.jacobian, closure.acceleration, partition.driven, driven_acceleration),
      coordinates);
  for (int c : partition.driven) x[c] = driven_acceleration[c];
  return x;
}

/// Rz of every joint group at a position by the frozen order, zdd_star zero. partitions: one LoopPartition per block;
/// driven: per tree coordinate; quality: per block, of its factors, for monitors; prescribed: accelerations of driven
/// coordinates, per coordinate, which zdd_star then has. Cost: as the closures.
template <class T, class Partitions>
std::vector<GroupProjection<T>> frozen_directions(System<T>& system, const Kinematics<T>& k,
                                                  const Partitions& partitions, const std::vector<bool>& driven,
                                                  std::vector<T>* quality = nullptr,
                                                  const std::vector<T>* prescribed = nullptr) {
  std::vector<GroupProjection<T>> projections;
  if (quality) quality->assign(system.topology.blocks.size(), T(1.0));
  RelativeMotion<T> relative = at_rest<T>(system.topology);
  for (const JointGroup& group : system.topology.groups) {
    GroupProjection<T> p;
    p.zdd_star.assign(group.joints.size(), T(0.0));
    if (prescribed)
      for (std::size_t c = 0; c < group.joints.size(); ++c) p.zdd_star[c] = (*prescribed)[group.joints[c]];
    if (group.block < 0) {
      p.rz = {driven[group.joints[0]] ? std::vector<T>{} : std::vector<T>{T(1.0)}};
    } else {
      const LoopPartition& partition = partitions[group.block];
      const LoopBlock& block = system.topology.blocks[group.block];
      if (prescribed) set_relative_motion(system, k, block, relative);
      const SparseClosure<T> closed = sparse_closure(system, k, block, relative);
      const std::size_t coordinates = group.joints.size();
      const FrozenFactors<T> factors = factorise_frozen(closed.jacobian, partition, coordinates);
      if (quality) (*quality)[group.block] = factors.quality;
      p.rz = frozen_rz(factors, partition, coordinates);
      if (prescribed) p.zdd_star = frozen_zdd_star(factors, partition, closed, p.zdd_star);
    }
    projections.push_back(std::move(p));
  }
  return projections;
}

}  // namespace mbgen
