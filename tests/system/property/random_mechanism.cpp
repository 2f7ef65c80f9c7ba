#include "tests/system/property/random_mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/system/property/coupled_joints.hpp"
#include "tests/system/property/symmetric_mechanisms.hpp"
#include "tests/system/property/workshop.hpp"

namespace mbgen::testing {
namespace {

std::string any_type(Dice& dice) {
  static constexpr const char* kTypes[] = {"revolute",  "revolute",    "prismatic", "universal",
                                           "spherical", "cylindrical", "planar",    "fixed"};
  return dice.chance(0.5) ? plain_type(dice) : kTypes[dice.upto(7)];
}

void grow_tree(Workshop& shop, int count, bool plain) {
  Dice& dice = shop.dice();
  for (int k = 0; k < count; ++k) {
    const int from = shop.size() == 0 ? kOnGround : dice.chance(0.6) ? shop.size() - 1 : dice.upto(shop.size()) - 1;
    shop.hang(plain ? plain_type(dice) : any_type(dice), from);
  }
}

void close_chain(Workshop& shop) {
  Dice& dice = shop.dice();
  const int base = dice.chance(0.5) ? kOnGround : shop.hang(plain_type(dice), kOnGround);
  const std::vector<int> chain = grow_chain(shop, 5 + dice.upto(2), base, false);
  static constexpr const char* kClosures[] = {"spherical", "universal", "cylindrical", "planar"};
  const char* type = kClosures[dice.upto(chain.size() > 5 ? 3 : 0)];
  shop.add_joint(type, base, chain.back(), plus(shop.place_of(chain.back()), dice.point(0.3)), dice.axis(), true);
  if (dice.chance(0.4)) shop.add_rod(chain[0], chain[3], dice.chance(0.5) ? 0.7 : 0);
}

/// A chain and perhaps a free body, held by joints that are equations only; at least two freedoms are left.
void close_by_equations(Workshop& shop) {
  static constexpr std::array<std::pair<const char*, int>, 5> kTypes{
      {{"point_on_line", 2}, {"point_on_plane", 1}, {"parallel_axes", 2}, {"orientation", 3}, {"homokinetic", 4}}};
  Dice& dice = shop.dice();
  const int base = dice.chance(0.5) ? kOnGround : shop.hang(plain_type(dice), kOnGround);
  std::vector<int> bodies = grow_chain(shop, 4 + dice.upto(2), base, false);
  int freedoms = static_cast<int>(bodies.size());
  if (dice.chance(0.5)) {
    bodies.push_back(shop.hang("free", kOnGround));
    freedoms += 6;
  }
  for (int tries = 0; tries < 4; ++tries) {
    const auto& [type, equations] = kTypes[dice.upto(4)];
    if (equations > freedoms - 2) continue;
    freedoms -= equations;
    const int from = dice.chance(0.5) ? base : bodies.front(), to = bodies[bodies.size() - (tries > 1 ? 2 : 1)];
    shop.add_joint(type, from, to, plus(shop.place_of(to), dice.point(0.3)), dice.axis(), true);
    if (tries > 0 && dice.chance(0.5)) return;
  }
}

/// A free body with a tail on one or two contacts; at least two freedoms are left.
void add_rolling(Workshop& shop) {
  static constexpr const char* kTypes[] = {"rolling_disc", "rolling_ball", "knife_edge"};
  Dice& dice = shop.dice();
  const int base = dice.chance(0.5) ? kOnGround : shop.hang(plain_type(dice), kOnGround);
  const int body = shop.hang("free", kOnGround);
  const std::vector<int> tail = grow_chain(shop, 1 + dice.upto(1), body, false);
  shop.add_joint(kTypes[dice.upto(2)], base, body, plus(shop.place_of(body), dice.point(0.1)), dice.axis(), true);
  if (dice.chance(0.5))
    shop.add_joint(kTypes[dice.upto(2)], kOnGround, tail.back(), plus(shop.place_of(tail.back()), dice.point(0.1)),
                   dice.axis(), true);
}

/// A free body with a tail that rolls, and that a plane guides: the plane holds what rolling holds again: a disc in
/// the plane across its axle, as add_axes gives it, a ball in any.
void add_guided_rolling(Workshop& shop) {
  Dice& dice = shop.dice();
  const int base = dice.chance(0.5) ? kOnGround : shop.hang(plain_type(dice), kOnGround);
  const int body = shop.hang("free", kOnGround);
  grow_chain(shop, 1 + dice.upto(1), body, false);
  const bool is_disc = dice.chance(0.5);
  const Point normal = dice.axis();
  Point guide = plus(across(normal), times(0.3, normal));
  if (!is_disc) guide = plus(times(0.8, across(normal)), times(dice.chance(0.5) ? 0.6 : -0.6, normal));
  shop.add_joint(is_disc ? "rolling_disc" : "rolling_ball", base, body, plus(shop.place_of(body), dice.point(0.1)),
                 normal, true);
  shop.add_joint("planar", base, body, plus(shop.place_of(body), dice.point(0.3)), guide, true);
}

/// Four-bars in the plane across `axis`, one after the other.
void add_four_bars(Workshop& shop) {
  Dice& dice = shop.dice();
  const int base = dice.chance(0.4) ? kOnGround : shop.hang("revolute", kOnGround);
  const int letter = dice.upto(2);
  Point axis{}, along{}, up{};
  axis[letter] = along[(letter + 1) % 3] = up[(letter + 2) % 3] = 1;
  const auto at = [&](double x, double y) {
    Point result = shop.place_of(base);
    for (int i = 0; i < 3; ++i) result[i] += x * along[i] + y * up[i];
    return result;
  };
  const int cells = 1 + dice.upto(2);
  const double width = dice.between(0.3, 0.6), height = dice.between(0.2, 0.5);
  int left = shop.add_body(at(0, height / 2));
  shop.add_joint("revolute", base, left, at(0, 0), axis);
  for (int c = 0; c < cells; ++c) {
    const double x = c * width, next = x + width * dice.between(0.9, 1.1);
    const int coupler = shop.add_body(at(x + width / 2, height)), right = shop.add_body(at(next, height / 2));
    shop.add_joint("revolute", left, coupler, at(x, height), axis);
    shop.add_joint("revolute", base, right, at((c + 1) * width, 0), axis);
    shop.add_joint("revolute", coupler, right, at((c + 1) * width, height), axis, true);
    left = right;
  }
}

void add_rods(Workshop& shop) {
  Dice& dice = shop.dice();
  grow_tree(shop, 3 + dice.upto(4), true);
  const int wanted = 1 + dice.upto(2);
  for (int k = 0; k < wanted; ++k) {
    const int from = dice.upto(shop.size()) - 1, to = dice.upto(shop.size() - 1);
    if (from != to) shop.add_rod(from, to, dice.chance(0.5) ? dice.between(0.2, 2) : 0);
  }
}

/// Rods, of which every other one changes its length.
void add_actuators(Workshop& shop) {
  add_rods(shop);
  std::vector<RandomLink>& links = shop.mechanism().links;
  for (std::size_t k = 0; k < links.size(); k += 2) {
    links[k].mass = 0;
    links[k].stroke = shop.dice().between(0.02, 0.06);
  }
}

/// One coordinate as a spline over another, through zero.
void add_curve(Workshop& shop, std::vector<std::string> joints) {
  Dice& dice = shop.dice();
  const double slope = (dice.chance(0.5) ? 1 : -1) * dice.between(0.3, 2), bend = dice.between(-0.3, 0.3);
  std::vector<std::array<double, 2>> points;
  for (int k = -6; k <= 6; ++k) {
    const double x = k == 0 ? 0 : 0.25 * k + dice.between(-0.08, 0.08);
    points.push_back({x, slope * x + bend * std::sin(2 * x)});
  }
  std::vector<RandomRelation>& relations = shop.mechanism().relations;
  relations.push_back(
      {"relation" + std::to_string(relations.size()), "", std::move(joints), std::move(points), dice.chance(0.4)});
}

/// A tree of plain joints, now and then with a chain of four that a rod closes; relations at most half as many as its
/// joints, each with a joint of its own.
void add_coupled(Workshop& shop) {
  Dice& dice = shop.dice();
  grow_tree(shop, 3 + dice.upto(4), true);
  const int count = shop.size();
  for (int k = 0; k < 1 + dice.upto(count / 2 - 1); ++k) {
    std::vector<std::string> joints{shop.mechanism().joints[2 * k].name, shop.mechanism().joints[2 * k + 1].name};
    const std::string& other = shop.mechanism().joints[dice.upto(count - 1)].name;
    if (dice.chance(0.4) && other != joints[0] && other != joints[1]) joints.push_back(other);
    if (joints.size() == 2 && dice.chance(0.35))
      add_curve(shop, joints);
    else
      add_relation(shop, joints, joints);
  }
  if (dice.chance(0.3)) shop.add_rod(kOnGround, count - 1, dice.chance(0.5) ? 0.7 : 0);
}

/// A chain on ground, closed by a pin or slide that is driven where it is cut; up to two freedoms are left.
void add_driven_cut(Workshop& shop) {
  Dice& dice = shop.dice();
  const std::vector<int> chain = grow_chain(shop, 6 + dice.upto(2), kOnGround, false);
  const Point tip = plus(shop.place_of(chain.back()), dice.point(0.3));
  shop.add_joint(dice.chance(0.6) ? "revolute" : "prismatic", kOnGround, chain.back(), tip, dice.axis(), true);
  shop.mechanism().joints.back().swing = dice.between(0.02, 0.1);
}

/// Links without mass between revolute joints across one another.
void add_massless_links(Workshop& shop) {
  Dice& dice = shop.dice();
  int from = kOnGround;
  for (int k = 0; k < 2 + dice.upto(2); ++k) {
    const int first = dice.upto(2);
    for (const bool massless : {true, false}) {
      const int body = shop.hang("revolute", from);
      RandomJoint& joint = shop.mechanism().joints.back();
      joint.axis = {};
      joint.axis[massless ? first : (first + 1) % 3] = 1;
      if (massless) shop.mechanism().bodies[body] = {shop.mechanism().bodies[body].name, 0, {}, {}};
      from = body;
    }
  }
}

/// A chain of pins whose last body is held by a ball, by rods, or by another pin: as many equations as coordinates.
void add_structure(Workshop& shop, int base) {
  Dice& dice = shop.dice();
  const int kind = dice.upto(2);
  const std::vector<int> chain = grow_chain(shop, kind == 0 ? 3 : kind == 1 ? 1 + dice.upto(3) : 5, base, false);
  const Point tip = plus(shop.place_of(chain.back()), dice.point(0.3));
  if (kind == 0) shop.add_joint("spherical", base, chain.back(), tip, {0, 0, 1}, true);
  if (kind == 1)
    for (int body : chain) shop.add_rod(base, body, dice.chance(0.5) ? dice.between(0.2, 2) : 0);
  if (kind == 2) shop.add_joint("revolute", base, chain.back(), tip, dice.axis(), true);
}

/// A plate on three equal eccentrics. Result: the plate.
int add_shaker(Workshop& shop, int base) {
  Dice& dice = shop.dice();
  const int letter = dice.upto(2);
  Point axis{}, along{}, up{};
  axis[letter] = along[(letter + 1) % 3] = up[(letter + 2) % 3] = 1;
  const auto in_plane = [&](const Point& from, double x, double y) {
    Point result = from;
    for (int i = 0; i < 3; ++i) result[i] += x * along[i] + y * up[i];
    return result;
  };
  const double turn = dice.between(0, 6.28), arm = dice.between(0.1, 0.3);
  const std::array<Point, 3> feet{in_plane(shop.place_of(base), dice.between(-0.1, 0.1), dice.between(-0.1, 0.1)),
                                  in_plane(shop.place_of(base), dice.between(0.4, 0.8), dice.between(-0.2, 0.2)),
                                  in_plane(shop.place_of(base), dice.between(0.1, 0.4), dice.between(0.4, 0.7))};
  int plate = kOnGround;
  for (const Point& foot : feet) {
    const Point pin = in_plane(foot, arm * std::cos(turn), arm * std::sin(turn));
    const int crank = shop.add_body(foot);
    shop.add_joint("revolute", base, crank, foot, axis);
    const bool first = plate == kOnGround;
    if (first) plate = shop.add_body(pin);
    shop.add_joint("revolute", crank, plate, pin, axis, !first);
  }
  return plate;
}

/// Three pins and a fourth that closes them, all axes through one point. Result: the body in the middle.
int add_spherical_four_bar(Workshop& shop, int base) {
  Dice& dice = shop.dice();
  const Point centre = plus(shop.place_of(base), dice.point(0.3));
  std::vector<int> chain{base};
  for (int k = 0; k < 4; ++k) {
    const double turn = 1.57 * k + dice.between(-0.4, 0.4), rise = dice.between(0.3, 0.8);
    const Point axis{std::cos(turn) * std::cos(rise), std::sin(turn) * std::cos(rise), std::sin(rise)};
    const Point at = plus(centre, {0.4 * axis[0], 0.4 * axis[1], 0.4 * axis[2]});
    if (k < 3) chain.push_back(shop.add_body(at));
    shop.add_joint("revolute", k < 3 ? chain[k] : base, chain.back(), at, axis, k == 3);
  }
  return chain[2];
}

/// See random_bricard. Result: the body opposite to the base.
int add_bricard(Workshop& shop, int base) {
  Dice& dice = shop.dice();
  const Point centre = shop.place_of(base);
  std::array<Point, 6> offsets, axes;
  for (int k = 0; k < 3; ++k) {
    offsets[k] = plus({0.5, 0, 0.4 * (k - 1)}, dice.point(0.4));
    axes[k] = dice.axis();
    offsets[k + 3] = {-offsets[k][0], -offsets[k][1], offsets[k][2]};
    axes[k + 3] = {-axes[k][0], -axes[k][1], axes[k][2]};
  }
  std::vector<int> chain{base};
  for (int k = 0; k < 6; ++k) {
    const Point at = plus(centre, offsets[k]);
    if (k < 5) chain.push_back(shop.add_body(at));
    shop.add_joint("revolute", k < 5 ? chain[k] : base, chain.back(), at, axes[k], k == 5);
  }
  return chain[3];
}

/// One or two parts that are locked or overconstrained, on ground or on a body that swings.
void add_locked_parts(Workshop& shop) {
  Dice& dice = shop.dice();
  const int swing = shop.hang("revolute", kOnGround);
  for (int left = 1 + dice.upto(1); left > 0; --left) {
    const int base = dice.chance(0.5) ? kOnGround : swing;
    int (*const kLinkages[])(Workshop&, int) = {add_shaker, add_spherical_four_bar, add_bricard};
    const int kind = dice.upto(5);
    if (kind > 2)
      add_structure(shop, base);
    else if (const int middle = kLinkages[kind](shop, base);
             dice.chance(0.4) && (kind != 2 || has_one_way(shop.mechanism())))
      shop.add_rod(base, middle, dice.chance(0.5) ? 0.7 : 0);  // locks it
  }
}

/// Every spring gets a state that pulls along, bump stops, bristles and a contact of its ends; the first plain joint a
/// stop and bristles.
void add_oil_and_rubber(RandomMechanism& made) {
  const auto is_plain = [](const RandomJoint& joint) {
    return (joint.type == "revolute" || joint.type == "prismatic") && !joint.cut && joint.swing == 0;
  };
  const auto joint = std::ranges::find_if(made.joints, is_plain);
  for (RandomLink& link : made.links) {
    if (link.stiffness == 0) continue;
    link.oil = 5 * link.stiffness;
    link.stop = 20 * link.stiffness;
    link.grip = 0.2;
    const Point way = plus(link.end, times(-1, link.start));
    RandomContact contact{link.name + "_touch", link.from, link.to, link.start, link.end};
    contact.axis = plus(across(way), times(0.5, way));
    contact.axis2 = plus(across(contact.axis), times(0.3, way));
    contact.shape = static_cast<int>((made.seed + made.contacts.size()) % 5);
    contact.stiffness = link.stop;
    made.contacts.push_back(contact);
    if (joint == made.joints.end()) continue;
    link.felt = joint->name;
    joint->stop = 30;
    joint->grip = 0.4;
  }
}

/// Bodies and joints of a family that has no function of its own.
void build(Family family, Workshop& shop, Dice& dice) {
  switch (family) {
    case Family::tree:
      grow_tree(shop, 2 + dice.upto(8), false);
      break;
    case Family::deep_chain:
      grow_chain(shop, 20 + dice.upto(40), kOnGround, true);
      break;
    case Family::closed_chain:
      close_chain(shop);
      break;
    case Family::by_equations:
      close_by_equations(shop);
      break;
    case Family::rolling:
      add_rolling(shop);
      break;
    case Family::guided_rolling:
      add_guided_rolling(shop);
      break;
    case Family::planar_loops:
      add_four_bars(shop);
      break;
    case Family::actuators:
      add_actuators(shop);
      break;
    case Family::rods:
      add_rods(shop);
      break;
    case Family::massless_links:
      add_massless_links(shop);
      break;
    case Family::floating:
      shop.hang("free", kOnGround);
      grow_chain(shop, 1 + dice.upto(4), 0, true);
      shop.mechanism().gravity = {};
      break;
    case Family::coupled:
      add_coupled(shop);
      break;
    case Family::coupled_joints:
      add_coupled_joints(shop);
      break;
    case Family::driven_cuts:
      add_driven_cut(shop);
      break;
    case Family::tiny:
      if (dice.chance(0.8)) shop.hang(dice.chance(0.3) ? "free" : any_type(dice), kOnGround);
      break;
    case Family::locked:
      add_locked_parts(shop);
      break;
    default:
      throw std::logic_error("family has a function of its own");
  }
}

}  // namespace

RandomMechanism random_bricard(std::uint64_t seed) {
  Dice dice(seed * 1000003 + 9);
  Workshop shop(dice, seed);
  add_bricard(shop, kOnGround);
  return std::move(shop).made();
}

RandomMechanism random_mechanism(Family family, std::uint64_t seed) {
  if (family == Family::mirror_halves) return random_mirror_halves(seed);
  if (family == Family::nearly_mirror_halves) return with_one_other_number(random_mirror_halves(seed), seed);
  if (family == Family::equal_legs) return random_equal_legs(seed);
  if (family == Family::equal_cells) return random_equal_cells(seed);
  if (family == Family::alike_cells) return random_alike_cells(seed);
  Dice dice(seed * 1000003 + static_cast<std::uint64_t>(family));
  Workshop shop(dice, seed);
  build(family, shop, dice);
  if (shop.size() > 1 && dice.chance(0.5)) shop.add_spring(0, shop.size() - 1);
  if (shop.size() > 1 && dice.chance(0.3)) shop.add_bushing(dice.upto(shop.size() - 2), shop.size() - 1);
  RandomMechanism made = std::move(shop).made();
  constexpr std::uint64_t kWithOil = 2;  // of so many seeds one
  if (seed % kWithOil == 0) add_oil_and_rubber(made);
  return made;
}

}  // namespace mbgen::testing
