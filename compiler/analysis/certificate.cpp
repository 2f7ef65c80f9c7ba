#include "compiler/analysis/certificate.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace mbgen {
namespace {

constexpr double kStill = 1e-6;  // share of a freedom, free of units, below which a coordinate does not move with it
constexpr double kSamePlace = 1e-3;          // rad or m
constexpr double kTurn = 6.283185307179586;  // rad

/// Columns without a share in any freedom, in all configurations of generic rank.
std::vector<int> immobile_columns(const PartView& whole) {
  const std::size_t columns = whole.part.columns.size();
  std::vector<bool> moves(columns, false);
  for (std::size_t s = 0; s < whole.jacobians.size() && !whole.locked(); ++s) {
    if (whole.ranks[s] < whole.rank) continue;
    const Eigen::MatrixXd free = null_space(whole.jacobians[s], whole.rank);
    for (std::size_t c = 0; c < columns; ++c) moves[c] = moves[c] || free.row(c).norm() > kStill;
  }
  std::vector<int> still;
  for (std::size_t c = 0; c < columns; ++c)
    if (!moves[c]) still.push_back(static_cast<int>(c));
  return still;
}

/// Singular configurations are met again and again: Newton's method is drawn to them.
void add_singular(const Topology& topology, const LoopBlock& block, int rank, std::vector<double> z,
                  std::vector<SingularConfiguration>& met) {
  const auto same_place = [&](const SingularConfiguration& known) {
    for (std::size_t c = 0; c < z.size(); ++c) {
      const bool turns = topology.bodies[block.joints[c]].kind == FreedomKind::revolute;
      const double apart = turns ? std::remainder(z[c] - known.z[c], kTurn) : z[c] - known.z[c];
      if (std::abs(apart) > kSamePlace) return false;
    }
    return known.rank == rank;
  };
  const auto known = std::find_if(met.begin(), met.end(), same_place);
  if (known == met.end())
    met.push_back({rank, 1, std::move(z)});
  else
    ++known->times;
}

}  // namespace

std::vector<RankCount> rank_counts(const std::vector<int>& ranks) {
  std::map<int, int, std::greater<>> count;
  for (int rank : ranks) ++count[rank];
  std::vector<RankCount> result;
  for (const auto& [rank, configurations] : count) result.push_back({rank, configurations});
  return result;
}

Certificate certify(const Topology& topology, const LoopBlock& block, const PartView& whole,
                    const std::vector<Configuration>& configurations) {
  Certificate c;
  c.closed_configurations = static_cast<int>(whole.configurations.size());
  c.ranks = rank_counts(whole.ranks);
  c.immobile = immobile_columns(whole);
  c.degrees_of_freedom = static_cast<int>(block.joints.size()) - whole.rank;
  c.smallest_kept = whole.rank == 0 ? 0.0 : whole.margin(whole.best());
  for (std::size_t s = 0; s < whole.configurations.size(); ++s) {
    const Eigen::VectorXd& sigma = whole.singular_values[s];
    const int rank = whole.ranks[s];
    const double largest = std::max(1.0, sigma[0]);
    if (rank > 0) c.smallest_kept = std::min(c.smallest_kept, sigma[rank - 1] / largest);
    if (rank < sigma.size()) c.largest_dropped = std::max(c.largest_dropped, sigma[rank] / largest);
    std::vector<double> z;
    for (int j : block.joints) z.push_back(configurations[whole.configurations[s]].z[j]);
    for (double value : z) c.reach = std::max(c.reach, std::abs(value));
    if (rank < whole.rank) add_singular(topology, block, rank, std::move(z), c.singular);
  }
  return c;
}

void add_other_modes(Certificate& certificate, const std::vector<RankCount>& others) {
  certificate.ranks.insert(certificate.ranks.begin(), others.begin(), others.end());
  for (const RankCount& other : others) certificate.closed_configurations += other.configurations;
}

void certify_redundant(Certificate& certificate, const std::vector<int>& redundant,
                       const std::vector<ClosureEquation>& equations, int steps, const Eigen::VectorXd& residual) {
  certificate.steps = steps;
  for (int e : redundant)
    certificate.redundant.push_back(
        {e, equations[e].loop, equations[e].name, equations[e].meaning, steps > 0 ? residual[e] : -1.0});
}

std::vector<RankCount> ranks_together(const std::vector<PartView>& views,
                                      const std::vector<Configuration>& configurations) {
  std::vector<int> total(configurations.size(), 0), closed(configurations.size(), 0);
  for (const PartView& view : views)
    for (std::size_t s = 0; s < view.configurations.size(); ++s) {
      total[view.configurations[s]] += view.ranks[s];
      ++closed[view.configurations[s]];
    }
  std::vector<int> ranks;
  for (std::size_t i = 0; i < configurations.size(); ++i)
    if (closed[i] == static_cast<int>(views.size())) ranks.push_back(total[i]);
  return rank_counts(ranks);
}

}  // namespace mbgen
