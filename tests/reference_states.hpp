#pragma once
// States with accelerations of an independent solver, as tests/data/refused/*_ref.json and the like give them.

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/mechanism_support.hpp"

namespace mbgen::testing {

/// A state with what an independent solver makes of it.
struct JudgedState {
  GenericState state;
  std::vector<double> tau, zdd;  ///< by tree coordinate
};

/// The states of a file, relative to the source folder, in the order of the mechanism's coordinates.
inline std::vector<JudgedState> reference_states(const Mechanism& m, const std::string& relative) {
  const auto file = nlohmann::json::parse(std::ifstream(source_path(relative)));
  std::vector<JudgedState> states;
  for (const auto& s : file["states"]) {
    JudgedState reference{reference_state(m), std::vector<double>(m.topology.bodies.size()), {}};
    reference.zdd = reference.tau;
    for (std::size_t i = 0; i < file["joint_order"].size(); ++i) {
      const auto place =
          static_cast<std::size_t>(find_coordinate(m.topology, file["joint_order"][i].get<std::string>()));
      reference.state.z.at(place) = s["z"][i];
      reference.state.zd.at(place) = s["zd"][i];
      reference.tau.at(place) = s["tau"][i];
      reference.zdd.at(place) = s["zdd"][i];
    }
    states.push_back(std::move(reference));
  }
  return states;
}

}  // namespace mbgen::testing
