// Mechanisms made of another one: smaller, moved, mirrored, in another order.

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "compiler/algebra/dense.hpp"
#include "tests/system/property/random_mechanism.hpp"

namespace mbgen::testing {
namespace {

Point times(const std::array<Point, 3>& m, const Point& p) {
  Point result{};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) result[i] += m[i][k] * p[k];
  return result;
}

/// Without a body and what hangs on it. Requires: it bears no other body.
RandomMechanism without_body(RandomMechanism m, int body) {
  m.bodies.erase(m.bodies.begin() + body);
  const auto touches = [body](const auto& e) { return e.from == body || e.to == body; };
  for (const RandomJoint& joint : m.joints) {
    if (!touches(joint)) continue;
    std::erase_if(m.relations, [&](const RandomRelation& r) { return std::ranges::count(r.joints, joint.name) > 0; });
    for (RandomLink& link : m.links)
      if (link.felt == joint.name) link.felt = "";
  }
  std::erase_if(m.joints, touches);
  std::erase_if(m.links, touches);
  std::erase_if(m.bushings, touches);
  std::erase_if(m.contacts, touches);
  const auto renumber = [body](int& b) { b -= b > body; };
  for (RandomJoint& joint : m.joints) renumber(joint.from), renumber(joint.to);
  for (RandomLink& link : m.links) renumber(link.from), renumber(link.to);
  for (RandomBushing& bushing : m.bushings) renumber(bushing.from), renumber(bushing.to);
  for (RandomContact& contact : m.contacts) renumber(contact.from), renumber(contact.to);
  return m;
}

bool is_leaf(const RandomMechanism& m, int body) {
  return std::ranges::count_if(
             m.joints, [body](const RandomJoint& j) { return !j.cut && (j.from == body || j.to == body); }) <= 1;
}

}  // namespace

std::vector<RandomMechanism> simpler(const RandomMechanism& m) {
  std::vector<RandomMechanism> result;
  for (int b = static_cast<int>(m.bodies.size()); b-- > 0;)
    if (is_leaf(m, b)) result.push_back(without_body(m, b));
  const auto change = [&](const auto& edit) {
    RandomMechanism changed = m;
    edit(changed);
    if (model_text(changed) != model_text(m)) result.push_back(std::move(changed));
  };
  for (std::size_t l = 0; l < m.links.size(); ++l)
    change([l](RandomMechanism& c) { c.links.erase(c.links.begin() + static_cast<std::ptrdiff_t>(l)); });
  for (std::size_t b = 0; b < m.bushings.size(); ++b)
    change([b](RandomMechanism& c) { c.bushings.erase(c.bushings.begin() + static_cast<std::ptrdiff_t>(b)); });
  for (std::size_t k = 0; k < m.contacts.size(); ++k)
    change([k](RandomMechanism& c) { c.contacts.erase(c.contacts.begin() + static_cast<std::ptrdiff_t>(k)); });
  for (std::size_t j = 0; j < m.joints.size(); ++j)
    if (m.joints[j].cut)
      change([j](RandomMechanism& c) { c.joints.erase(c.joints.begin() + static_cast<std::ptrdiff_t>(j)); });
  for (std::size_t r = 0; r < m.relations.size(); ++r)
    change([r](RandomMechanism& c) { c.relations.erase(c.relations.begin() + static_cast<std::ptrdiff_t>(r)); });
  for (std::size_t l = 0; l < m.links.size(); ++l) change([l](RandomMechanism& c) { c.links[l].stroke = 0; });
  for (std::size_t l = 0; l < m.links.size(); ++l) {
    change([l](RandomMechanism& c) { c.links[l].oil = 0; });
    change([l](RandomMechanism& c) { c.links[l].felt = ""; });
    change([l](RandomMechanism& c) { c.links[l].stop = 0; });
    change([l](RandomMechanism& c) { c.links[l].grip = 0; });
  }
  change([](RandomMechanism& c) { c.gravity = {}; });
  for (std::size_t j = 0; j < m.joints.size(); ++j) {
    change([j](RandomMechanism& c) { c.joints[j].stop = 0; });
    change([j](RandomMechanism& c) { c.joints[j].grip = 0; });
    change([j](RandomMechanism& c) { c.joints[j].axis = {0, 0, 1}; });
    if (!m.joints[j].cut) change([j](RandomMechanism& c) { c.joints[j].type = "revolute"; });
  }
  for (std::size_t b = 0; b < m.bodies.size(); ++b)
    if (m.bodies[b].mass > 0)
      change([b](RandomMechanism& c) { c.bodies[b] = {c.bodies[b].name, 1, {}, {1, 1, 1, 0, 0, 0}}; });
  return result;
}

