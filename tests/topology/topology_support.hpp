#pragma once
// Models for the topology room's tests, built by hand: names and connections only, no geometry.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "compiler/topology/topology.hpp"

namespace mbgen::testing {

/// A model under construction. Bodies appear when first named, with mass 1; every freedom is about or along y.
class ModelBuilder {
 public:
  ModelBuilder() { model.ground = body("ground"); }

  int body(const std::string& name) {
    const auto found = index_.find(name);
    if (found != index_.end()) return found->second;
    Body body;
    body.name = name;
    body.where = {"test.json", static_cast<int>(model.bodies.size()) + 1, 1, "/bodies/" + name};
    body.mass = name == "ground" ? 0.0 : 1.0;
    body.points.push_back({"p", {}});
    index_[name] = static_cast<int>(model.bodies.size());
    model.bodies.push_back(body);
    return index_[name];
  }

  ModelBuilder& joint(const std::string& name, JointType type, const std::string& from, const std::string& to,
                      CutMark cut = CutMark::automatic) {
    Joint joint;
    joint.name = name;
    joint.where = {"test.json", 100 + static_cast<int>(model.joints.size()), 1, "/joints/" + name};
    joint.type = type;
    joint.from = {body(from), 0};
    joint.to = {body(to), 0};
    joint.cut = cut;
    joint.freedoms = freedoms(name, type);
    model.joints.push_back(joint);
    return *this;
  }

  ModelBuilder& revolute(const std::string& name, const std::string& from, const std::string& to,
                         CutMark cut = CutMark::automatic) {
    return joint(name, JointType::revolute, from, to, cut);
  }

  ModelBuilder& rod(const std::string& name, const std::string& from, const std::string& to, double mass = 0) {
    Rod rod;
    rod.name = name;
    rod.where = {"test.json", 200 + static_cast<int>(model.rods.size()), 1, "/rods/" + name};
    rod.from = {body(from), 0};
    rod.to = {body(to), 0};
    rod.mass = mass;
    model.rods.push_back(rod);
    return *this;
  }

  /// Takes the mass of a body away.
  ModelBuilder& massless(const std::string& name) {
    model.bodies[body(name)].mass = 0.0;
    return *this;
  }

  Model model;

 private:
  static std::vector<Freedom> freedoms(const std::string& name, JointType type) {
    static const std::map<JointType, std::vector<std::string>> suffixes = {
        {JointType::revolute, {""}},
        {JointType::prismatic, {""}},
        {JointType::cylindrical, {"_ty", "_ry"}},
        {JointType::universal, {"_rx", "_ry"}},
        {JointType::spherical, {"_rz", "_ry", "_rx"}},
        {JointType::planar, {"_tx", "_ty", "_rz"}},
        {JointType::free, {"_tx", "_ty", "_tz", "_rz", "_ry", "_rx"}},
        {JointType::fixed, {}}};
    std::vector<Freedom> freedoms;
    for (const std::string& suffix : suffixes.at(type)) {
      Freedom freedom{name + suffix, FreedomKind::revolute, {0, 0, 0}};
      const char letter = suffix.empty() ? 'y' : suffix.back();
      freedom.axis[letter - 'x'] = 1;
      const bool slides = suffix.empty() ? type == JointType::prismatic : suffix[1] == 't';
      freedom.kind = slides ? FreedomKind::prismatic : FreedomKind::revolute;
      freedoms.push_back(freedom);
    }
    return freedoms;
  }

  std::map<std::string, int> index_;
};

/// The topology; a failure stops the test with its diagnostics.
inline Topology topology_of(const Model& model) {
  Result<Topology> result = build_topology(model);
  if (!result) throw std::runtime_error(to_text(result.problems()));
  return *result;
}

/// The diagnostics, empty when the model is sound.
inline Diagnostics problems_of(const Model& model) {
  const Result<Topology> result = build_topology(model);
  return result ? Diagnostics{} : result.problems();
}

inline std::vector<std::string> coordinates(const Topology& topology) {
  std::vector<std::string> names;
  for (const TreeBody& body : topology.bodies) names.push_back(body.coordinate);
  return names;
}

inline std::vector<std::string> body_names(const Topology& topology) {
  std::vector<std::string> names;
  for (const TreeBody& body : topology.bodies) names.push_back(body.name);
  return names;
}

inline std::vector<int> parents(const Topology& topology) {
  std::vector<int> indices;
  for (const TreeBody& body : topology.bodies) indices.push_back(body.parent);
  return indices;
}

inline std::vector<std::string> loop_names(const Topology& topology) {
  std::vector<std::string> names;
  for (const Loop& loop : topology.loops) names.push_back(loop.name);
  return names;
}

/// Coordinates by name, for loops, blocks and groups.
inline std::vector<std::string> names_of(const Topology& topology, const std::vector<int>& joints) {
  std::vector<std::string> names;
  for (int joint : joints) names.push_back(topology.bodies[joint].coordinate);
  return names;
}

}  // namespace mbgen::testing
