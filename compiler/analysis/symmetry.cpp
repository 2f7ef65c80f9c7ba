#include "compiler/analysis/symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "compiler/analysis/configuration.hpp"

namespace mbgen {
namespace {

constexpr double kMirrorShare = 1e-9;     // of the extent, and of the largest of an inertia: what typed decimals leave
constexpr std::size_t kMostPlanes = 3;    // asked for by most pairs
constexpr std::size_t kMostBodies = 500;  // pairs of them: 125 000 planes

Vector<double> reflected(const Mirror& m, const Vector<double>& direction) {
  const Vector<double> n = constant<double>(m.normal);
  return direction - (2 * dot(n, direction)) * n;
}

Vector<double> reflected_point(const Mirror& m, const Vector<double>& point) {
  return reflected(m, point) + (2 * m.offset) * constant<double>(m.normal);
}

double length(const Vector<double>& v) { return std::sqrt(dot(v, v)); }

double extent_of(const Constants<double>& constants) {
  double extent = 0;
  for (const Vector<double>& origin : constants.origin) extent = std::max(extent, length(origin));
  return std::max(extent, 1e-3);  // m: all joints at the origin of the axes
}

/// Planes half way between joints of bodies of equal mass, in decreasing order of their pairs.
std::vector<Mirror> planes(const Topology& topology, const Constants<double>& c, double tolerance) {
  struct Counted {
    Mirror plane;
    int pairs = 1;
  };
  std::vector<Counted> found;
  std::multimap<double, std::size_t> by_distance;  // index into found
  std::vector<int> with_mass;
  for (int i = 0; i < topology.size(); ++i)
    if (c.mass[i] > 0 && with_mass.size() < kMostBodies) with_mass.push_back(i);
  for (std::size_t a = 0; a < with_mass.size(); ++a)
    for (std::size_t b = a + 1; b < with_mass.size(); ++b) {
      const int i = with_mass[a], j = with_mass[b];
      if (topology.bodies[i].kind != topology.bodies[j].kind || c.mass[i] != c.mass[j]) continue;
      // Joints in one point may lie on the plane.
      const bool in_one_point = length(c.origin[j] - c.origin[i]) < tolerance;
      const Vector<double> from = in_one_point ? c.origin[i] + c.com[i] : c.origin[i];
      const Vector<double> to = in_one_point ? c.origin[j] + c.com[j] : c.origin[j];
      const Vector<double> across = to - from;
      const double apart = length(across);
      if (apart < tolerance) continue;
      const Vector<double> n = (1 / apart) * across;
      Mirror plane;
      plane.normal = {n.x, n.y, n.z};
      plane.offset = 0.5 * dot(n, from + to);
      const auto is_same = [&](const Counted& other) {
        const double along = dot(n, constant<double>(other.plane.normal));
        return std::abs(std::abs(along) - 1) < kMirrorShare &&
               std::abs(other.plane.offset - (along < 0 ? -1 : 1) * plane.offset) < tolerance;
      };
      // Planes in the order in which they were found, by their distance from the origin: most pairs have one of their
      // own.
      const double distance = std::abs(plane.offset);
      std::size_t known = found.size();
      for (auto near = by_distance.lower_bound(distance - tolerance);
           near != by_distance.end() && near->first <= distance + tolerance; ++near)
        if (near->second < known && is_same(found[near->second])) known = near->second;
      if (known < found.size()) {
        ++found[known].pairs;
      } else {
        by_distance.emplace(distance, found.size());
        found.push_back({std::move(plane)});
      }
    }
  std::stable_sort(found.begin(), found.end(), [](const Counted& a, const Counted& b) { return a.pairs > b.pairs; });
  std::vector<Mirror> result;
  for (Counted& counted : found)
    if (result.size() < kMostPlanes) result.push_back(std::move(counted.plane));
  return result;
}

/// Sign of the coordinate of body j as the image of body i: 0 when it is not. The axis of a turn is reflected and
/// turned round.
int sign_of(const Topology& topology, const Constants<double>& c, const Mirror& m, int i, int j, double tolerance) {
  const TreeBody &body = topology.bodies[i], &other = topology.bodies[j];
  if (body.kind != other.kind || body.massless != other.massless) return 0;
  if (length(reflected_point(m, c.origin[i]) - c.origin[j]) > tolerance) return 0;
  const double turned = body.kind == FreedomKind::revolute ? -1.0 : 1.0;
  const double along = turned * dot(reflected(m, constant<double>(body.axis)), constant<double>(other.axis));
  return std::abs(std::abs(along) - 1) > kMirrorShare ? 0 : along > 0 ? 1 : -1;
}

bool is_equal(const Constants<double>& c, const Mirror& m, int i, int j, double tolerance) {
  if (std::abs(c.mass[i] - c.mass[j]) > kMirrorShare * c.mass[i]) return false;
  if (length(reflected(m, c.com[i]) - c.com[j]) > tolerance) return false;
  double largest = 0, difference = 0;
  for (const Vector<double>& axis : {Vector<double>{1, 0, 0}, Vector<double>{0, 1, 0}, Vector<double>{0, 0, 1}}) {
    const Vector<double> there = c.inertia[j] * reflected(m, axis);
    largest = std::max(largest, length(there));
    difference = std::max(difference, length(there - reflected(m, c.inertia[i] * axis)));
  }
  return difference <= kMirrorShare * largest;
}

/// Images of all bodies, parents first. Result: how many are another body.
int match(const Topology& topology, const Constants<double>& c, double tolerance, Mirror& m) {
  const int n = topology.size();
  m.image.assign(n, -1);
  m.sign.assign(n, 0);
  m.equal.assign(n, false);
  int pairs = 0;
  for (int i = 0; i < n; ++i) {
    const int parent = topology.bodies[i].parent;
    if (m.image[i] >= 0 || (parent != kGround && m.image[parent] < 0)) continue;
    const int above = parent == kGround ? kGround : m.image[parent];
    const std::vector<int>& others = above == kGround ? topology.roots : topology.children[above];
    for (const int j : others) {
      const int sign = m.image[j] < 0 ? sign_of(topology, c, m, i, j, tolerance) : 0;
      if (sign == 0) continue;
      m.image[i] = j, m.image[j] = i;
      m.sign[i] = m.sign[j] = sign;
      m.equal[i] = m.equal[j] = is_equal(c, m, i, j, tolerance);
      pairs += i != j;
      break;
    }
  }
  return pairs;
}

}  // namespace

Mirror find_mirror(const Topology& topology, const Constants<double>& constants) {
  const double tolerance = kMirrorShare * extent_of(constants);
  Mirror best;
  best.image.assign(topology.size(), -1);
  best.sign.assign(topology.size(), 0);
  best.equal.assign(topology.size(), false);
  int most = 0;
  for (Mirror& plane : planes(topology, constants, tolerance))
    if (const int pairs = match(topology, constants, tolerance, plane); pairs > most)
      best = std::move(plane), most = pairs;
  return best;
}

Mirror find_mirror(const Model& model, const Topology& topology) {
  return find_mirror(topology, NumericSystem(model, topology).constants());
}

bool is_symmetric(const Mirror& mirror, const LoopBlock& block, const std::vector<int>& columns) {
  if (!mirror.found()) return false;
  const auto holds = [&](int column) { return std::binary_search(columns.begin(), columns.end(), column); };
  bool has_pair = false;
  for (std::size_t c = 0; c < block.joints.size(); ++c) {
    const int image = mirror.image[block.joints[c]];
    const auto at = std::lower_bound(block.joints.begin(), block.joints.end(), image);
    if (image < 0 || at == block.joints.end() || *at != image) continue;
    const auto other = static_cast<int>(at - block.joints.begin());
    if (holds(static_cast<int>(c)) != holds(other)) return false;
    has_pair = has_pair || other != static_cast<int>(c);
  }
  return has_pair;
}

}  // namespace mbgen
