#include "compiler/formulation/closure.hpp"

namespace mbgen {
namespace detail {

Triad triad(const Vector3& axis) {
  for (int k = 0; k < 3; ++k) {
    if (axis[(k + 1) % 3] != 0 || axis[(k + 2) % 3] != 0) continue;
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

Triad bent(const Triad& t, const Vector3& axis) {
  const auto dot = [](const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const double share = 1 / (1 + dot(t.axis, axis));
  // A direction across the first axis leans by its component along the second: v - (v . b) / (1 + a . b) (a + b).
  const auto turned = [&](Vector3 v) {
    const double lean = share * dot(v, axis);
    for (std::size_t i = 0; i < 3; ++i) v[i] -= lean * (t.axis[i] + axis[i]);
    return v;
  };
  return {turned(t.first), turned(t.second), axis};
}

Triad triad_on_to(const Joint& joint) {
  if (joint.type == JointType::homokinetic) return bent(triad(joint.axis), joint.second_axis);
  return triad(has_second_axis(joint.type) ? joint.second_axis : joint.axis);
}

}  // namespace detail

std::vector<std::string> equation_names(const Topology& topology, const LoopBlock& block) {
  std::vector<std::string> names;
  for (int l : block.loops)
    for (const std::string& row : topology.loops[l].rows) names.push_back(topology.loops[l].name + "." + row);
  return names;
}

}  // namespace mbgen
