#include "tests/system/property/symmetric_mechanisms.hpp"

#include <numbers>

#include "tests/system/property/workshop.hpp"

namespace mbgen::testing {
namespace {

/// Adds an image of the bodies from `first` on, and of what hangs on them; bodies before `first` belong to both.
void append_image(RandomMechanism& all, const RandomMechanism& image, int first, const std::string& ending) {
  const int offset = static_cast<int>(all.bodies.size()) - first;
  const auto place = [&](int body) { return body < first ? body : body + offset; };
  const auto append = [&](auto& to, const auto& from) {
    for (auto one : from) {
      if (one.from < first && one.to < first) continue;
      one.name += ending;
      one.from = place(one.from);
      one.to = place(one.to);
      to.push_back(one);
    }
  };
  for (std::size_t b = static_cast<std::size_t>(first); b < image.bodies.size(); ++b) {
    all.bodies.push_back(image.bodies[b]);
    all.bodies.back().name += ending;
  }
  append(all.joints, image.joints);
  append(all.links, image.links);
}

/// A body on the plane y = 0 that stays on it, on ground.
void add_base(Workshop& shop) {
  Dice& dice = shop.dice();
  const Point at{dice.between(-0.3, 0.3), 0, dice.between(-0.3, 0.3)};
  RandomBody& base = shop.mechanism().bodies[shop.add_body(at)];
  base.com[1] = 0;
  base.inertia[3] = base.inertia[5] = 0;
  const bool turns = dice.chance(0.5);
  shop.add_joint(turns ? "revolute" : "prismatic", kOnGround, 0, at, turns ? Point{0, 1, 0} : Point{0, 0, 1});
}

}  // namespace

RandomMechanism random_mirror_halves(std::uint64_t seed) {
  Dice dice(seed * 1000003 + 12);
  Workshop shop(dice, seed);
  add_base(shop);
  const std::vector<int> chain = grow_chain(shop, 2 + dice.upto(1), 0, true);
  shop.add_rod(0, chain.back(), dice.chance(0.5) ? dice.between(0.2, 2) : 0);
  if (dice.chance(0.5)) shop.add_spring(0, chain.front());
  RandomMechanism all = std::move(shop).made();
  append_image(all, mirrored(all), 1, "_image");
  if (dice.chance(0.5)) {
    const int left = chain.front(), right = left + static_cast<int>(chain.size());
    const Point from = plus(all.bodies[left].com, dice.point(0.2)), to{from[0], -from[1], from[2]};
    // A rod would be singular where both ends move along the plane.
    all.links.push_back({"across", left, right, from, to, 0, 300});
  }
  return all;
}

RandomMechanism with_one_other_number(RandomMechanism halves, std::uint64_t seed) {
  Dice dice(seed);
  const int of_a_half = static_cast<int>(halves.bodies.size()) / 2;
  RandomBody& changed = halves.bodies[of_a_half + 1 + dice.upto(of_a_half - 1)];
  if (dice.chance(0.5))
    changed.mass *= 1.125;
  else
    changed.com[dice.upto(2)] += 0.03125;
  return halves;
}

RandomMechanism random_equal_legs(std::uint64_t seed) {
  Dice dice(seed * 1000003 + 14);
  Workshop shop(dice, seed);
  const std::vector<int> leg = grow_chain(shop, 2 + dice.upto(1), kOnGround, false);
  const Point foot = plus(shop.place_of(leg.back()), dice.point(0.3));
  const RandomMechanism one = shop.mechanism();
  RandomMechanism all = std::move(shop).made();
  const double half = std::sqrt(0.75);
  const std::array<Point, 3> third{{{-0.5, -half, 0}, {half, -0.5, 0}, {0, 0, 1}}};
  const RandomMechanism second = moved(one, third, {});
  append_image(all, second, 0, "_second");
  append_image(all, moved(second, third, {}), 0, "_third");
  const int platform = static_cast<int>(all.bodies.size());
  all.bodies.push_back({"platform", 3, {0, 0, foot[2] + 0.2}, {0.2, 0.2, 0.3, 0, 0, 0}});
  for (int k = 0; k < 3; ++k) {
    const double turn = 2 * std::numbers::pi / 3 * k, c = std::cos(turn), s = std::sin(turn);
    const Point at{c * foot[0] - s * foot[1], s * foot[0] + c * foot[1], foot[2]};
    const int from = leg.back() + k * static_cast<int>(leg.size());
    all.joints.push_back({"ball" + std::to_string(k), "spherical", from, platform, at, {0, 0, 1}, k > 0});
  }
  all.gravity = {0, 0, -9.81};
  return all;
}

RandomMechanism random_equal_cells(std::uint64_t seed) {
  Dice dice(seed * 1000003 + 15);
  Workshop shop(dice, seed);
  add_base(shop);
  const Point at = plus(shop.place_of(0), dice.point(0.2)), along{0, 1, 0};
  const double width = dice.between(0.3, 0.6), height = dice.between(0.2, 0.5), lean = dice.between(-0.1, 0.1);
  const auto corner = [&](double x, double z) { return plus(at, {x, 0, z}); };
  const int left = shop.add_body(corner(0, height / 2)), coupler = shop.add_body(corner(width / 2, height));
  const int right = shop.add_body(corner(width, height / 2));
  shop.add_joint("revolute", 0, left, corner(0, 0), along);
  shop.add_joint("revolute", left, coupler, corner(lean, height), along);
  shop.add_joint("revolute", 0, right, corner(width, 0), along);
  shop.add_joint("revolute", coupler, right, corner(width + lean, 1.1 * height), along, true);
  shop.hang("revolute", coupler);
  if (dice.chance(0.5)) shop.add_spring(0, coupler);
  RandomMechanism all = std::move(shop).made();
  const RandomMechanism cell = all;
  const std::array<Point, 3> same{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const int cells = 2 + dice.upto(3);
  for (int k = 1; k < cells; ++k) {
    RandomMechanism next = moved(cell, same, {0.1 * k, 0.7 * k, 0});
    append_image(all, next, 1, "_" + std::to_string(k));
  }
  return all;
}

RandomMechanism random_alike_cells(std::uint64_t seed) {
  RandomMechanism all = random_equal_cells(seed);
  Dice dice(seed);
  for (RandomBody& body : all.bodies) {
    const double share = dice.between(0.8, 1.25);
    body.mass *= share;
    for (double& entry : body.inertia) entry *= share;
  }
  return all;
}

}  // namespace mbgen::testing
