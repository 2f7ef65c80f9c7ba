#include "compiler/analysis/equations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/formulation/closure.hpp"

namespace mbgen {
namespace {

struct Row {
  std::string meaning;
  ResidualUnit unit = ResidualUnit::metre;
};

/// "x" for a coordinate axis of either sense to three digits, else the components.
std::string direction_text(const Vector3& direction) {
  for (int k = 0; k < 3; ++k)
    if (std::hypot(direction[(k + 1) % 3], direction[(k + 2) % 3]) < 5e-4) return std::string(1, "xyz"[k]);
  const auto rounded = [&](int k) { return std::round(direction[k] * 1000) / 1000 + 0.0; };  // no negative zero
  return fmt::format("({:.3g}, {:.3g}, {:.3g})", rounded(0), rounded(1), rounded(2));
}

std::vector<Row> point_rows() { return {{"position along x"}, {"position along y"}, {"position along z"}}; }

/// An axis that leans towards the first direction of its triad has turned about the second, and the other way round.
void add_tilts(const char* what, const detail::Triad& triad, std::vector<Row>& rows) {
  for (const Vector3& direction : {triad.second, triad.first})
    rows.push_back({fmt::format("{} about {}", what, direction_text(direction)), ResidualUnit::one});
}

void add_twist(const detail::Triad& triad, std::vector<Row>& rows) {
  rows.push_back({fmt::format("turn about {}", direction_text(triad.axis)), ResidualUnit::one});
}

/// Rows of rolling and blades, on a plane across the axis of the triad.
std::vector<Row> rows_of_rolling(ClosureKind kind, const detail::Triad& triad) {
  if (kind == ClosureKind::knife_edge) return {{"slip across the blade"}};
  const Row height{"height over the plane"};
  if (kind == ClosureKind::rolling_disc)
    return {height, {"slip along the rolling direction"}, {"slip across the rolling direction"}};
  return {height,
          {fmt::format("slip along {}", direction_text(triad.first))},
          {fmt::format("slip along {}", direction_text(triad.second))}};
}

/// Rows of a cut joint in the order of the formulation's joint_rows.
std::vector<Row> rows_of(ClosureKind kind, const detail::Triad& triad) {
  const auto across = [&] {
    return std::vector<Row>{{fmt::format("position across the axis along {}", direction_text(triad.first))},
                            {fmt::format("position across the axis along {}", direction_text(triad.second))}};
  };
  std::vector<Row> rows;
  switch (kind) {
    case ClosureKind::spherical:
      return point_rows();
    case ClosureKind::revolute:
      rows = point_rows();
      add_tilts("axis tilt", triad, rows);
      return rows;
    case ClosureKind::universal:
      rows = point_rows();
      rows.push_back({"right angle between the two axes", ResidualUnit::one});
      return rows;
    case ClosureKind::prismatic:
    case ClosureKind::cylindrical:
      rows = across();
      add_tilts("axis tilt", triad, rows);
      if (kind == ClosureKind::prismatic) add_twist(triad, rows);
      return rows;
    case ClosureKind::planar:
      rows = {{fmt::format("position along the normal {}", direction_text(triad.axis))}};
      add_tilts("tilt of the plane", triad, rows);
      return rows;
    case ClosureKind::fixed:
      rows = point_rows();
      add_tilts("turn", triad, rows);
      add_twist(triad, rows);
      return rows;
    case ClosureKind::point_on_line:
      return across();
    case ClosureKind::point_on_plane:
      return {{fmt::format("position along the normal {}", direction_text(triad.axis))}};
    case ClosureKind::parallel_axes:
      add_tilts("axis tilt", triad, rows);
      return rows;
    case ClosureKind::orientation:
      add_tilts("turn", triad, rows);
      add_twist(triad, rows);
      return rows;
    case ClosureKind::homokinetic:
      rows = point_rows();
      rows.push_back({"turn of one shaft against the other", ResidualUnit::one});
      return rows;
    case ClosureKind::rolling_disc:
    case ClosureKind::rolling_ball:
    case ClosureKind::knife_edge:
      return rows_of_rolling(kind, triad);
    case ClosureKind::rod:
      return {{"length of the rod"}};
    case ClosureKind::coupling:
      return {{"relation of coordinates", ResidualUnit::of_relation}};
  }
  return {};
}

}  // namespace

double opening(const Model& model, const Topology& topology, const ClosureEquation& equation, double residual) {
  const int index = topology.loops[equation.loop].rod;
  if (index < 0) return residual;
  const Rod& rod = model.rods[index];
  const Vector3 from = reference_position(model, rod.from), to = reference_position(model, rod.to);
  const double length = rod.length ? rod.length->value : std::hypot(from[0] - to[0], from[1] - to[1], from[2] - to[2]);
  return std::sqrt(length * length + 2 * length * residual) - length;  // of (d^2 - l^2) / (2 l)
}

std::string opening_text(ResidualUnit unit, double opening) {
  const double size = std::abs(opening);
  if (unit == ResidualUnit::of_relation) return fmt::format("{:.4g}", size);
  if (unit == ResidualUnit::metre) return fmt::format("{:.4g} mm", size * 1000);
  return fmt::format("{:.4g} deg", std::asin(std::min(size, 1.0)) * 180 / std::numbers::pi);
}

std::vector<ClosureEquation> closure_equations(const Model& model, const Topology& topology, const LoopBlock& block) {
  const std::vector<std::string> names = equation_names(topology, block);
  std::vector<ClosureEquation> equations;
  for (int l : block.loops) {
    const Loop& loop = topology.loops[l];
    const Vector3 axis = loop.joint < 0 ? Vector3{0, 0, 1} : model.joints[loop.joint].axis;
    for (Row& row : rows_of(loop.kind, detail::triad(axis))) {
      std::string name = names[equations.size()];
      equations.push_back({l, std::move(name), std::move(row.meaning), row.unit});
    }
  }
  return equations;
}

}  // namespace mbgen
