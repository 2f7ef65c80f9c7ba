#pragma once
// Models of the project, compiled up to the analysis, and random consistent states of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/model.hpp"
#include "compiler/reader/read_model.hpp"
#include "compiler/topology/topology.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen::testing {

struct Mechanism {
  Model model;
  Topology topology;
  Analysis analysis;
};

inline std::string source_path(const std::string& relative) { return std::string(MBGEN_SOURCE_DIR) + "/" + relative; }

/// Problems of the topology or the analysis of a model, none when both succeed.
inline Diagnostics analysis_problems(const Model& model) {
  const Result<Topology> topology = build_topology(model);
  if (!topology) return topology.problems();
  const Result<Analysis> analysis = analyse(model, *topology);
  return analysis ? Diagnostics{} : analysis.problems();
}

/// Analyses what was read; a failure stops the test with its diagnostics.
inline Mechanism analysed(const Result<Model>& model) {
  if (!model) throw std::runtime_error(to_text(model.problems()));
  Result<Topology> topology = build_topology(*model);
  if (!topology) throw std::runtime_error(to_text(topology.problems()));
  Result<Analysis> analysis = analyse(*model, *topology);
  if (!analysis) throw std::runtime_error(to_text(analysis.problems()));
  return {*model, *topology, *analysis};
}

/// A model of bench/growth_model.sh; `edit` changes its text.
inline Result<Model> grown(const std::string& kind, int size, const std::string& edit = "cat") {
  const std::string command =
      "sh " + source_path("bench/growth_model.sh") + " " + kind + " " + std::to_string(size) + " | " + edit;
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  char buffer[4096];
  while (const std::size_t count = fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, count);
  pclose(pipe);
  return read_model(text, "grown.json");
}

/// The model of a file of the project, and the one of a text.
inline Mechanism load(const std::string& relative) { return analysed(read_model_file(source_path(relative))); }
inline Mechanism mechanism_of(const std::string& text) { return analysed(read_model(text, "test.json")); }

/// Every model of models/, its iftomm/, published/ and robots/, and tests/data/models, relative to the source folder,
/// in alphabetical order; parts that models include are in folders below.
inline std::vector<std::string> all_models() {
  std::vector<std::string> paths;
  for (const char* folder : {"models", "models/iftomm", "models/published", "models/robots", "tests/data/models"}) {
    if (!std::filesystem::exists(source_path(folder))) continue;
    for (const auto& entry : std::filesystem::directory_iterator(source_path(folder)))
      if (entry.path().extension() == ".json")
        paths.push_back(std::filesystem::relative(entry.path(), source_path("")).string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// Those of them that have closures.
inline std::vector<std::string> models_with_loops() {
  std::vector<std::string> paths = all_models();
  std::erase_if(paths, [](const std::string& path) {
    const Result<Model> model = read_model_file(source_path(path));
    const Result<Topology> topology = model ? build_topology(*model) : Result<Topology>(Diagnostics{});
    return topology && topology->loops.empty();  // what cannot be read stays in, to fail
  });
  return paths;
}

/// A name that GoogleTest accepts.
inline std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

/// The reference configuration, at rest.
inline GenericState reference_state(const Mechanism& mechanism) {
  const std::vector<double> zeros(static_cast<std::size_t>(mechanism.topology.size()), 0.0);
  return {zeros, zeros, initial_auxiliary_states(mechanism.model), 0};
}

/// Share of the usual speeds that keeps forces of stiff bushings like those of other elements; of the usual positions
/// its square. Otherwise light bodies fly off, and differences over time would need shorter steps.
inline double calm_share(const Model& model) {
  constexpr double kSoft = 1e5;  // N/m
  double stiffest = kSoft;
  for (const Bushing& bushing : model.bushings)
    for (int i = 0; i < 3; ++i)
      if (const auto& own = bushing.freedoms[static_cast<std::size_t>(i)]; own && own->stiffness)
        if (const Quantity* factor = std::get_if<Quantity>(&*own->stiffness))
          stiffest = std::max(stiffest, factor->value);
  return kSoft / stiffest;
}

/// A model whose ropes have a constant stiffness: with EA they also act on the joints of their wheels, which balances
/// of bodies and of joints do not see.
inline Model with_plain_ropes(Model model) {
  for (Rope& rope : model.ropes) {
    if (rope.ea) rope.stiffness = *rope.ea;  // over 1 m
    rope.ea.reset();
  }
  return model;
}

/// Random states near the reference that satisfy closures and motions; velocities of a few units. At most `wanted`.
inline std::vector<GenericState> random_states(const Mechanism& mechanism, int wanted, double reach = 0.15) {
  const GenericSolver solver(mechanism.model, mechanism.topology, mechanism.analysis);
  const double calm = calm_share(mechanism.model);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<GenericState> states;
  for (int attempt = 0; attempt < 20 * wanted && static_cast<int>(states.size()) < wanted; ++attempt) {
    GenericState state;
    for (const TreeBody& body : mechanism.topology.bodies) {
      state.z.push_back(unit(random) * calm * calm * reach * (body.kind == FreedomKind::revolute ? 1.0 : 0.2));
      state.zd.push_back(2 * calm * unit(random));
    }
    const auto slips = static_cast<std::size_t>(first_user_state(mechanism.model));
    for (const AuxiliaryState& auxiliary : auxiliary_states(mechanism.model)) {
      const double reach_of_state = state.x.size() < slips ? 0.002 : 0.1 * magnitude_of(auxiliary);
      state.x.push_back(auxiliary.initial + reach_of_state * unit(random));
    }
    state.t = 0.3 + 0.1 * unit(random);
    if (solver.project(state).ok()) states.push_back(std::move(state));
  }
  return states;
}

/// Random joint forces of the order of the model's weight.
inline std::vector<double> random_tau(const Mechanism& mechanism, std::uint64_t seed) {
  double mass = 0;
  for (const Body& body : mechanism.model.bodies) mass += body.mass.value;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<double> tau;
  for (int i = 0; i < mechanism.topology.size(); ++i) tau.push_back(unit(random) * mass * 0.5);
  return tau;
}

/// Largest difference over the largest entry of `expected` (at least `floor`); infinite where something is no number.
inline double relative_error(const std::vector<double>& actual, const std::vector<double>& expected,
                             double floor = 1e-9) {
  double error = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double difference = std::abs(actual[i] - expected[i]);
    error = std::isnan(difference) ? std::numeric_limits<double>::infinity() : std::max(error, difference);
  }
  return error / std::max(largest_absolute(expected), floor);
}

}  // namespace mbgen::testing
