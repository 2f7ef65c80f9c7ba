#include "compiler/topology/names.hpp"

#include <numeric>

namespace mbgen {

std::string body_name(const Topology& topology, int body) {
  return body == kGround ? "ground" : topology.bodies[body].name;
}

std::vector<std::string> coordinate_names(const Topology& topology, const std::vector<int>& joints) {
  std::vector<std::string> names;
  for (const int joint : joints) names.push_back(topology.bodies[joint].coordinate);
  return names;
}

std::vector<std::string> coordinate_names(const Topology& topology) {
  std::vector<int> all(static_cast<std::size_t>(topology.size()));
  std::iota(all.begin(), all.end(), 0);
  return coordinate_names(topology, all);
}

std::vector<std::string> local_names(const Topology& topology, const LoopBlock& block,
                                     const std::vector<int>& columns) {
  std::vector<std::string> names;
  for (const int column : columns) names.push_back(topology.bodies[block.joints[column]].coordinate);
  return names;
}

std::vector<std::string> loop_names(const Topology& topology, const LoopBlock& block) {
  std::vector<std::string> names;
  for (const int loop : block.loops) names.push_back(topology.loops[loop].name);
  return names;
}

}  // namespace mbgen
