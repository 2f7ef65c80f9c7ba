#pragma once
// Reference states of the vehicles and of mechanisms that were refused: accelerations of an independent solver
// (tests/data/reference/README.md).

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/mechanism_support.hpp"

namespace mbgen::testing {

struct ReferenceState {
  GenericState state;
  std::vector<double> tau, zdd;
  std::vector<double> zdd_massless_rods;  ///< empty where the file has none
};

/// The states of a file, coordinates matched by name.
inline std::vector<ReferenceState> reference_states(const Topology& topology, const std::string& relative) {
  const auto file = nlohmann::json::parse(std::ifstream(source_path(relative)));
  std::vector<std::size_t> place;
  for (const std::string name : file["joint_order"])
    place.push_back(static_cast<std::size_t>(find_coordinate(topology, name)));
  std::vector<ReferenceState> states;
  for (const auto& s : file["states"]) {
    const auto in_order = [&](const char* key) {
      std::vector<double> values(s.contains(key) ? place.size() : 0);
      for (std::size_t i = 0; i < values.size(); ++i) values.at(place[i]) = s[key][i];
      return values;
    };
    states.push_back(
        {{in_order("z"), in_order("zd"), {}, 0}, in_order("tau"), in_order("zdd"), in_order("zdd_massless_rods")});
  }
  return states;
}

inline void without_rod_masses(Model& model) {
  for (Rod& rod : model.rods) rod.mass = 0.0;
}

}  // namespace mbgen::testing
