#pragma once
// Elements of a mechanism at one instant: what their forces, outputs and energies look at.

#include <algorithm>
#include <cmath>
#include <vector>

#include "compiler/model/auxiliary_states.hpp"
#include "runtime/judges/laws.hpp"
#include "runtime/judges/mechanism.hpp"

namespace mbgen::cartesian {

/// A mechanism at one instant; x: all auxiliary states.
struct AtWork {
  const CartesianMechanism& c;
  const std::vector<Moving>& bodies;
  const std::vector<double>& x;
  const Values& value;
};

/// Place of an element in the model's list.
template <class Kind>
std::size_t index_of(const AtWork& at, const Kind& element) {
  return static_cast<std::size_t>(&element - KindOf<Kind>::list(at.c.model).data());
}

/// Its places, see ElementPart.
template <class Kind>
const ElementPart& part_of(const AtWork& at, const Kind& element) {
  return at.c.parts.elements[kKindIndex<Kind>][index_of(at, element)];
}

inline Load force_at(const End& end, const Eigen::Vector3d& force) {
  return {end.body, (Vector6d() << force, end.arm.cross(force)).finished()};
}

/// An element between two points as it is now.
struct Line {
  End from, to;
  Eigen::Vector3d direction;
  double length, rate;
};

inline Line line_between(const Place& first, const Place& last, const std::vector<Moving>& bodies) {
  const End from = end_of(bodies, first), to = end_of(bodies, last);
  const Eigen::Vector3d gap = to.position - from.position;
  const double length = gap.norm();
  const Eigen::Vector3d direction = gap / length;
  return {from, to, direction, length, direction.dot(to.velocity - from.velocity)};
}

inline void add_tension(const Line& line, double tension, Forces& forces) {
  forces.loads.push_back(force_at(line.from, tension * line.direction));
  forces.loads.push_back(force_at(line.to, -tension * line.direction));
}

/// Adds a force on a coordinate of the model.
inline void add_on_coordinate(const AtWork& at, const CoordinateReference& coordinate, double force, Forces& forces) {
  const int i = at.value.table[coordinate.joint][coordinate.component];
  if (i >= 0) forces.joints[i] += force;
}

/// Integral over an interval by Gauss's rule with five places, exact for polynomials up to the ninth degree.
template <class Function>
inline double integral(double from, double to, const Function& function) {
  const double inner = std::sqrt(5 - 2 * std::sqrt(10.0 / 7)) / 3, outer = std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 3;
  const double inner_weight = (322 + 13 * std::sqrt(70.0)) / 900, outer_weight = (322 - 13 * std::sqrt(70.0)) / 900;
  const double middle = (from + to) / 2, half = (to - from) / 2;
  double sum = 128.0 / 225 * function(middle);
  for (const double side : {-half, half})
    sum += inner_weight * function(middle + side * inner) + outer_weight * function(middle + side * outer);
  return half * sum;
}

/// Places between zero and `to` where a table changes its polynomial, and both ends.
inline std::vector<double> corners(const Table& table, double to) {
  const double width = table.x.back() - table.x.front(), low = std::min(0.0, to), high = std::max(0.0, to);
  const double first = table.periodic ? std::floor((low - table.x.front()) / width) : 0;
  const double last = table.periodic ? std::ceil((high - table.x.front()) / width) : 0;
  std::vector<double> places{low, high};
  for (double period = first; period <= last; ++period)
    for (const double x : table.x)
      if (x + period * width > low && x + period * width < high) places.push_back(x + period * width);
  std::sort(places.begin(), places.end());
  if (to < 0) std::reverse(places.begin(), places.end());
  return places;
}

/// Work of a law from zero to the argument.
inline double work_of(const std::optional<Law>& characteristic, const Values& value, double to) {
  const auto force = [&](double at) { return law(characteristic, value, at); };
  const Table* table = characteristic ? std::get_if<Table>(&*characteristic) : nullptr;
  if (!table) return integral(0, to, force);
  const std::vector<double> places = corners(*table, to);
  double work = 0;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) work += integral(places[i], places[i + 1], force);
  return work;
}

}  // namespace mbgen::cartesian
