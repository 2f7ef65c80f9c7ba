#include "compiler/model/auxiliary_states.hpp"

namespace mbgen {

int auxiliary_state_count(const Model& model) { return 2 * static_cast<int>(model.tyres.size()); }

std::vector<std::string> auxiliary_state_names(const Model& model) {
  std::vector<std::string> names;
  for (const Tyre& tyre : model.tyres) {
    names.push_back(tyre.name + "_u");
    names.push_back(tyre.name + "_v");
  }
  return names;
}

}  // namespace mbgen
