#include "compiler/topology/twins.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <utility>

namespace mbgen {
namespace {

/// Structure of groups of joints, with everything they carry.
struct Builds {
  std::vector<std::size_t> number;           ///< per group; equal for equal structure
  std::vector<std::vector<std::size_t>> on;  ///< per group, the groups carried by it
};

/// Freedoms and loops of a group; bodies by their position in it.
std::string text_of(const Topology& topology, const JointGroup& group) {
  const auto place = [&](int body) {
    return std::distance(group.joints.begin(), std::ranges::find(group.joints, body));
  };
  std::string text;
  for (const int i : group.joints) {
    const TreeBody& body = topology.bodies[i];
    text += fmt::format("{} {} {},", place(body.parent), static_cast<int>(body.kind), body.massless);
  }
  if (group.block >= 0)
    for (const int loop : topology.blocks[group.block].loops) {
      const Loop& closed = topology.loops[loop];
      text += fmt::format("{} {} {},", name_of(closed.kind), place(closed.body_from), place(closed.body_to));
    }
  return text;
}

Builds builds_of(const Topology& topology) {
  const std::size_t count = topology.groups.size();
  Builds builds{std::vector<std::size_t>(count), std::vector<std::vector<std::size_t>>(count)};
  for (std::size_t g = 0; g < count; ++g)
    if (topology.groups[g].parent >= 0) builds.on[topology.groups[g].parent].push_back(g);
  std::map<std::string, std::size_t> numbers;
  for (std::size_t g = count; g-- > 0;) {
    const JointGroup& group = topology.groups[g];
    std::string text = text_of(topology, group);
    for (const std::size_t other : builds.on[g]) {
      const auto base = std::ranges::find(group.joints, topology.groups[other].base);
      text += fmt::format("({} {})", std::distance(group.joints.begin(), base), builds.number[other]);
    }
    builds.number[g] = numbers.try_emplace(text, numbers.size()).first->second;
  }
  return builds;
}

/// Joints of a group and of everything it carries, in an order that depends on its structure only.
std::vector<int> joints_of(const Topology& topology, const Builds& builds, std::size_t group) {
  std::vector<int> joints;
  std::vector<std::size_t> groups{group};
  for (std::size_t k = 0; k < groups.size(); ++k) {
    const std::vector<int>& own = topology.groups[groups[k]].joints;
    joints.insert(joints.end(), own.begin(), own.end());
    groups.insert(groups.end(), builds.on[groups[k]].begin(), builds.on[groups[k]].end());
  }
  return joints;
}

}  // namespace

std::vector<int> find_twins(const Topology& topology) {
  const Builds builds = builds_of(topology);
  std::vector<int> twin(topology.bodies.size(), -1);
  std::map<std::pair<int, std::size_t>, std::size_t> waiting;  // by carrying group and structure
  for (std::size_t g = 0; g < topology.groups.size(); ++g) {
    const int base = topology.groups[g].base;
    if (base != kGround && twin[base] >= 0) continue;  // inside of one already
    const auto [other, is_first] = waiting.try_emplace({base, builds.number[g]}, g);
    if (is_first) continue;
    const std::vector<int> joints = joints_of(topology, builds, other->second), those = joints_of(topology, builds, g);
    for (std::size_t k = 0; k < joints.size(); ++k) {
      twin[joints[k]] = those[k];
      twin[those[k]] = joints[k];
    }
    waiting.erase(other);
  }
  return twin;
}

}  // namespace mbgen
