#include "compiler/solver/layout.hpp"

#include <algorithm>
#include <stdexcept>

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/host_ground.hpp"

namespace mbgen {

SolverLayout solver_layout(const Model& model, const Topology& topology, const Analysis& analysis) {
  SolverLayout layout;
  layout.coordinates = topology.size();
  layout.auxiliary_states = auxiliary_state_count(model);
  layout.own_states = static_cast<int>(model.states.size());
  layout.held = held_state_count(model);
  layout.sampled = static_cast<int>(model.sampled.size());
  layout.grounds = static_cast<int>(tyres_on_host(model).size());
  layout.balls = static_cast<int>(topology.balls.size());
  layout.drives = static_cast<int>(model.motions.size());
  layout.inputs = static_cast<int>(model.inputs.size());
  layout.parameters = static_cast<int>(std::ranges::count_if(model.parameters, &Parameter::tunable));
  layout.outputs = static_cast<int>(model.outputs.size());
  layout.free_directions = static_cast<int>(free_coordinates(topology, analysis).size());
  layout.has_closure = !topology.loops.empty() || !model.motions.empty();
  layout.chooses_again = chooses_again(topology);
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
  switch (array) {
    case z:
    case zd:
    case zdd:
    case dz:
    case driven_acceleration:
    case tau:
      return layout.coordinates;
    case x:
    case xd:
      return layout.auxiliary_states;
    case due:
      return layout.sampled;
    case held:
      return layout.held;
    case charts:
      return layout.balls;
    case Phi:
    case c:
    case rate:
    case lambda:
      return layout.equations;
    case drive:
      return layout.drives;
    case residual:
      return layout.equations + layout.drives;
    case missing:
    case zdd_star:
      return layout.block_coordinates;
    case Jz:
      return layout.jacobian_entries;
    case Rz:
      return layout.projection_entries;
    case pivot:
      return static_cast<int>(layout.blocks.size());
    case inertia:
      return layout.free_directions;
    case state_pivot:
      return layout.own_states;
    case in:
      return layout.inputs;
    case par:
      return layout.parameters;
    case y:
      return layout.outputs;
    case place:
      return 2 * layout.grounds;
    case energy:
      return 2;
    case t:
    case power:
    case step:
      return 1;
    case derived:
    case law_argument:
    case law_result:
    case tangent:
    case seed:
      break;
  }
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
