#include "compiler/model/auxiliary_states.hpp"

#include <utility>

namespace mbgen {
namespace {

constexpr double kSlipOfRadius = 0.1;  // of a tyre's radius, what its slip states reach
constexpr double kExtension = 1e-3;    // m or rad, of the spring of a Maxwell branch

}  // namespace

std::vector<AuxiliaryState> auxiliary_states(const Model& model) {
  std::vector<AuxiliaryState> states;
  for (const Tyre& tyre : model.tyres) {
    for (const char* suffix : {"_u", "_v"})
      states.push_back({tyre.name + suffix, "m", kSlipOfRadius * tyre.radius.value});
  }
  for (const Bushing& bushing : model.bushings) {
    for (int i = 0; i < kBushingFreedoms; ++i) {
      if (!has_maxwell_branch(bushing, i)) continue;
      const std::string name(kBushingFreedomNames[static_cast<std::size_t>(i)]);
      states.push_back({bushing.name + "_" + name, i < 3 ? "m" : "rad", kExtension});
    }
  }
  return states;
}

int auxiliary_state_count(const Model& model) { return static_cast<int>(auxiliary_states(model).size()); }

int slip_state_count(const Model& model) { return 2 * static_cast<int>(model.tyres.size()); }

std::vector<std::string> auxiliary_state_names(const Model& model) {
  std::vector<std::string> names;
  for (AuxiliaryState& state : auxiliary_states(model)) names.push_back(std::move(state.name));
  return names;
}

}  // namespace mbgen
