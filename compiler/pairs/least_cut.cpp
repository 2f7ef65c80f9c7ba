#include "compiler/pairs/least_cut.hpp"

#include <algorithm>

namespace mbgen {
namespace {

/// Arcs with the room that paths have left them, side by side for each node.
class Network {
 public:
  Network(std::size_t nodes, const std::vector<CostArc>& arcs) : first_(nodes + 1, 0), arcs_(2 * arcs.size()) {
    for (const CostArc& arc : arcs) ++first_[arc.from + 1], ++first_[arc.to + 1];
    for (std::size_t node = 0; node < nodes; ++node) first_[node + 1] += first_[node];
    std::vector<std::uint32_t> free(first_.begin(), first_.end() - 1);
    for (const CostArc& arc : arcs) {
      const std::uint32_t there = free[arc.from]++, back = free[arc.to]++;
      arcs_[there] = {arc.to, back, arc.room};
      arcs_[back] = {arc.from, there, 0};
    }
  }

  /// Levels of nodes from `source` on, up to `sink`. Result: whether it is reached.
  bool find_levels(std::uint32_t source, std::uint32_t sink) {
    levels_.assign(first_.size() - 1, -1);
    levels_[source] = 0;
    std::vector<std::uint32_t> reached{source};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const std::uint32_t at = reached[i];
      for (std::uint32_t a = first_[at]; a < first_[at + 1]; ++a) {
        if (arcs_[a].left <= 0 || levels_[arcs_[a].to] >= 0) continue;
        levels_[arcs_[a].to] = levels_[at] + 1;
        if (arcs_[a].to == sink) return true;
        reached.push_back(arcs_[a].to);
      }
    }
    return false;
  }

  /// Fills every path of ascending levels, found backwards: every node of a level is reached from the source.
  void augment(std::uint32_t source, std::uint32_t sink) {
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1), path;
    while (true) {
      const std::uint32_t at = path.empty() ? sink : arcs_[path.back()].to;
      if (at == source) {
        fill(path);
        continue;
      }
      std::uint32_t& a = next[at];
      while (a < first_[at + 1] && !leads_back(a, levels_[at])) ++a;
      if (a < first_[at + 1]) {
        path.push_back(a);
        continue;
      }
      if (path.empty()) return;
      ++next[arcs_[arcs_[path.back()].back].to];
      path.pop_back();
    }
  }

  const std::vector<int>& levels() const { return levels_; }

 private:
  struct Arc {
    std::uint32_t to = 0, back = 0;
    long left = 0;
  };

  /// Whether the reverse of an arc from a node of this level comes from the level before and has room left.
  bool leads_back(std::uint32_t a, int level) const {
    return levels_[arcs_[a].to] == level - 1 && arcs_[arcs_[a].back].left > 0;
  }

  /// Takes the room of a path, up to its first arc that is full then.
  void fill(std::vector<std::uint32_t>& path) {
    const auto left = [&](std::uint32_t a) -> long& { return arcs_[arcs_[a].back].left; };
    long room = Decisions::kNever;
    for (const std::uint32_t a : path) room = std::min(room, left(a));
    for (const std::uint32_t a : path) left(a) -= room, arcs_[a].left += room;
    path.erase(std::ranges::find_if(path, [&](std::uint32_t a) { return left(a) == 0; }), path.end());
  }

  std::vector<std::uint32_t> first_;
  std::vector<Arc> arcs_;
  std::vector<int> levels_;
};

}  // namespace

Decisions::Question Decisions::add(long cost_of_yes, long cost_of_no) {
  const Question q = nodes_++;
  if (cost_of_yes > 0) add_cost_of_yes(q, cost_of_yes);
  if (cost_of_no > 0) add_cost_of_no(q, cost_of_no);
  return q;
}

void Decisions::arc(std::size_t from, std::size_t to, long room) {
  arcs_.push_back({static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to), room});
}

std::vector<bool> Decisions::decided() {
  Network network(nodes_, arcs_);
  while (network.find_levels(kYes, kNo)) network.augment(kYes, kNo);
  std::vector<bool> answers;
  for (const int level : network.levels()) answers.push_back(level >= 0);
  return answers;
}

}  // namespace mbgen
