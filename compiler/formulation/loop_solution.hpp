#pragma once
// The frozen solution of a loop block: elimination in an order that the analysis chose, tiny and without decisions.

#include "compiler/formulation/closure.hpp"
#include "compiler/formulation/loop_partition.hpp"

namespace mbgen {

/// Rz and the particular accelerations of one joint group (61), (62): zd = Rz zd_free, zdd = zdd_star + Rz zdd_free.
template <class T>
struct GroupProjection {
  std::vector<std::vector<T>> rz;  ///< [coordinate of the group][free direction]
  std::vector<T> zdd_star;         ///< accelerations under zero free accelerations, driven ones prescribed
};

/// LU factors of the dependent Jacobian in the frozen order, and the monitor of its pivots.
template <class T>
struct FrozenFactors {
  std::vector<std::vector<T>> rows;   ///< per pivot k: its equation after elimination, all columns of the block
  std::vector<std::vector<T>> lower;  ///< lower[k][m]: factor of pivot row m < k in row k
  std::vector<T> reciprocal;          ///< 1 / pivot
  T quality{1.0};                     ///< smallest |pivot| / reference
};

/// Factorises Phi_d by the frozen pivots; independent columns are carried along (60).
template <class T>
FrozenFactors<T> factorise_frozen(const std::vector<std::vector<T>>& jacobian, const LoopPartition& partition) {
  using std::abs;
  using std::min;
  FrozenFactors<T> f;
  const std::size_t rank = partition.pivots.size();
  for (std::size_t k = 0; k < rank; ++k) {
    std::vector<T> row = jacobian[partition.pivots[k].equation];
    std::vector<T> lower(k, T(0.0));
    for (std::size_t m = 0; m < k; ++m) {
      const int column = partition.pivots[m].coordinate;
      if (is_zero(row[column])) continue;
      lower[m] = row[column] * f.reciprocal[m];
      for (std::size_t c = 0; c < row.size(); ++c)
        if (static_cast<int>(c) != column && !is_zero(f.rows[m][c])) row[c] = row[c] - lower[m] * f.rows[m][c];
      row[column] = T(0.0);
    }
    const T& pivot = row[partition.pivots[k].coordinate];
    f.reciprocal.push_back(T(1.0) / pivot);
    const T ratio = abs(pivot) * T(1.0 / partition.pivots[k].reference);
    f.quality = k == 0 ? ratio : min(f.quality, ratio);
    f.rows.push_back(std::move(row));
    f.lower.push_back(std::move(lower));
  }
  return f;
}

/// Solves U x_d = y, y per pivot. Result: per coordinate of the block, zero at the others.
template <class T>
std::vector<T> back_substituted(const FrozenFactors<T>& f, const LoopPartition& partition, const std::vector<T>& y,
                                std::size_t coordinates) {
  const std::size_t rank = partition.pivots.size();
  std::vector<T> x(coordinates, T(0.0));
  for (std::size_t k = rank; k-- > 0;) {
    T value = y[k];
    for (std::size_t m = k + 1; m < rank; ++m) {
      const int column = partition.pivots[m].coordinate;
      if (!is_zero(f.rows[k][column])) value = value - f.rows[k][column] * x[column];
    }
    x[partition.pivots[k].coordinate] = value * f.reciprocal[k];
  }
  return x;
}

/// Solves Phi_d x_d = right_hand_side for the dependent coordinates; right_hand_side per equation of the block.
/// Result: per coordinate of the block, zero at the others.
template <class T>
std::vector<T> solve_frozen(const FrozenFactors<T>& f, const LoopPartition& partition,
                            const std::vector<T>& right_hand_side, std::size_t coordinates) {
  const std::size_t rank = partition.pivots.size();
  std::vector<T> y;
  for (std::size_t k = 0; k < rank; ++k) {
    T value = right_hand_side[partition.pivots[k].equation];
    for (std::size_t m = 0; m < k; ++m)
      if (!is_zero(f.lower[k][m])) value = value - f.lower[k][m] * y[m];
    y.push_back(value);
  }
  return back_substituted(f, partition, y, coordinates);
}

/// Solves Phi_d' y = right_hand_side (multipliers); right_hand_side per coordinate of the block (dependent entries
/// used). Result: per equation of the block, zero at redundant ones.
template <class T>
std::vector<T> solve_frozen_transposed(const FrozenFactors<T>& f, const LoopPartition& partition,
                                       const std::vector<T>& right_hand_side, std::size_t equations) {
  const std::size_t rank = partition.pivots.size();
  std::vector<T> y(rank, T(0.0));
  for (std::size_t k = 0; k < rank; ++k) {  // U' y = right_hand_side
    T value = right_hand_side[partition.pivots[k].coordinate];
    for (std::size_t m = 0; m < k; ++m) {
      const T& upper = f.rows[m][partition.pivots[k].coordinate];
      if (!is_zero(upper)) value = value - upper * y[m];
    }
    y[k] = value * f.reciprocal[k];
  }
  std::vector<T> lambda(equations, T(0.0));
  for (std::size_t k = rank; k-- > 0;) {  // L' lambda = y
    T value = y[k];
    for (std::size_t m = k + 1; m < rank; ++m)
      if (!is_zero(f.lower[m][k])) value = value - f.lower[m][k] * lambda[partition.pivots[m].equation];
    lambda[partition.pivots[k].equation] = value;
  }
  return lambda;
}

/// Right-hand side with given coordinates moved over: right_hand_side - Phi_given x_given.
template <class T>
std::vector<T> moved_over(const std::vector<std::vector<T>>& jacobian, std::vector<T> right_hand_side,
                          const std::vector<int>& given, const std::vector<T>& x) {
  for (std::size_t e = 0; e < jacobian.size(); ++e)
    for (int c : given)
      if (!is_zero(jacobian[e][c])) right_hand_side[e] = right_hand_side[e] - jacobian[e][c] * x[c];
  return right_hand_side;
}

/// Rz of a block by the frozen order (61).
template <class T>
std::vector<std::vector<T>> frozen_rz(const FrozenFactors<T>& factors, const LoopPartition& partition,
                                      std::size_t coordinates) {
  std::vector<std::vector<T>> rz(coordinates);
  for (int free : partition.independent) {
    std::vector<T> y;
    for (const std::vector<T>& row : factors.rows) y.push_back(-row[free]);
    std::vector<T> column = back_substituted(factors, partition, y, coordinates);
    column[free] = T(1.0);
    for (std::size_t c = 0; c < coordinates; ++c) rz[c].push_back(column[c]);
  }
  return rz;
}

/// Rz of every joint group at a position by the frozen order, zdd_star zero. partitions: one LoopPartition per block;
/// driven: per tree coordinate. Cost: as the closures.
template <class T, class Partitions>
std::vector<GroupProjection<T>> frozen_directions(System<T>& system, const Kinematics<T>& k,
                                                  const Partitions& partitions, const std::vector<bool>& driven) {
  std::vector<GroupProjection<T>> projections;
  const RelativeMotion<T> rest = at_rest<T>(system.topology);
  for (const JointGroup& group : system.topology.groups) {
    GroupProjection<T> p;
    if (group.block < 0) {
      p.rz = {driven[group.joints[0]] ? std::vector<T>{} : std::vector<T>{T(1.0)}};
    } else {
      const LoopPartition& partition = partitions[group.block];
      const BlockClosure<T> closed = closure(system, k, system.topology.blocks[group.block], rest);
      p.rz = frozen_rz(factorise_frozen(closed.jacobian, partition), partition, group.joints.size());
    }
    p.zdd_star.assign(group.joints.size(), T(0.0));
    projections.push_back(std::move(p));
  }
  return projections;
}

/// zdd_star of a block by the frozen order: dependent accelerations for zero free and given driven ones (62).
template <class T>
std::vector<T> frozen_zdd_star(const FrozenFactors<T>& factors, const LoopPartition& partition,
                               const BlockClosure<T>& closure, const std::vector<T>& driven_acceleration) {
  const std::size_t coordinates = driven_acceleration.size();
  std::vector<T> x = solve_frozen(
      factors, partition, moved_over(closure.jacobian, closure.acceleration, partition.driven, driven_acceleration),
      coordinates);
  for (int c : partition.driven) x[c] = driven_acceleration[c];
  return x;
}

}  // namespace mbgen
