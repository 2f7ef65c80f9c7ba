#include "compiler/pairs/least_cut.hpp"

#include <algorithm>

namespace mbgen {

Decisions::Question Decisions::add(long cost_of_yes, long cost_of_no) {
  of_.emplace_back();
  const Question q = of_.size() - 1;
  if (cost_of_yes > 0) add_cost_of_yes(q, cost_of_yes);
  if (cost_of_no > 0) add_cost_of_no(q, cost_of_no);
  return q;
}

void Decisions::arc(std::size_t from, std::size_t to, long room) {
  of_[from].push_back(arcs_.size());
  arcs_.push_back({to, room});
  of_[to].push_back(arcs_.size());
  arcs_.push_back({from, 0});
}

bool Decisions::find_levels() {
  level_.assign(of_.size(), -1);
  level_[kYes] = 0;
  std::vector<std::size_t> reached{kYes};
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (const std::size_t a : of_[reached[i]])
      if (arcs_[a].left > 0 && level_[arcs_[a].to] < 0) {
        level_[arcs_[a].to] = level_[reached[i]] + 1;
        reached.push_back(arcs_[a].to);
      }
  return level_[kNo] >= 0;
}

/// Fills every path of ascending levels.
void Decisions::augment() {
  std::vector<std::size_t> next(of_.size(), 0), path;
  while (true) {
    const std::size_t at = path.empty() ? kYes : arcs_[path.back()].to;
    if (at == kNo) {
      long room = kNever;
      for (const std::size_t a : path) room = std::min(room, arcs_[a].left);
      for (const std::size_t a : path) arcs_[a].left -= room, arcs_[a ^ 1].left += room;
      path.erase(std::ranges::find_if(path, [&](std::size_t a) { return arcs_[a].left == 0; }), path.end());
      continue;
    }
    bool goes_on = false;
    for (std::size_t& i = next[at]; i < of_[at].size(); ++i) {
      const Arc& arc = arcs_[of_[at][i]];
      if (arc.left <= 0 || level_[arc.to] != level_[at] + 1) continue;
      path.push_back(of_[at][i]);
      goes_on = true;
      break;
    }
    if (goes_on) continue;
    if (path.empty()) return;
    const std::size_t before = arcs_[path.back() ^ 1].to;
    path.pop_back();
    ++next[before];
  }
}

std::vector<bool> Decisions::decided() {
  while (find_levels()) augment();
  std::vector<bool> answers;
  for (const int level : level_) answers.push_back(level >= 0);
  return answers;
}

}  // namespace mbgen
