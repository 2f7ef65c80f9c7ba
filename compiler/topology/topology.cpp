#include "compiler/topology/topology.hpp"

#include <algorithm>

namespace mbgen {

bool on_path(const Topology& topology, int i, int j) {
  while (i > j) i = topology.bodies[i].parent;
  return i == j && i != kGround;
}

std::vector<std::vector<int>> path_matrix(const Topology& topology) {
  const int n = topology.size();
  std::vector<std::vector<int>> t(n, std::vector<int>(n, 0));
  for (int i = 0; i < n; ++i)
    for (int j = i; j != kGround; j = topology.bodies[j].parent) t[n - 1 - i][n - 1 - j] = 1;
  return t;
}

int lowest_common_ancestor(const Topology& topology, int a, int b) {
  while (a != b) (a > b ? a : b) = topology.bodies[std::max(a, b)].parent;
  return a;
}

std::vector<int> path_to(const Topology& topology, int i, int base) {
  std::vector<int> path;
  for (; i != base && i != kGround; i = topology.bodies[i].parent) path.push_back(i);
  return path;
}

int tree_coordinate(const Topology& topology, const CoordinateReference& reference) {
  for (int i = 0; i < topology.size(); ++i)
    if (topology.bodies[i].joint == reference.joint && topology.bodies[i].component == reference.component) return i;
  return -1;
}

int find_coordinate(const Topology& topology, const std::string& name) {
  for (int i = 0; i < topology.size(); ++i)
    if (topology.bodies[i].coordinate == name) return i;
  return -1;
}

}  // namespace mbgen
