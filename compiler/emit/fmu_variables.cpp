#include "compiler/emit/fmu_variables.hpp"

#include <algorithm>
#include <map>

namespace mbgen {
namespace {

using Causality = FmuVariable::Causality;
using Start = FmuVariable::Start;

/// First value reference of every group of slots.
struct References {
  int par = 1, in = 0, y = 0, z = 0, zd = 0, zdd = 0, x = 0, xd = 0;
};

References references(const EmitContext& context) {
  References first;
  first.in = first.par + static_cast<int>(context.names.parameters.size());
  first.y = first.in + static_cast<int>(context.names.inputs.size());
  first.z = first.y + static_cast<int>(output_members(context).size());
  first.zd = first.z + context.layout.coordinates;
  first.zdd = first.zd + context.layout.coordinates;
  first.x = first.zdd + context.layout.coordinates;
  first.xd = first.x + context.layout.auxiliary_states;
  return first;
}

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

void add_given(const EmitContext& context, FmuLayout& fmu) {
  const Model& model = context.model;
  fmu.variables.push_back({"time", "s", "time", Causality::independent, Start::none});
  for (const Parameter& parameter : model.parameters) {
    if (!parameter.tunable) continue;
    fmu.variables.push_back(
        {parameter.name, parameter.unit, "tunable parameter", Causality::parameter, Start::exact, parameter.value});
  }
  for (const Input& input : model.inputs) {
    const std::string rate = input.derivative < 0 ? "" : ", goes on by " + model.inputs[input.derivative].name;
    fmu.variables.push_back(
        {input.name, input.unit, "input" + rate, Causality::input, Start::none, input.default_value});
  }
}

void add_outputs(const EmitContext& context, FmuLayout& fmu) {
  const auto given = fmu.variables;
  for (const Output& output : context.model.outputs) {
    const bool is_taken = std::any_of(given.begin(), given.end(), [&](const auto& v) { return v.name == output.name; });
    fmu.variables.push_back({is_taken ? "y." + output.name : output.name, output.unit, "output of the model",
                             Causality::output, Start::calculated});
  }
  fmu.variables.push_back({"energy.kinetic", "J", "kinetic energy", Causality::output, Start::calculated});
  fmu.variables.push_back(
      {"energy.potential", "J", "potential energy of gravity", Causality::output, Start::calculated});
  fmu.variables.push_back(
      {"power.applied", "W", "power of all applied forces but gravity", Causality::output, Start::calculated});
}

void add_motion(const EmitContext& context, const InitialState& initial, const References& first, FmuLayout& fmu) {
  const auto& bodies = context.topology.bodies;
  const auto unit = [&](std::size_t i, const char* per) { return unit_of(bodies[i].kind) + std::string(per); };
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const int c = static_cast<int>(i);
    const Start start = contains(fmu.velocities, c)  ? Start::exact
                        : contains(fmu.positions, c) ? Start::approx
                                                     : Start::calculated;
    const std::string kind = start == Start::exact    ? "independent coordinate"
                             : start == Start::approx ? "coordinate that its loop decides"
                                                      : "driven coordinate";
    fmu.variables.push_back({"z." + bodies[i].coordinate, unit(i, ""), kind, Causality::local, start, initial.z[i]});
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const int c = static_cast<int>(i);
    fmu.variables.push_back({"zd." + bodies[i].coordinate, unit(i, "/s"), "velocity of the coordinate",
                             Causality::local, contains(fmu.velocities, c) ? Start::exact : Start::calculated,
                             initial.zd[i], contains(fmu.positions, c) ? first.z + c : -1});
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const int c = static_cast<int>(i);
    fmu.variables.push_back({"zdd." + bodies[i].coordinate, unit(i, "/s^2"), "acceleration of the coordinate",
                             Causality::local, Start::calculated, 0, contains(fmu.velocities, c) ? first.zd + c : -1});
  }
  const std::vector<std::string> names = auxiliary_state_names(context.model);
  for (std::size_t i = 0; i < names.size(); ++i)
    fmu.variables.push_back({"x." + names[i], "m", "auxiliary state", Causality::local, Start::exact, initial.x[i]});
  for (std::size_t i = 0; i < names.size(); ++i)
    fmu.variables.push_back({"xd." + names[i], "m/s", "rate of the auxiliary state", Causality::local,
                             Start::calculated, 0, first.x + static_cast<int>(i)});
}

/// Knowns by the text of a slot, "zd[3]".
using Knowns = std::map<std::pair<std::string, int>, std::set<int>>;

/// Every output slot of a program with the union of the knowns of the inputs that reach it.
Knowns reached(const Program& program, const Knowns& knowns) {
  std::vector<std::vector<bool>> reach(program.nodes.size(), std::vector<bool>(program.inputs.size(), false));
  for (std::size_t n = 0; n < program.nodes.size(); ++n) {
    const Node& node = program.nodes[n];
    if (node.op == Op::input) reach[n][static_cast<std::size_t>(node.input)] = true;
    for (int k = 0; k < arity(node.op); ++k) {
      const std::vector<bool>& operand = reach[node.operands[k]];
      for (std::size_t i = 0; i < operand.size(); ++i) reach[n][i] = reach[n][i] || operand[i];
    }
  }
  Knowns result;
  for (const OutputValue& output : program.outputs) {
    std::set<int>& set = result[{output.slot.group, output.slot.index}];
    for (std::size_t i = 0; i < program.inputs.size(); ++i) {
      if (!reach[output.value][i]) continue;
      const auto known = knowns.find({program.inputs[i].group, program.inputs[i].index});
      if (known != knowns.end()) set.insert(known->second.begin(), known->second.end());
    }
  }
  return result;
}

/// Knowns of dependent and driven positions: those that the closure's Newton step looks at, until nothing is added.
void close_positions(const EmitContext& context, const Programs& programs, const FmuLayout& fmu, Knowns& knowns) {
  for (bool grows = true; grows;) {
    grows = false;
    const Knowns closed = reached(programs.closure, knowns);
    for (int i = 0; i < context.layout.coordinates; ++i) {
      const auto correction = closed.find({"dz", i});
      if (contains(fmu.velocities, i) || correction == closed.end()) continue;
      std::set<int>& set = knowns[{"z", i}];
      const std::size_t before = set.size();
      set.insert(correction->second.begin(), correction->second.end());
      grows = grows || set.size() > before;
    }
  }
  const Knowns closed = reached(programs.closure, knowns);
  for (int i = 0; i < context.layout.coordinates; ++i) {
    const auto velocity = closed.find({"zd", i});
    if (!contains(fmu.velocities, i) && velocity != closed.end()) knowns[{"zd", i}] = velocity->second;
  }
}

/// Knowns of every value reference.
std::vector<std::set<int>> dependencies(const EmitContext& context, const Programs& programs, const References& first,
                                        const FmuLayout& fmu) {
  Knowns knowns;
  knowns[{"t", 0}] = {0};
  for (int i = first.par; i < first.in; ++i) knowns[{"par", i - first.par}] = {i};
  for (int i = first.in; i < first.y; ++i) knowns[{"in", i - first.in}] = {i};
  for (int i = first.x; i < first.xd; ++i) knowns[{"x", i - first.x}] = {i};
  for (const int i : fmu.velocities) {
    knowns[{"z", i}] = {first.z + i};
    knowns[{"zd", i}] = {first.zd + i};
  }
  if (context.layout.has_closure) close_positions(context, programs, fmu, knowns);
  knowns.merge(reached(programs.accelerations, knowns));
  if (context.layout.has_closure) knowns.merge(reached(programs.multipliers, knowns));
  const Knowns results = reached(programs.outputs, knowns);

  std::vector<std::set<int>> all(fmu.variables.size());
  const auto take = [&](const Knowns& from, const char* group, int index, int reference) {
    const auto found = from.find({group, index});
    if (found != from.end()) all[static_cast<std::size_t>(reference)] = found->second;
  };
  const int outputs = static_cast<int>(context.names.outputs.size());
  for (int i = 0; i < outputs; ++i) take(results, "y", i, first.y + i);
  take(results, "energy", 0, first.y + outputs);
  take(results, "energy", 1, first.y + outputs + 1);
  take(results, "power", 0, first.y + outputs + 2);
  for (int i = 0; i < context.layout.coordinates; ++i) {
    take(knowns, "z", i, first.z + i);
    take(knowns, "zd", i, first.zd + i);
    take(knowns, "zdd", i, first.zdd + i);
  }
  for (int i = 0; i < context.layout.auxiliary_states; ++i) take(knowns, "xd", i, first.xd + i);
  return all;
}

void add_structure(const References& first, const std::vector<std::set<int>>& dependencies, FmuLayout& fmu) {
  const auto of = [&](int variable) { return dependencies[static_cast<std::size_t>(variable)]; };
  for (int i = first.y; i < first.z; ++i) fmu.outputs.push_back({i, of(i)});
  for (const int i : fmu.positions) fmu.derivatives.push_back({first.zd + i, of(first.zd + i)});
  for (const int i : fmu.velocities) fmu.derivatives.push_back({first.zdd + i, of(first.zdd + i)});
  for (int i = first.xd; i < static_cast<int>(fmu.variables.size()); ++i) fmu.derivatives.push_back({i, of(i)});
  std::set<int> initial;
  for (const FmuUnknown& unknown : fmu.outputs) initial.insert(unknown.variable);
  for (const int i : fmu.positions) initial.insert(first.z + i);
  for (const FmuUnknown& unknown : fmu.derivatives) initial.insert(unknown.variable);
  for (const int variable : initial) {
    const Start start = fmu.variables[static_cast<std::size_t>(variable)].start;
    if (start == Start::approx || start == Start::calculated) fmu.initial_unknowns.push_back({variable, of(variable)});
  }
  // Parameters are knowns at the start only.
  for (std::vector<FmuUnknown>* unknowns : {&fmu.outputs, &fmu.derivatives}) {
    for (FmuUnknown& unknown : *unknowns)
      std::erase_if(unknown.dependencies, [&](int known) { return known >= first.par && known < first.in; });
  }
}

}  // namespace

FmuLayout fmu_layout(const EmitContext& context, const Programs& programs, const InitialState& initial) {
  FmuLayout fmu;
  fmu.velocities = free_coordinates(context.topology, context.analysis);
  std::sort(fmu.velocities.begin(), fmu.velocities.end());
  for (int i = 0; i < context.layout.coordinates; ++i) {
    if (!context.analysis.driven[i]) fmu.positions.push_back(i);
  }
  const References first = references(context);
  add_given(context, fmu);
  add_outputs(context, fmu);
  add_motion(context, initial, first, fmu);
  add_structure(first, dependencies(context, programs, first, fmu), fmu);
  return fmu;
}

}  // namespace mbgen
