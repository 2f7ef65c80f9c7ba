#include "bench/compare/agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "workbench/cost/bench_states.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/files.hpp"

namespace mbgen::compare {
namespace {

/// Accelerations with massless rods, which the reader of states does not know.
void take_massless_accelerations(const std::string& path, StatesFile& file) {
  const nlohmann::json json = nlohmann::json::parse(read_text(path));
  for (std::size_t s = 0; s < file.states.size(); ++s) {
    const std::vector<double> zdd = json["states"][s]["zdd_massless_rods"];
    for (std::size_t i = 0; i < zdd.size(); ++i)
      file.states[s].zdd[static_cast<std::size_t>(file.coordinate[i])] = zdd[i];
  }
}

}  // namespace

StatesInUse states_in_use(const Compilation& compilation, const std::string& file, bool rods_are_massless,
                          const Engine& projecting, const Contestant& reference) {
  const std::vector<double> inputs = input_values(compilation.model, {});
  if (!file.empty()) {
    StatesFile read = read_states(file, compilation, inputs);
    if (rods_are_massless) take_massless_accelerations(file, read);
    return {fmt::format("{} states of {}", read.states.size(), std::filesystem::path(file).filename().string()),
            read.states};
  }
  std::vector<FileState> states = random_states(compilation, projecting, inputs);
  for (FileState& state : states) {
    GenericDerivative derivative;
    reference.engine.accelerations(state.at, derivative);
    state.zdd = derivative.zdd;
  }
  return {fmt::format("{} random consistent states, reference: {}", states.size(), reference.name), states};
}

double deviation(const Contestant& contestant, const std::vector<FileState>& states) {
  double largest = 0;
  for (const FileState& state : states) {
    GenericDerivative derivative;
    if (!contestant.engine.accelerations(state.at, derivative).ok()) return std::numeric_limits<double>::infinity();
    double difference = 0;
    for (std::size_t i = 0; i < state.zdd.size(); ++i) {
      const double d = std::abs(derivative.zdd[i] - state.zdd[i]);
      difference = d <= difference ? difference : d;  // keeps what is not a number
    }
    const double relative = difference / largest_absolute(state.zdd);
    largest = relative <= largest ? largest : relative;
  }
  return largest;
}

}  // namespace mbgen::compare
