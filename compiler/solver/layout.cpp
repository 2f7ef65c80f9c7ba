#include "compiler/solver/layout.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/holds.hpp"
#include "compiler/model/tyres.hpp"

namespace mbgen {

namespace {

/// Whether maps between motors and joints are functions: other pivots of the loops can be chosen at run time, and no
/// motion stands in for a direction of the actuators.
bool maps_actuators(const SolverLayout& layout, bool has_blocks) {
  return layout.actuators > 0 && layout.actuated_directions == layout.free_directions && layout.free_directions > 0 &&
         (has_blocks ? layout.chooses_again : layout.drives == 0);
}

}  // namespace

SolverLayout solver_layout(const Model& model, const Topology& topology, const Analysis& analysis) {
  SolverLayout layout;
  layout.coordinates = topology.size();
  layout.auxiliary_states = auxiliary_state_count(model);
  layout.own_states = static_cast<int>(model.states.size());
  layout.held = held_state_count(model);
  layout.sampled = static_cast<int>(model.sampled.size());
  layout.grounds = static_cast<int>(tyres_on_host(model).size());
  layout.holds = static_cast<int>(hold_names(model).size());
  layout.balls = static_cast<int>(topology.balls.size());
  layout.drives = static_cast<int>(model.motions.size());
  layout.inputs = static_cast<int>(model.inputs.size());
  layout.parameters = static_cast<int>(std::ranges::count_if(model.parameters, &Parameter::tunable));
  layout.outputs = static_cast<int>(model.outputs.size());
  layout.free_directions = static_cast<int>(free_coordinates(topology, analysis).size());
  if (has_inverse_dynamics(model, topology, analysis)) {
    layout.actuators = static_cast<int>(model.actuators.size());
    layout.actuated_directions = static_cast<int>(actuated_coordinates(topology, analysis).size());
  }
  layout.has_closure = !topology.loops.empty() || !model.motions.empty();
  layout.chooses_again = chooses_again(topology);
  const bool has_blocks = !topology.blocks.empty();
  layout.maps_actuators = maps_actuators(layout, has_blocks);
  layout.pivots_actuators = layout.maps_actuators && (has_blocks || layout.actuators > layout.actuated_directions);
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    BlockPlaces block;
    block.equations = topology.blocks[b].equations;
    block.coordinates = static_cast<int>(topology.blocks[b].joints.size());
    block.rank = analysis.blocks[b].rank;
    block.free = block.coordinates - block.rank - static_cast<int>(analysis.blocks[b].driven.size());
    block.first_equation = layout.equations;
    block.first_coordinate = layout.block_coordinates;
    block.first_jacobian = layout.jacobian_entries;
    block.first_projection = layout.projection_entries;
    layout.equations += block.equations;
    layout.block_coordinates += block.coordinates;
    layout.jacobian_entries += block.equations * block.coordinates;
    layout.projection_entries += block.coordinates * block.free;
    layout.blocks.push_back(block);
  }
  return layout;
}

int size_of(const SolverLayout& layout, Array array) {
  using enum Array;
  const std::pair<std::vector<Array>, int> sizes[] = {
      {{z, zd, zdd, dz, driven_acceleration, tau, required}, layout.coordinates},
      {{x, xd}, layout.auxiliary_states},
      {{due}, layout.sampled},
      {{held}, layout.held},
      {{charts}, layout.balls},
      {{Phi, c, rate, lambda}, layout.equations},
      {{drive}, layout.drives},
      {{residual}, layout.equations + layout.drives},
      {{missing, zdd_star}, layout.block_coordinates},
      {{Jz}, layout.jacobian_entries},
      {{Rz}, layout.projection_entries},
      {{pivot}, static_cast<int>(layout.blocks.size())},
      {{inertia}, layout.free_directions},
      {{actuation}, layout.actuated_directions},
      {{force, position, drift}, layout.actuators},
      {{direction}, layout.actuators * layout.coordinates},
      {{state_pivot}, layout.own_states},
      {{in}, layout.inputs},
      {{par}, layout.parameters},
      {{y}, layout.outputs},
      {{place}, 2 * layout.grounds},
      {{hold}, layout.holds},
      {{energy}, 2},
      {{t, power, step}, 1},
  };
  for (const auto& [arrays, size] : sizes)
    if (std::ranges::count(arrays, array) > 0) return size;
  throw std::logic_error(std::string("no size of ") + name_of(array));
}

std::optional<ArrayShare> share_of(const BlockPlaces& block, Array array) {
  switch (array) {
    case Array::Phi:
    case Array::c:
    case Array::rate:
      return ArrayShare{block.first_equation, block.equations};
    case Array::missing:
    case Array::zdd_star:
      return ArrayShare{block.first_coordinate, block.coordinates};
    case Array::Jz:
      return ArrayShare{block.first_jacobian, block.equations * block.coordinates};
    case Array::Rz:
      return ArrayShare{block.first_projection, block.coordinates * block.free};
    default:
      return {};
  }
}

std::vector<DirectionGroup> direction_of(const SolverLayout& layout, std::initializer_list<Array> arrays) {
  std::vector<DirectionGroup> groups;
  for (const Array array : arrays) groups.push_back({array, size_of(layout, array)});
  return groups;
}

}  // namespace mbgen
