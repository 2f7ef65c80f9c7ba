#include "compiler/model/auxiliary_states.hpp"
#include "compiler/study/initial_state.hpp"

namespace mbgen {

GenericState reference_state(const Compilation& compilation) {
  GenericState state;
  state.z.assign(static_cast<std::size_t>(compilation.topology.size()), 0.0);
  state.zd = state.z;
  state.x.assign(static_cast<std::size_t>(auxiliary_state_count(compilation.model)), 0.0);
  return state;
}

}  // namespace mbgen
