#include "tests/system/property/coupled_joints.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mbgen::testing {
namespace {

/// Coordinates of a joint in its order. Requires: a coordinate axis, where it has one.
std::vector<std::string> coordinates_of(const RandomJoint& joint) {
  const auto letter = [](const Point& axis) {
    return std::string(1, "xyz"[std::abs(axis[0]) == 1 ? 0 : std::abs(axis[1]) == 1 ? 1 : 2]);
  };
  const std::string own = letter(joint.axis), name = joint.name;
  const std::string next = own == "x" ? "y" : own == "y" ? "z" : "x", last = own == "x" ? "z" : own == "y" ? "x" : "y";
  if (joint.type == "cylindrical") return {name + "_t" + own, name + "_r" + own};
  if (joint.type == "universal") return {name + "_r" + own, name + "_r" + letter(across(joint.axis))};
  if (joint.type == "planar") return {name + "_t" + next, name + "_t" + last, name + "_r" + own};
  if (joint.type == "spherical") return {name + "_rx", name + "_ry", name + "_rz"};
  if (joint.type == "free") return {name + "_tx", name + "_ty", name + "_tz", name + "_rx", name + "_ry", name + "_rz"};
  return {name};
}

}  // namespace

void add_relation(Workshop& shop, std::vector<std::string> joints, const std::vector<std::string>& coordinates) {
  Dice& dice = shop.dice();
  std::string text;
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    const std::string factor = std::to_string((dice.chance(0.5) ? 1 : -1) * dice.between(0.3, 3));
    const std::string z = "z." + coordinates[k];
    const bool is_curved = k > 0 && dice.chance(0.3);
    text += (k == 0 ? "" : " + ") + factor + "*" + (is_curved ? "(sin(" + z + ") + 0.3*" + z + "^2)" : z);
  }
  std::vector<RandomRelation>& relations = shop.mechanism().relations;
  relations.push_back({"relation" + std::to_string(relations.size()), text, std::move(joints), {}, false});
}

void add_coupled_joints(Workshop& shop) {
  static constexpr const char* kTypes[] = {"cylindrical", "universal", "spherical", "planar", "free"};
  Dice& dice = shop.dice();
  const int count = 3 + dice.upto(2), first = dice.upto(1);
  std::vector<std::pair<std::string, std::string>> coordinates;  // with their joints
  for (int k = 0; k < count; ++k) {
    const bool several = k == first || dice.chance(0.3);
    const int from = k == 0 ? kOnGround : dice.chance(0.7) ? k - 1 : dice.upto(k - 1);
    shop.hang(several ? kTypes[dice.upto(4)] : plain_type(dice), from);
    RandomJoint& joint = shop.mechanism().joints.back();
    if (several) {
      joint.axis = {};
      joint.axis[dice.upto(2)] = 1;
    }
    for (const std::string& coordinate : coordinates_of(joint)) coordinates.emplace_back(joint.name, coordinate);
  }
  const int wanted = 1 + dice.upto(1), last = static_cast<int>(coordinates.size()) - 1;
  for (int k = 0; k < wanted; ++k) {
    // The last coordinates are the relations' own.
    std::vector<int> places{last - k, dice.upto(last - wanted)};
    if (const int other = dice.upto(last - wanted); dice.chance(0.4) && other != places[1]) places.push_back(other);
    std::rotate(places.begin(), places.begin() + dice.upto(1), places.end());
    std::vector<std::string> joints, names;
    for (const int place : places) {
      joints.push_back(coordinates[static_cast<std::size_t>(place)].first);
      names.push_back(coordinates[static_cast<std::size_t>(place)].second);
    }
    add_relation(shop, joints, names);
  }
  if (dice.chance(0.2)) shop.add_rod(kOnGround, shop.size() - 1, dice.chance(0.5) ? 0.7 : 0);
}

}  // namespace mbgen::testing