RandomMechanism moved(RandomMechanism m, const std::array<Point, 3>& rotation, const Point& translation) {
  const auto point = [&](Point& p) { p = plus(times(rotation, p), translation); };
  m.gravity = times(rotation, m.gravity);
  for (RandomBody& body : m.bodies) {
    point(body.com);
    const auto& i = body.inertia;
    const std::array<Point, 3> matrix{{{i[0], i[3], i[4]}, {i[3], i[1], i[5]}, {i[4], i[5], i[2]}}};
    const auto entry = [&](int r, int c) {
      const Point column = times(matrix, rotation[c]);
      return rotation[r][0] * column[0] + rotation[r][1] * column[1] + rotation[r][2] * column[2];
    };
    body.inertia = {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
  }
  for (RandomJoint& joint : m.joints) {
    point(joint.at);
    joint.axis = times(rotation, joint.axis);
  }
  for (RandomLink& link : m.links) point(link.start), point(link.end);
  for (RandomBushing& bushing : m.bushings) {
    point(bushing.at);
    bushing.axis = times(rotation, bushing.axis);
    bushing.axis2 = times(rotation, bushing.axis2);
  }
  for (RandomContact& contact : m.contacts) {
    point(contact.start), point(contact.end);
    contact.axis = times(rotation, contact.axis);
    contact.axis2 = times(rotation, contact.axis2);
  }
  return m;
}

RandomMechanism mirrored(RandomMechanism m) {
  const std::array<Point, 3> mirror{{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}};
  m = moved(std::move(m), mirror, {});
  for (RandomJoint& joint : m.joints)
    if (joint.type == "revolute")
      for (double& component : joint.axis) component = -component;  // a mirror turns rotations round
  return m;
}

RandomMechanism renumbered(RandomMechanism m, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<int> order(m.bodies.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::shuffle(order, random);
  std::vector<RandomBody> bodies;
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    bodies.push_back(m.bodies[order[k]]);
    place[order[k]] = static_cast<int>(k);
  }
  m.bodies = std::move(bodies);
  const auto renumber = [&](int& b) { b = b == kOnGround ? b : place[b]; };
  for (RandomJoint& joint : m.joints) renumber(joint.from), renumber(joint.to);
  for (RandomLink& link : m.links) renumber(link.from), renumber(link.to);
  for (RandomBushing& bushing : m.bushings) renumber(bushing.from), renumber(bushing.to);
  for (RandomContact& contact : m.contacts) renumber(contact.from), renumber(contact.to);
  std::ranges::shuffle(m.joints, random);
  std::ranges::shuffle(m.links, random);
  return m;
}

bool has_plain_joints(const RandomMechanism& m) {
  return std::ranges::all_of(m.joints, [](const RandomJoint& joint) {
    static constexpr const char* kPlainCuts[] = {"spherical", "point_on_line", "point_on_plane", "parallel_axes",
                                                 "rolling_ball"};
    return joint.type == "revolute" || joint.type == "prismatic" ||
           (joint.cut && std::ranges::find(kPlainCuts, joint.type) != std::end(kPlainCuts));
  });
}

bool has_one_way(const RandomMechanism& mechanism) {
  Eigen::MatrixXd lines(6, 6);
  for (int k = 0; k < 6; ++k) {
    const RandomJoint& joint = mechanism.joints[mechanism.joints.size() - 6 + static_cast<std::size_t>(k)];
    const Eigen::Vector3d axis(joint.axis.data()), at(joint.at.data());
    lines.col(k) << axis, at.cross(axis);
  }
  return kernel(lines, 1e-9).cols() == 1;
}

}  // namespace mbgen::testing
