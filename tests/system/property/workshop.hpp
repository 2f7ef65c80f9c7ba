#pragma once
// Where random mechanisms are built, body by body. Inside the property tests.

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tests/system/property/random_mechanism.hpp"

namespace mbgen::testing {

/// Numbers of one mechanism.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int upto(int highest) { return std::uniform_int_distribution<int>(0, highest)(random_); }
  bool chance(double share) { return between(0, 1) < share; }
  Point point(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }

  /// A coordinate axis as often as any direction.
  Point axis() {
    if (chance(0.5)) {
      Point result{};
      result[upto(2)] = chance(0.5) ? 1 : -1;
      return result;
    }
    Point result = point(1);
    const double length = std::hypot(result[0], result[1], result[2]);
    if (length < 0.1) return {0, 0, 1};
    for (double& component : result) component /= length;
    return result;
  }

 private:
  std::mt19937_64 random_;
};

/// A real inertia: that of three masses on skew lines, so that the triangle inequality holds.
inline std::array<double, 6> inertia_of(Dice& dice, double mass) {
  std::array<double, 6> result{};
  for (int k = 0; k < 4; ++k) {
    const Point p = dice.point(0.3);
    const double m = mass / 4;
    result[0] += m * (p[1] * p[1] + p[2] * p[2]);
    result[1] += m * (p[0] * p[0] + p[2] * p[2]);
    result[2] += m * (p[0] * p[0] + p[1] * p[1]);
    result[3] -= m * p[0] * p[1];
    result[4] -= m * p[0] * p[2];
    result[5] -= m * p[1] * p[2];
  }
  for (int i = 0; i < 3; ++i) result[i] += 0.002 * mass;
  return result;
}

/// Builds a mechanism body by body.
class Workshop {
 public:
  Workshop(Dice& dice, std::uint64_t seed) : dice_(dice) { made_.seed = seed; }

  RandomMechanism made() && { return std::move(made_); }
  Dice& dice() { return dice_; }
  int size() const { return static_cast<int>(made_.bodies.size()); }
  const Point& place_of(int body) const { return body == kOnGround ? origin_ : places_[body]; }
  RandomMechanism& mechanism() { return made_; }

  int add_body(const Point& place) {
    const double mass = std::exp(dice_.between(-1, 2));
    made_.bodies.push_back(
        {"b" + std::to_string(size()), mass, plus(place, dice_.point(0.2)), inertia_of(dice_, mass)});
    places_.push_back(place);
    return size() - 1;
  }

  void add_joint(const std::string& type, int from, int to, const Point& at, const Point& axis, bool cut = false) {
    made_.joints.push_back({"j" + std::to_string(made_.joints.size()), type, from, to, at, axis, cut});
  }

  /// A new body on another one.
  int hang(const std::string& type, int from) {
    const Point at = plus(place_of(from), dice_.point(0.4));
    const int body = add_body(plus(at, dice_.point(0.3)));
    // Now and then the file says it the other way round.
    if (from != kOnGround && dice_.chance(0.2))
      add_joint(type, body, from, at, dice_.axis());
    else
      add_joint(type, from, body, at, dice_.axis());
    return body;
  }

  void add_rod(int from, int to, double mass) { link("rod", from, to, mass, 0); }
  void add_spring(int from, int to) { link("spring", from, to, 0, std::exp(dice_.between(2, 7))); }

  /// A bushing between two bodies, wherever they are.
  void add_bushing(int from, int to) {
    RandomBushing bushing{"bushing" + std::to_string(made_.bushings.size()), from, to,
                          plus(place_of(to), dice_.point(0.3)), dice_.axis()};
    bushing.axis2 = plus(across(bushing.axis), times(0.2, bushing.axis));
    for (std::size_t i = 0; i < 6; ++i)
      bushing.stiffness[i] = std::exp(i < 3 ? dice_.between(2, 7) : dice_.between(-1, 3));
    made_.bushings.push_back(bushing);
  }

 private:
  void link(const char* kind, int from, int to, double mass, double stiffness) {
    const Point start = plus(place_of(from), dice_.point(0.3)), end = plus(place_of(to), dice_.point(0.3));
    made_.links.push_back({kind + std::to_string(made_.links.size()), from, to, start, end, mass, stiffness});
  }

  Dice& dice_;
  Point origin_{};
  RandomMechanism made_;
  std::vector<Point> places_;
};

inline std::string plain_type(Dice& dice) { return dice.chance(0.75) ? "revolute" : "prismatic"; }

/// A chain of `count` bodies from a body.
inline std::vector<int> grow_chain(Workshop& shop, int count, int from, bool plain) {
  std::vector<int> chain;
  for (int k = 0; k < count; ++k) chain.push_back(from = shop.hang(plain ? plain_type(shop.dice()) : "revolute", from));
  return chain;
}

}  // namespace mbgen::testing
