#include "runtime/judges/mechanism.hpp"

namespace mbgen {

using namespace cartesian;

CartesianMechanism::CartesianMechanism(const Model& m, const Topology& t) : model(m), topology(t) {
  for (const Joint& joint : model.joints) table.emplace_back(joint.freedoms.size(), -1);
  for (int i = 0; i < topology.size(); ++i) table[topology.bodies[i].joint][topology.bodies[i].component] = i;
  for (const Input& input : model.inputs) inputs.push_back(input.default_value);
  for (const Parameter& parameter : model.parameters) parameters.push_back(parameter.value);
  refresh();
  first = first_rows(parts, model, topology);
}

void CartesianMechanism::refresh() { parts = make_parts(model, topology, Values{model, table, parameters, inputs}); }

}  // namespace mbgen
