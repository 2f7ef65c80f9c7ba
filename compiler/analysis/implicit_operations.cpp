#include "compiler/analysis/implicit_operations.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/element_kinds.hpp"

namespace mbgen {
namespace {

/// Directions beyond which the dense matrix is taken: its operations are far more than are written.
constexpr std::size_t kMostSymbolic = 2048;

/// The free directions of each group of joints, from first to last.
std::vector<std::pair<int, int>> directions_of(const Topology& topology, const Analysis& analysis) {
  std::vector<std::pair<int, int>> ranges;
  int next = 0;
  for (const JointGroup& group : topology.groups) {
    const int free = group.block >= 0 ? static_cast<int>(analysis.blocks[group.block].independent.size())
                                      : (analysis.driven[group.joints[0]] ? 0 : 1);
    ranges.emplace_back(next, next + free);
    next += free;
  }
  return ranges;
}

/// Which entries of the matrix (M - g D - g^2 K) are not zero: [row][column <= row].
class Pattern {
 public:
  Pattern(const Topology& topology, const Analysis& analysis)
      : topology_(topology), ranges_(directions_of(topology, analysis)) {
    const std::size_t n = ranges_.empty() ? 0 : static_cast<std::size_t>(ranges_.back().second);
    entries_.resize(n);
    for (std::size_t row = 0; row < n; ++row) entries_[row].resize(row + 1, false);
  }

  void couple(const std::vector<int>& directions) {
    for (const int a : directions)
      for (const int b : directions)
        if (b <= a) entries_[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] = true;
  }

  /// The mass matrix: each group with the groups that it moves on.
  void add_mass() {
    for (std::size_t g = 0; g < topology_.groups.size(); ++g) {
      std::vector<int> directions;
      for (int below = static_cast<int>(g); below >= 0;
           below = topology_.groups[static_cast<std::size_t>(below)].parent)
        append(below, directions);
      for (int row = ranges_[g].first; row < ranges_[g].second; ++row)
        for (const int column : directions)
          if (column <= row) entries_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = true;
    }
  }

  /// Directions that move two bodies of the model relative to each other.
  std::vector<int> between(int from, int to) const {
    const int a = topology_.tree_body[static_cast<std::size_t>(from)],
              b = topology_.tree_body[static_cast<std::size_t>(to)];
    const int base = lowest_common_ancestor(topology_, a, b);
    std::vector<int> joints = path_to(topology_, a, base), groups;
    const std::vector<int> others = path_to(topology_, b, base);
    joints.insert(joints.end(), others.begin(), others.end());
    for (const int joint : joints) groups.push_back(topology_.group_of[static_cast<std::size_t>(joint)]);
    std::ranges::sort(groups);
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    std::vector<int> directions;
    for (const int group : groups) append(group, directions);
    return directions;
  }

  /// Operations of the elimination from the last row to the first, fill-in included, until they are more than `most`.
  double operations(double most) {
    double count = 0;
    for (std::size_t q = entries_.size(); q-- > 0 && count <= most;) {
      std::vector<int> others;
      for (std::size_t b = 0; b < q; ++b)
        if (entries_[q][b]) others.push_back(static_cast<int>(b));
      couple(others);
      count += static_cast<double>(others.size()) * static_cast<double>(others.size() + 1);
    }
    return count;
  }

 private:
  void append(int group, std::vector<int>& directions) const {
    const auto [first, end] = ranges_[static_cast<std::size_t>(group)];
    for (int d = first; d < end; ++d) directions.push_back(d);
  }

  const Topology& topology_;
  std::vector<std::pair<int, int>> ranges_;
  std::vector<std::vector<bool>> entries_;
};

}  // namespace

double implicit_operations(const Model& model, const Topology& topology, const Analysis& analysis, double most) {
  if (model.solver.integrator != SolverSettings::Integrator::rosenbrock) return 0;
  const auto n = static_cast<double>(free_coordinates(topology, analysis).size());
  if (n > kMostSymbolic) return n * n * n / 3;
  Pattern pattern(topology, analysis);
  pattern.add_mass();
  double forces = 0;
  each_element(model, [&](const auto& element) {
    with_ends(connection_of(element), [&](const Attachment& from, const Attachment& to) {
      const std::vector<int> directions = pattern.between(from.body, to.body);
      pattern.couple(directions);
      forces += static_cast<double>(directions.size()) * static_cast<double>(directions.size() + 1);
    });
  });
  return forces + pattern.operations(most);
}

}  // namespace mbgen
