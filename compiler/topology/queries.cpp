#include "compiler/topology/topology.hpp"

namespace mbgen {

const char* name_of(ClosureKind kind) {
  switch (kind) {
    case ClosureKind::spherical:
      return "spherical";
    case ClosureKind::revolute:
      return "revolute";
    case ClosureKind::prismatic:
      return "prismatic";
    case ClosureKind::universal:
      return "universal";
    case ClosureKind::cylindrical:
      return "cylindrical";
    case ClosureKind::planar:
      return "planar";
    case ClosureKind::fixed:
      return "fixed";
    case ClosureKind::rod:
      return "rod";
    case ClosureKind::coupling:
      return "coupling";
    case ClosureKind::point_on_line:
      return "point_on_line";
    case ClosureKind::point_on_plane:
      return "point_on_plane";
    case ClosureKind::parallel_axes:
      return "parallel_axes";
    case ClosureKind::orientation:
      return "orientation";
    case ClosureKind::homokinetic:
      return "homokinetic";
    case ClosureKind::rolling_disc:
      return "rolling_disc";
    case ClosureKind::rolling_ball:
      return "rolling_ball";
    case ClosureKind::knife_edge:
      return "knife_edge";
  }
  return "unknown";
}

bool on_path(const Topology& topology, int i, int j) {
  if (j < 0) return false;
  while (i > j) i = topology.bodies[i].parent;
  return i == j;
}

std::vector<std::vector<int>> path_matrix(const Topology& topology) {
  const int n = topology.size();
  std::vector<std::vector<int>> T(n, std::vector<int>(n, 0));
  for (int i = 0; i < n; ++i) {
    for (int j = i; j != kGround; j = topology.bodies[j].parent) T[n - 1 - i][n - 1 - j] = 1;
  }
  return T;
}

int lowest_common_ancestor(const Topology& topology, int a, int b) {
  // Parents have lower indices, and ground the lowest, so the body of higher index is never the ancestor.
  while (a != b) {
    int& lower = a > b ? a : b;
    lower = topology.bodies[lower].parent;
  }
  return a;
}

std::vector<int> path_to(const Topology& topology, int i, int base) {
  std::vector<int> path;
  for (; i != base && i != kGround; i = topology.bodies[i].parent) path.push_back(i);
  return path;
}

const Where& where_of(const Model& model, const Loop& loop) {
  if (loop.coupling >= 0) return model.couplings[loop.coupling].where;
  return loop.rod >= 0 ? model.rods[loop.rod].where : model.joints[loop.joint].where;
}

bool holds_velocity_alone(const Model& model, const Loop& loop, int row) {
  return loop.joint >= 0 && closure_rows(model.joints[loop.joint].type)[static_cast<std::size_t>(row)].of_velocities;
}

std::vector<int> velocity_rows(const Model& model, const Topology& topology, const LoopBlock& block) {
  std::vector<int> rows;
  int next = 0;
  for (const int l : block.loops)
    for (int row = 0; row < topology.loops[l].equations; ++row, ++next)
      if (holds_velocity_alone(model, topology.loops[l], row)) rows.push_back(next);
  return rows;
}

const Loop* rolling_loop(const Topology& topology) {
  for (const Loop& loop : topology.loops)
    if (is_rolling(loop.kind)) return &loop;
  return nullptr;
}

int equation_count(const Topology& topology) {
  int equations = 0;
  for (const Loop& loop : topology.loops) equations += loop.equations;
  return equations;
}

int tree_coordinate(const Topology& topology, const CoordinateReference& reference) {
  for (int i = 0; i < topology.size(); ++i) {
    const TreeBody& body = topology.bodies[i];
    if (body.joint == reference.joint && body.component == reference.component) return i;
  }
  return -1;
}

int find_coordinate(const Topology& topology, const std::string& name) {
  for (int i = 0; i < topology.size(); ++i) {
    if (topology.bodies[i].coordinate == name) return i;
  }
  return -1;
}

}  // namespace mbgen
