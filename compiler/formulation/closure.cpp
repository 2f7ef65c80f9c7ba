#include "compiler/formulation/closure.hpp"

namespace mbgen {
namespace detail {

Triad triad(const Vector3& axis) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(axis[k]) != 1.0) continue;
    Triad t{{}, {}, axis};
    t.first[(k + 1) % 3] = 1;
    t.second[(k + 2) % 3] = axis[k];
    return t;
  }
  // Perpendicular to the largest and a smaller component: never close to parallel.
  const int least = std::abs(axis[0]) <= std::abs(axis[1]) ? (std::abs(axis[0]) <= std::abs(axis[2]) ? 0 : 2)
                                                           : (std::abs(axis[1]) <= std::abs(axis[2]) ? 1 : 2);
  Vector3 other{};
  other[least] = 1;
  Vector3 first{axis[1] * other[2] - axis[2] * other[1], axis[2] * other[0] - axis[0] * other[2],
                axis[0] * other[1] - axis[1] * other[0]};
  const double length = std::sqrt(first[0] * first[0] + first[1] * first[1] + first[2] * first[2]);
  for (double& value : first) value /= length;
  const Vector3 second{axis[1] * first[2] - axis[2] * first[1], axis[2] * first[0] - axis[0] * first[2],
                       axis[0] * first[1] - axis[1] * first[0]};
  return {first, second, axis};
}

}  // namespace detail

std::vector<std::string> equation_names(const Topology& topology, const LoopBlock& block) {
  std::vector<std::string> names;
  for (int l : block.loops)
    for (const std::string& row : topology.loops[l].rows) names.push_back(topology.loops[l].name + "." + row);
  return names;
}

}  // namespace mbgen
