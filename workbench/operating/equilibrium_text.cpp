#include "workbench/operating/equilibrium_text.hpp"

#include <fmt/format.h>

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/engines/engine.hpp"
#include "workbench/operating/operating_point.hpp"

namespace mbgen {

Equilibrium equilibrium(const Compilation& compilation, const std::vector<double>& inputs) {
  Equilibrium found{equilibrium_state(compilation, inputs), {}, {}};
  GenericSolver solver(compilation.model, compilation.topology, compilation.analysis);
  solver.set_inputs(inputs);
  const std::vector<double> no_forces(found.state.z.size(), 0.0);
  const Status status = solver.accelerations(found.state, no_forces, found.rates);
  if (!status.ok()) throw UserError(fmt::format("at the equilibrium: {}\n", describe(compilation, status)));
  found.outputs = solver.outputs(found.state, no_forces, found.rates);
  return found;
}

nlohmann::ordered_json equilibrium_json(const Compilation& compilation, const Equilibrium& found) {
  nlohmann::ordered_json positions = nlohmann::ordered_json::object(), states = positions, outputs = positions;
  for (std::size_t i = 0; i < found.state.z.size(); ++i) {
    positions[compilation.topology.bodies[i].coordinate] = found.state.z[i];
  }
  for (std::size_t i = 0; const std::string& name : auxiliary_state_names(compilation.model))
    states[name] = found.state.x[i++];
  for (std::size_t i = 0; i < compilation.model.outputs.size(); ++i) {
    outputs[compilation.model.outputs[i].name] = found.outputs.y[i];
  }
  return {{"model", compilation.model.name},
          {"positions", positions},
          {"states", states},
          {"largest_acceleration", largest_absolute(found.rates.zdd)},
          {"outputs", outputs}};
}

std::string equilibrium_text(const Compilation& compilation, const Equilibrium& found) {
  std::string text = fmt::format("{}: static equilibrium, accelerations below {:.1e}\n\nCoordinates\n",
                                 compilation.model.name, largest_absolute(found.rates.zdd));
  for (std::size_t i = 0; i < found.state.z.size(); ++i) {
    const TreeBody& body = compilation.topology.bodies[i];
    text += fmt::format("  {:<40}{:>16.9g} {}\n", body.coordinate, found.state.z[i], unit_of(body.kind));
  }
  if (!compilation.model.states.empty()) text += "\nStates\n";
  for (std::size_t i = 0; i < compilation.model.states.size(); ++i)
    text += fmt::format("  {:<40}{:>16.9g} {}\n", compilation.model.states[i].name,
                        found.state.x[i + first_user_state(compilation.model)], compilation.model.states[i].unit);
  if (!compilation.model.outputs.empty()) text += "\nOutputs\n";
  for (std::size_t i = 0; i < compilation.model.outputs.size(); ++i) {
    const Output& output = compilation.model.outputs[i];
    text += fmt::format("  {:<40}{:>16.9g} {}\n", output.name, found.outputs.y[i], output.unit);
  }
  return text;
}

}  // namespace mbgen
