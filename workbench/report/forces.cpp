#include "workbench/report/forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/element_access.hpp"
#include "runtime/generic/generic.hpp"
#include "workbench/report/table_states.hpp"

namespace mbgen {
namespace {

template <class Element>
bool depends_on_inputs(const Model& model, const Element& element) {
  bool depends = false;
  each_expression(element, [&](int expression) {
    depends = depends || mentions(model, expression, {ExpressionNode::Kind::input});
  });
  return depends;
}

/// The model with the forces of its elastic elements as its only outputs.
Model watched(Model model) {
  model.outputs.clear();
  each_kind([&]<class Kind>(KindOf<Kind> kind) {
    constexpr int force = quantity_index(KindOf<Kind>{}, "force");
    if constexpr (kind.is_elastic && force >= 0) {
      constexpr int components = kind.quantities[force].components;
      const std::vector<Kind>& elements = kind.list(model);
      for (std::size_t i = 0; i < elements.size(); ++i) {
        if (depends_on_inputs(model, elements[i])) continue;
        for (int axis = 0; axis < components; ++axis) {
          const ElementOutput output = output_of<Kind>("force", i, axis);
          const std::string component = components > 1 ? fmt::format("_{}", "xyz"[axis]) : "";
          model.outputs.push_back({elements[i].name + ".force" + component, {}, unit_of(model, output), output});
        }
      }
    }
  });
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
  // No force of an elastic element depends on accelerations or joint forces.
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
