#include "compiler/analysis/block_structure.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>

namespace mbgen {
namespace {

constexpr double kRounding = 1e-12;  // m, kg m2, 1: numbers of a model are typed decimals

class Structure {
 public:
  explicit Structure(const LoopBlock& block) : block_(block) {}

  void add(char kind, std::initializer_list<int> places) {
    text_ += kind;
    for (const int place : places) text_ += std::to_string(place) + ' ';
  }
  void add(std::initializer_list<double> values) {
    for (const double value : values)
      text_ += std::abs(value) < kRounding ? '0' : std::abs(std::abs(value) - 1) < kRounding ? '1' : 'x';
  }
  void add(const Vector<double>& v) { add({v.x, v.y, v.z}); }
  void add(const Place<double>& place) {
    add('@', {local(place.body)});
    add(place.at);
  }

  /// Place of a body in the block, -1 for the base and what moves with it.
  int local(int body) const {
    const auto at = std::lower_bound(block_.joints.begin(), block_.joints.end(), body);
    return at != block_.joints.end() && *at == body ? static_cast<int>(at - block_.joints.begin()) : -1;
  }
  std::string text() && { return std::move(text_); }

 private:
  const LoopBlock& block_;
  std::string text_;
};

void add_body(const Topology& topology, const Constants<double>& c, int i, Structure& structure) {
  const TreeBody& body = topology.bodies[i];
  structure.add(body.kind == FreedomKind::revolute ? 'r' : 'p',
                {structure.local(body.parent), static_cast<int>(topology.children[i].size()), body.massless});
  structure.add(constant<double>(body.axis));
  structure.add(body.parent == kGround ? c.origin[i] : c.origin[i] - c.origin[body.parent]);
  structure.add({c.mass[i]});
  structure.add(c.com[i]);
  for (const Vector<double>& axis : {Vector<double>{1, 0, 0}, Vector<double>{0, 1, 0}, Vector<double>{0, 0, 1}})
    structure.add(c.inertia[i] * axis);
}

}  // namespace

std::string structure_of(const System<double>& system, int block) {
  const Topology& topology = system.topology;
  const Constants<double>& constants = system.constants;
  const LoopBlock& b = topology.blocks[block];
  Structure structure(b);
  structure.add('b', {b.base == kGround});
  for (const int i : b.joints) {
    add_body(topology, constants, i, structure);
    for (const int child : topology.children[i])
      if (structure.local(child) < 0) add_body(topology, constants, child, structure);
  }
  for (const int l : b.loops) {
    const Loop& loop = topology.loops[l];
    structure.add('l', {static_cast<int>(loop.kind)});
    if (loop.rod >= 0) {
      structure.add(constants.rods[loop.rod].from);
      structure.add(constants.rods[loop.rod].to);
      structure.add({constants.rods[loop.rod].coupling});
    } else if (loop.coupling >= 0) {
      for (const auto& [joint, slope] : coupling_equation(system, loop).slopes) {
        structure.add('s', {structure.local(joint)});
        structure.add({slope});
      }
    } else {
      const Joint& joint = system.model.joints[loop.joint];
      structure.add(place_of(system, joint.from));
      structure.add(place_of(system, joint.to));
      if (joint.radius) structure.add({value_of(system.model, *joint.radius, system.environment)});
    }
  }
  return std::move(structure).text();
}

std::vector<int> first_of_structure(NumericSystem& numbers) {
  const System<double>& system = numbers.at(std::vector<double>(numbers.topology().bodies.size(), 0.0));
  std::map<std::string, int> first;
  std::vector<int> result;
  for (std::size_t b = 0; b < numbers.topology().blocks.size(); ++b)
    result.push_back(first.try_emplace(structure_of(system, static_cast<int>(b)), static_cast<int>(b)).first->second);
  return result;
}

}  // namespace mbgen
