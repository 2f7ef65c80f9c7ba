#include "compiler/report/forces.hpp"

#include <algorithm>
#include <initializer_list>
#include <variant>

#include "compiler/model/auxiliary_states.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {
namespace {

bool depends_on_inputs(const Model& model, int expression) {
  if (expression < 0) return false;
  const std::vector<ExpressionNode>& nodes = model.expressions[static_cast<std::size_t>(expression)].nodes;
  return std::any_of(nodes.begin(), nodes.end(),
                     [](const ExpressionNode& node) { return node.kind == ExpressionNode::Kind::input; });
}

bool depends_on_inputs(const Model& model, const Law& law) {
  const Quantity* factor = std::get_if<Quantity>(&law);
  return factor && depends_on_inputs(model, factor->expression);
}

bool depends_on_inputs(const Model& model, const PointSpring& spring) {
  return (spring.stiffness && depends_on_inputs(model, *spring.stiffness)) ||
         (spring.damping && depends_on_inputs(model, *spring.damping)) ||
         (spring.free_length && depends_on_inputs(model, spring.free_length->expression)) ||
         depends_on_inputs(model, spring.preload.expression) || depends_on_inputs(model, spring.force.value_or(-1));
}

bool depends_on_inputs(const Model& model, const AirSpring& spring) {
  const auto any = [&](std::initializer_list<Quantity> quantities) {
    return std::any_of(quantities.begin(), quantities.end(),
                       [&](const Quantity& quantity) { return depends_on_inputs(model, quantity.expression); });
  };
  return any({spring.pressure, spring.ambient, spring.exponent, spring.volume0, spring.length.value_or(Quantity())}) ||
         depends_on_inputs(model, spring.area);
}

/// The model with the forces of its springs as its only outputs.
Model watched(Model model) {
  model.outputs.clear();
  for (std::size_t s = 0; s < model.springs.size(); ++s) {
    if (depends_on_inputs(model, model.springs[s])) continue;
    model.outputs.push_back(
        {model.springs[s].name + ".force", {}, "N", SpringOutput{SpringOutput::What::force, static_cast<int>(s), -1}});
  }
  for (std::size_t s = 0; s < model.air_springs.size(); ++s) {
    if (depends_on_inputs(model, model.air_springs[s])) continue;
    model.outputs.push_back({model.air_springs[s].name + ".force",
                             {},
                             "N",
                             SpringOutput{SpringOutput::What::force, -1, static_cast<int>(s)}});
  }
  return model;
}

}  // namespace

std::vector<Column> element_forces(const ReportSource& source, const std::vector<std::size_t>& rows) {
  const std::vector<Column>& table = source.results.columns;
  const Model model = watched(source.model);
  std::vector<Column> forces;
  for (const Output& output : model.outputs) forces.push_back({{output.name, output.unit}, {}});
  std::vector<int> positions, velocities;
  for (const TreeBody& body : source.topology.bodies) {
    positions.push_back(find_column(source.results, "z." + body.coordinate));
    velocities.push_back(find_column(source.results, "zd." + body.coordinate));
    if (velocities.back() < 0) return {};
  }
  if (forces.empty()) return forces;
  const GenericSolver solver(model, source.topology, source.analysis);
  const std::size_t count = positions.size();
  const auto auxiliary_states = static_cast<std::size_t>(auxiliary_state_count(model));
  GenericState state{std::vector<double>(count), std::vector<double>(count), std::vector<double>(auxiliary_states), 0};
  std::vector<int> bristles;  // columns of the auxiliary states, of which forces along springs may be
  for (const std::string& name : auxiliary_state_names(model))
    bristles.push_back(find_column(source.results, "x." + name));
  // No force of a spring depends on accelerations or joint forces.
  const GenericDerivative none{std::vector<double>(count), std::vector<double>(auxiliary_states)};
  const std::vector<double> tau(count);
  for (const std::size_t row : rows) {
    state.t = table.front().values[row];
    for (std::size_t i = 0; i < count; ++i) {
      state.z[i] = table[static_cast<std::size_t>(positions[i])].values[row];
      state.zd[i] = table[static_cast<std::size_t>(velocities[i])].values[row];
    }
    for (std::size_t i = 0; i < bristles.size(); ++i) {
      if (bristles[i] >= 0) state.x[i] = table[static_cast<std::size_t>(bristles[i])].values[row];
    }
    const GenericOutputs outputs = solver.outputs(state, tau, none);
    for (std::size_t f = 0; f < forces.size(); ++f) forces[f].values.push_back(outputs.y[f]);
  }
  return forces;
}

}  // namespace mbgen
