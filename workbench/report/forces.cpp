#include "workbench/report/forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <variant>

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/mentions.hpp"
#include "runtime/generic/generic.hpp"
#include "workbench/report/table_states.hpp"

namespace mbgen {
namespace {

bool depends_on_inputs(const Model& model, int expression) {
  return mentions(model, expression, {ExpressionNode::Kind::input});
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

bool depends_on_inputs(const Model& model, const Bushing& bushing) {
  const auto in_matrix = [&](const std::optional<BushingMatrix>& matrix) {
    return matrix && std::any_of(matrix->begin(), matrix->end(),
                                 [&](const Quantity& entry) { return depends_on_inputs(model, entry.expression); });
  };
  const auto in_law = [&](const std::optional<Law>& law) { return law && depends_on_inputs(model, *law); };
  const auto in_freedom = [&](const std::optional<BushingFreedom>& own) {
    return own &&
           (in_law(own->stiffness) || in_law(own->damping) || depends_on_inputs(model, own->preload.expression) ||
            depends_on_inputs(model, own->force.value_or(-1)) ||
            depends_on_inputs(model, own->maxwell_stiffness.value_or(Quantity()).expression));
  };
  return in_matrix(bushing.stiffness) || in_matrix(bushing.damping) ||
         std::any_of(bushing.freedoms.begin(), bushing.freedoms.end(), in_freedom);
}

bool depends_on_inputs(const Model& model, const BumpStop& stop) {
  return depends_on_inputs(model, stop.clearance.expression) || depends_on_inputs(model, stop.damping.expression) ||
         (stop.stiffness && depends_on_inputs(model, *stop.stiffness)) ||
         depends_on_inputs(model, stop.force.value_or(-1));
}

/// The model with the forces of its springs, bushings and bump stops as its only outputs.
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
  for (std::size_t b = 0; b < model.bushings.size(); ++b) {
    if (depends_on_inputs(model, model.bushings[b])) continue;
    for (int axis = 0; axis < 3; ++axis)
      model.outputs.push_back({fmt::format("{}.force_{}", model.bushings[b].name, "xyz"[axis]),
                               {},
                               "N",
                               BushingOutput{BushingOutput::What::force, static_cast<int>(b), axis}});
  }
  for (std::size_t s = 0; s < model.bump_stops.size(); ++s) {
    const BumpStop& stop = model.bump_stops[s];
    if (depends_on_inputs(model, stop)) continue;
    const bool turns = stop.is_on_joint() && freedom_of(model, stop.joint).kind == FreedomKind::revolute;
    model.outputs.push_back({stop.name + ".force",
                             {},
                             turns ? "N m" : "N",
                             BumpStopOutput{BumpStopOutput::What::force, static_cast<int>(s)}});
  }
  return model;
}

}  // namespace

std::vector<Column> element_forces(const ReportSource& source, const std::vector<std::size_t>& rows) {
  const Model model = watched(source.model);
  std::vector<Column> forces;
  for (const Output& output : model.outputs) forces.push_back({{output.name, output.unit}, {}});
  for (const TreeBody& body : source.topology.bodies)
    if (find_column(source.results, "zd." + body.coordinate) < 0) return {};
  if (forces.empty()) return forces;
  const GenericSolver solver(model, source.topology, source.analysis);
  const std::size_t count = source.topology.bodies.size();
  // No force of a spring, bushing or stop depends on accelerations or joint forces.
  const GenericDerivative none{std::vector<double>(count), std::vector<double>(auxiliary_state_names(model).size())};
  const std::vector<double> tau(count);
  // Without columns of them Maxwell branches are relaxed.
  for (const GenericState& state : table_states(source, rows)) {
    const GenericOutputs outputs = solver.outputs(state, tau, none);
    for (std::size_t f = 0; f < forces.size(); ++f) forces[f].values.push_back(outputs.y[f]);
  }
  return forces;
}

}  // namespace mbgen
