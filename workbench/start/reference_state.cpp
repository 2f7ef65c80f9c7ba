#include "compiler/model/auxiliary_states.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen {

GenericState reference_state(const Compilation& compilation) {
  GenericState state;
  state.z.assign(static_cast<std::size_t>(compilation.topology.size()), 0.0);
  state.zd = state.z;
  state.x = initial_auxiliary_states(compilation.model);
  return state;
}

}  // namespace mbgen
