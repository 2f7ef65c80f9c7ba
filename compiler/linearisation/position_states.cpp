#include "compiler/linearisation/position_states.hpp"

#include <algorithm>

#include "compiler/algebra/dense.hpp"

namespace mbgen {
namespace {

/// Pivot relative to the largest that counts as zero: rounding of a projection matrix.
constexpr double kNoPivot = 1e-9;

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

}  // namespace

std::optional<PositionStates> position_states(const Topology& topology, const Analysis& analysis,
                                              const Eigen::MatrixXd& closing) {
  PositionStates states{free_coordinates(topology, analysis), {}};
  std::vector<int> others, dependent;
  int driven = 0;
  for (int i = 0; i < topology.size(); ++i) {
    driven += analysis.driven[i] ? 1 : 0;
    if (!analysis.driven[i] && !contains(states.coordinates, i)) others.push_back(i);
  }
  // Rows of positions are combinations of the rows of `closing`: their pivots are the positions determined by them.
  const Eigen::MatrixXd rows = closing(others, others);
  if (rows.size() > 0 && rows.cwiseAbs().maxCoeff() > kNoPivot) {
    for (const int column : leading_columns(rows, kNoPivot))
      dependent.push_back(others[static_cast<std::size_t>(column)]);
  }
  for (const int i : others)
    if (!contains(dependent, i)) states.coordinates.push_back(i);
  const auto count = static_cast<Eigen::Index>(states.coordinates.size());
  if (count != analysis.position_freedoms - driven) return {};
  states.along = Eigen::MatrixXd::Zero(closing.rows(), count);
  for (Eigen::Index j = 0; j < count; ++j) states.along(states.coordinates[static_cast<std::size_t>(j)], j) = 1;
  if (dependent.empty()) return states;
  const Eigen::MatrixXd by_states = closing(others, states.coordinates);
  states.along(dependent, Eigen::all) = overdetermined_solution(closing(others, dependent), -by_states);
  return states;
}

}  // namespace mbgen
