#pragma once
// Recursive form: names of programs for reading. Numbers and other programs pass by (Annotator::has_details).

#include "compiler/formulation/recursion/recursion_state.hpp"

namespace mbgen::detail {

/// Names the inertia of a body about its origin in programs for reading, by the parallel axes where it is the body's
/// own.
template <class T>
void detail_inertia_about_origin(const RecursionState<T>& s, std::size_t i) {
  const Constants<T>& c = s.system().constants;
  if (!s.system().annotator.has_details()) return;
  const Symmetric<T> j = inertia_matrix(s.constant[i]), &own = c.inertia[i];
  const Vector<T>& at = c.com[i];
  const std::string& body = s.system().topology.bodies[i].name;
  const auto entry = [&](const T& number, const T& central, const T& a, const T& b, const char* axes) {
    s.system().annotator.detail_by(number, central + c.mass[i] * (a * a + b * b), "Io_", body, axes);
  };
  entry(j.xx, own.xx, at.y, at.z, "_xx");
  entry(j.yy, own.yy, at.x, at.z, "_yy");
  entry(j.zz, own.zz, at.x, at.y, "_zz");
}

/// Names the bias of a run in programs for reading.
template <class T>
void detail_run_bias(const RecursionState<T>& s, std::size_t u) {
  detail_name(s.system().annotator, s.runs[u].bias, "a0", "alpha0", s.system().body_name(s.units()[u].end()));
}

/// Names the share of a block in its base in programs for reading, after its first loop.
template <class T>
void detail_share(const RecursionState<T>& s, const RecursionUnit& unit, const CompositeBody<T>& base) {
  Annotator<T>& annotator = s.system().annotator;
  if (!annotator.has_details()) return;
  const Topology& topology = s.system().topology;
  const std::string& loop = topology.loops[topology.blocks[unit.block].loops.front()].name;
  detail_inertia(annotator, base.rigid + base.above, "hs_", "Ks_", "Is_", loop);
  detail_inertia(annotator, base.above, "hs_", "Ks_", "Is_", loop, "_above");
  detail_inertia(annotator, base.rigid, "hs_", "Ks_", "Is_", loop, "_rigid");
  detail_name(annotator, base.needed, "fs", "ns", loop);
}

/// Names the motion of a rotor in programs for reading. across: angular velocity of its base x its axis.
template <class T>
void detail_rotor(const RecursionState<T>& s, int rotor, const T& spin, const T& momentum, const Vector<T>& across) {
  const std::string& coordinate = s.system().topology.bodies[rotor].coordinate;
  s.system().annotator.detail(spin, "spin_", coordinate);
  s.system().annotator.detail(momentum, "momentum_", coordinate);
  detail_name(s.system().annotator, across, "wxu_", coordinate);
}

/// Names the bounds of eliminated inertias in programs for reading, see eliminate.
template <class T>
void name_bounds(Annotator<T>& annotator, T& rounding, T& lost) {
  annotator.bound(rounding, "Inertia that rounding leaves of none: a free direction with less moves nothing",
                  "inertia_of_rounding");
  annotator.bound(lost, "Share of an inertia that rounding leaves when others are taken off it", "share_of_rounding");
}

/// Names of a block's free directions in programs for reading: by their coordinates, or by number.
template <class T>
void name_directions(const RecursionState<T>& s, const RecursionUnit& unit, const std::vector<int>& columns,
                     std::vector<std::string>& directions) {
  if (!s.system().annotator.has_details()) return;
  for (const int column : columns) directions.push_back(s.work.name_of(unit.joints[column]));
}
template <class T>
void name_directions(const RecursionState<T>& s, std::size_t count, std::vector<std::string>& directions) {
  for (std::size_t q = 0; s.system().annotator.has_details() && q < count; ++q)
    directions.push_back("free_" + std::to_string(q));
}

/// Names an articulated inertia in programs for reading.
template <class T, class... Parts>
void detail_articulated(Annotator<T>& annotator, const ArticulatedInertia<T>& m, const Parts&... parts) {
  detail_name(annotator, m.linear, "Al_", parts...);
  detail_name(annotator, m.coupling, "Ac_", parts...);
  detail_name(annotator, m.angular, "Aa_", parts...);
}

/// Names the equations of free directions in programs for reading. directions: their names.
template <class T>
void detail_equations(const RecursionState<T>& s, const std::vector<std::string>& directions,
                      const UnitEquations<T>& equations) {
  Annotator<T>& annotator = s.system().annotator;
  if (!annotator.has_details()) return;
  for (std::size_t q = 0; q < equations.size(); ++q) {
    detail_name(annotator, equations.momentum[q], "F", "N", directions[q]);
    annotator.detail(equations.force[q], "Q_", directions[q]);
    for (std::size_t d = 0; d < equations.mass[q].size(); ++d)
      if (d < q) annotator.detail(equations.mass[q][d], "H_", directions[q], "_", directions[d]);
  }
}

/// Names of the directions of a run.
template <class T>
std::vector<std::string> directions_of(const RecursionState<T>& s, const RunParts<T>& run) {
  std::vector<std::string> names;
  for (const int column : run.columns) names.push_back(s.work.name_of(column));
  return names;
}

/// Names the equations of a unit after elimination in programs for reading.
template <class T>
void detail_eliminated(const RecursionState<T>& s, const std::vector<std::string>& directions,
                       const UnitEquations<T>& equations) {
  Annotator<T>& annotator = s.system().annotator;
  if (!annotator.has_details()) return;
  for (std::size_t q = 0; q < equations.size(); ++q) {
    annotator.detail(equations.reciprocal[q], "per_pivot_", directions[q]);
    annotator.detail(equations.force[q], "Q_", directions[q], "_reduced");
    detail_name(annotator, equations.momentum[q], "F", "N", directions[q], "_reduced");
    detail_name(annotator, equations.reciprocal[q] * equations.momentum[q], "F", "N", directions[q], "_per_pivot");
  }
}

}  // namespace mbgen::detail
