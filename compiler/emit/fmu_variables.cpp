#include "compiler/emit/fmu_variables.hpp"

#include <algorithm>
#include <map>

#include "compiler/emit/input_text.hpp"

namespace mbgen {
namespace {

using Causality = FmuVariable::Causality;
using Start = FmuVariable::Start;

/// First value reference of every group of slots.
struct References {
  int par = 1, in = 0, y = 0, z = 0, zd = 0, zdd = 0, x = 0, xd = 0, q = 0, qd = 0, qdd = 0, start = 0;
};

References references(const EmitContext& context, int chosen) {
  References first;
  first.in = first.par + static_cast<int>(context.names.parameters.size());
  first.y = first.in + static_cast<int>(context.names.inputs.size());
  first.z = first.y + static_cast<int>(output_members(context).size());
  first.zd = first.z + context.layout.coordinates;
  first.zdd = first.zd + context.layout.coordinates;
  first.x = first.zdd + context.layout.coordinates;
  first.xd = first.x + context.layout.auxiliary_states;
  first.q = first.xd + context.layout.auxiliary_states;
  first.qd = first.q + chosen;
  first.qdd = first.qd + chosen;
  first.start = first.qdd + chosen;
  return first;
}

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

constexpr const char* kTime = "time";

/// What the model says of it, or else what it is.
std::string described(const std::string& description, const std::string& otherwise) {
  return description.empty() ? otherwise : description;
}

FmuVariable given_variable(const std::string& name, const std::string& unit, const std::string& what,
                           Causality causality, Start start, double value, const Presentation& shown) {
  return {name, unit, described(shown.description, what), causality, start, value, -1, shown};
}

void add_given(const EmitContext& context, FmuLayout& fmu) {
  const Model& model = context.model;
  fmu.variables.push_back({kTime, "s", "time", Causality::independent, Start::none});
  for (const Parameter& parameter : model.parameters) {
    if (!parameter.tunable) continue;
    fmu.variables.push_back(given_variable(fmu_parameter_name(parameter.name), parameter.unit, "tunable parameter",
                                           Causality::parameter, Start::exact, parameter.value, parameter.shown));
  }
  const int first_input = static_cast<int>(fmu.variables.size());
  for (const Input& input : model.inputs) {
    const std::string rate = input.derivative < 0 ? "" : ", goes on by " + model.inputs[input.derivative].name;
    fmu.variables.push_back(given_variable(fmu_input_name(input.name), input.unit, "input" + rate, Causality::input,
                                           Start::none, input.default_value, input.shown));
  }
  // Importers are told which inputs belong together; a derivative that inputs share is that of none.
  for (const std::vector<int>& row : input_rows(model.inputs)) {
    for (std::size_t k = 1; k < row.size(); ++k) {
      fmu.variables[static_cast<std::size_t>(first_input + row[k])].derivative_of = first_input + row[k - 1];
    }
  }
}

void add_outputs(const EmitContext& context, FmuLayout& fmu) {
  for (const Output& output : context.model.outputs) {
    fmu.variables.push_back(given_variable(fmu_output_name(context.model, output.name), output.unit,
                                           "output of the model", Causality::output, Start::calculated, 0,
                                           output.shown));
  }
  fmu.variables.push_back({"energy.kinetic", "J", "kinetic energy", Causality::output, Start::calculated});
  fmu.variables.push_back(
      {"energy.potential", "J", "potential energy of gravity", Causality::output, Start::calculated});
  fmu.variables.push_back(
      {"power.applied", "W", "power of all applied forces but gravity", Causality::output, Start::calculated});
}

/// Angles are shown in degrees.
Presentation shown_as(FreedomKind kind, const char* per) {
  Presentation shown;
  if (kind == FreedomKind::revolute) shown.display_unit = std::string("deg") + per;
  return shown;
}

/// Value references of the parameters that a velocity follows from at the start.
std::set<int> acting_at_start(const InitialState& initial, const References& first, int coordinate) {
  std::set<int> result;
  for (std::size_t i = 0; i < initial.parameters.size(); ++i) {
    if (initial.parameters[i].zd[static_cast<std::size_t>(coordinate)] != 0)
      result.insert(first.start + static_cast<int>(i));
  }
  return result;
}

void add_start_parameters(const EmitContext& context, const InitialState& initial, FmuLayout& fmu) {
  for (const StartParameter& one : initial.parameters) {
    const Parameter& parameter = context.model.parameters[static_cast<std::size_t>(one.parameter)];
    fmu.variables.push_back(given_variable(fmu_parameter_name(parameter.name), parameter.unit, "parameter of the start",
                                           Causality::parameter, Start::exact, parameter.value, parameter.shown));
    fmu.variables.back().is_fixed = true;
  }
}

void add_motion(const EmitContext& context, const InitialState& initial, const References& first, FmuLayout& fmu) {
  const auto& bodies = context.topology.bodies;
  const auto unit = [&](std::size_t i, const char* per) { return unit_of(bodies[i].kind) + std::string(per); };
  const auto is_given = [&](int c) {
    return contains(fmu.independent, c) && acting_at_start(initial, first, c).empty();
  };
  const auto of_joint = [&](std::size_t i) {
    const int joint = bodies[i].joint;
    const std::string& text = joint < 0 ? "" : context.model.joints[static_cast<std::size_t>(joint)].description;
    return text.empty() ? "" : ": " + text;
  };
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const int c = static_cast<int>(i);
    const Start start = contains(fmu.independent, c) ? Start::exact
                        : contains(fmu.undriven, c)  ? Start::approx
                                                     : Start::calculated;
    const std::string kind = start == Start::exact    ? "independent coordinate"
                             : start == Start::approx ? "coordinate that its loop decides"
                                                      : "driven coordinate";
    fmu.variables.push_back({"z." + bodies[i].coordinate, unit(i, ""), kind + of_joint(i), Causality::local, start,
                             initial.z[i], -1, shown_as(bodies[i].kind, "")});
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const int c = static_cast<int>(i);
    fmu.variables.push_back({"zd." + bodies[i].coordinate, unit(i, "/s"), "velocity of the coordinate" + of_joint(i),
                             Causality::local, is_given(c) ? Start::exact : Start::calculated, initial.zd[i],
                             first.z + c, shown_as(bodies[i].kind, "/s")});
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const int c = static_cast<int>(i);
    fmu.variables.push_back({"zdd." + bodies[i].coordinate, unit(i, "/s^2"),
                             "acceleration of the coordinate" + of_joint(i), Causality::local, Start::calculated, 0,
                             first.zd + c, shown_as(bodies[i].kind, "/s^2")});
  }
  const std::vector<std::string> names = auxiliary_state_names(context.model);
  for (std::size_t i = 0; i < names.size(); ++i)
    fmu.variables.push_back({"x." + names[i], "m", "auxiliary state", Causality::local, Start::exact, initial.x[i]});
  for (std::size_t i = 0; i < names.size(); ++i)
    fmu.variables.push_back({"xd." + names[i], "m/s", "rate of the auxiliary state", Causality::local,
                             Start::calculated, 0, first.x + static_cast<int>(i)});
}

/// The states of loop blocks, each named after its coordinate at the start.
void add_chosen(const EmitContext& context, const References& first, FmuLayout& fmu) {
  struct Kind {
    const char *prefix, *per, *description;
    int first, derivative_of;
  };
  const Kind kinds[] = {{"q.", "", "state of a loop", first.q, -1},
                        {"qd.", "/s", "velocity of the state of a loop", first.qd, first.q},
                        {"qdd.", "/s^2", "acceleration of the state of a loop", first.qdd, first.qd}};
  for (const Kind& kind : kinds) {
    for (std::size_t i = 0; i < fmu.chosen.size(); ++i) {
      const TreeBody& body = context.topology.bodies[fmu.independent[fmu.chosen[i]]];
      FmuVariable variable{kind.prefix + body.coordinate, unit_of(body.kind) + std::string(kind.per),
                           std::string(kind.description) + ": of this coordinate, until an event chooses another one",
                           Causality::local, Start::calculated};
      if (kind.derivative_of >= 0) variable.derivative_of = kind.derivative_of + static_cast<int>(i);
      variable.reinit = kind.first != first.qdd;
      fmu.variables.push_back(std::move(variable));
    }
  }
}

using Knowns = std::map<Slot, std::set<int>>;

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
    std::set<int>& set = result[output.slot];
    for (std::size_t i = 0; i < program.inputs.size(); ++i) {
      if (!reach[output.value][i]) continue;
      const auto known = knowns.find(program.inputs[i]);
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
      const auto correction = closed.find({Array::dz, i});
      if (contains(fmu.independent, i) || correction == closed.end()) continue;
      std::set<int>& set = knowns[{Array::z, i}];
      const std::size_t before = set.size();
      set.insert(correction->second.begin(), correction->second.end());
      grows = grows || set.size() > before;
    }
  }
  const Knowns closed = reached(programs.closure, knowns);
  for (int i = 0; i < context.layout.coordinates; ++i) {
    const auto velocity = closed.find({Array::zd, i});
    if (!contains(fmu.independent, i) && velocity != closed.end()) knowns[{Array::zd, i}] = velocity->second;
  }
}

/// With other independent coordinates of a loop block, each of its coordinates may depend on all that one of them does
/// now: on the block's whole state, and on all that its loops look at.
void share_in_blocks(const FmuLayout& fmu, SlotGroup group, Knowns& knowns) {
  std::map<int, std::set<int>> of_block;
  const int count = static_cast<int>(fmu.block_of.size());
  for (int i = 0; i < count; ++i) {
    const auto found = knowns.find({group, i});
    if (fmu.block_of[i] >= 0 && found != knowns.end())
      of_block[fmu.block_of[i]].insert(found->second.begin(), found->second.end());
  }
  for (int i = 0; i < count; ++i) {
    if (fmu.block_of[i] >= 0) knowns[{group, i}] = of_block[fmu.block_of[i]];
  }
}

/// Knowns of every value reference.
std::vector<std::set<int>> dependencies(const EmitContext& context, const Programs& programs, const References& first,
                                        const FmuLayout& fmu) {
  Knowns knowns;
  knowns[{Array::t, 0}] = {0};
  for (int i = first.par; i < first.in; ++i) knowns[{Array::par, i - first.par}] = {i};
  for (int i = first.in; i < first.y; ++i) knowns[{Array::in, i - first.in}] = {i};
  for (int i = first.x; i < first.xd; ++i) knowns[{Array::x, i - first.x}] = {i};
  for (const int i : fmu.independent) {
    knowns[{Array::z, i}] = {first.z + i};
    knowns[{Array::zd, i}] = {first.zd + i};
  }
  for (std::size_t k = 0; k < fmu.chosen.size(); ++k) {
    knowns[{Array::z, fmu.independent[fmu.chosen[k]]}] = {first.q + static_cast<int>(k)};
    knowns[{Array::zd, fmu.independent[fmu.chosen[k]]}] = {first.qd + static_cast<int>(k)};
  }
  if (context.layout.has_closure) close_positions(context, programs, fmu, knowns);
  share_in_blocks(fmu, Array::z, knowns);
  share_in_blocks(fmu, Array::zd, knowns);
  knowns.merge(reached(programs.accelerations, knowns));
  share_in_blocks(fmu, Array::zdd, knowns);
  if (context.layout.has_closure) knowns.merge(reached(programs.multipliers, knowns));
  const Knowns results = reached(programs.outputs, knowns);

  std::vector<std::set<int>> all(fmu.variables.size());
  const auto take = [&](const Knowns& from, Array group, int index, int reference) {
    const auto found = from.find({group, index});
    if (found != from.end()) all[static_cast<std::size_t>(reference)] = found->second;
  };
  const int outputs = static_cast<int>(context.names.outputs.size());
  for (int i = 0; i < outputs; ++i) take(results, Array::y, i, first.y + i);
  take(results, Array::energy, 0, first.y + outputs);
  take(results, Array::energy, 1, first.y + outputs + 1);
  take(results, Array::power, 0, first.y + outputs + 2);
  for (int i = 0; i < context.layout.coordinates; ++i) {
    take(knowns, Array::z, i, first.z + i);
    take(knowns, Array::zd, i, first.zd + i);
    take(knowns, Array::zdd, i, first.zdd + i);
  }
  for (int i = 0; i < context.layout.auxiliary_states; ++i) take(knowns, Array::xd, i, first.xd + i);
  for (std::size_t k = 0; k < fmu.chosen.size(); ++k) {
    const int place = static_cast<int>(k), coordinate = fmu.independent[fmu.chosen[k]];
    take(knowns, Array::z, coordinate, first.q + place);
    take(knowns, Array::zd, coordinate, first.qd + place);
    take(knowns, Array::zdd, coordinate, first.qdd + place);
  }
  return all;
}

/// Velocities that follow from parameters at the start are no knowns there: those parameters are.
void take_start(const InitialState& initial, const References& first, FmuUnknown& unknown) {
  for (int c = 0; c < first.zdd - first.zd; ++c) {
    const std::set<int> acting = acting_at_start(initial, first, c);
    if (acting.empty() || unknown.dependencies.erase(first.zd + c) == 0) continue;
    unknown.dependencies.insert(acting.begin(), acting.end());
  }
}

/// What a state depends on at the initialisation: the start values of the coordinate that it is of then.
std::set<int> at_start(const References& first, const FmuLayout& fmu, const std::set<int>& dependencies) {
  std::set<int> result;
  for (const int known : dependencies) {
    const bool is_q = known >= first.q && known < first.qd, is_qd = known >= first.qd && known < first.qdd;
    const int place = known - (is_q ? first.q : first.qd);
    result.insert(is_q || is_qd ? (is_q ? first.z : first.zd) + fmu.independent[fmu.chosen[place]] : known);
  }
  return result;
}

void add_structure(const References& first, const InitialState& initial_state,
                   const std::vector<std::set<int>>& dependencies, FmiVersion version, FmuLayout& fmu) {
  const auto add = [&](int variable, std::vector<FmuUnknown>& unknowns) {
    FmuUnknown unknown{variable, dependencies[static_cast<std::size_t>(variable)]};
    if (version == FmiVersion::two)
      std::erase_if(unknown.dependencies, [&](int known) { return known >= first.par && known < first.in; });
    unknowns.push_back(std::move(unknown));
  };
  std::vector<int> rates, accelerations, initial;
  for (std::size_t i = 0, k = 0; i < fmu.independent.size(); ++i) {
    const bool is_chosen = k < fmu.chosen.size() && fmu.chosen[k] == static_cast<int>(i);
    rates.push_back(is_chosen ? first.qd + static_cast<int>(k) : first.zd + fmu.independent[i]);
    accelerations.push_back(is_chosen ? first.qdd + static_cast<int>(k) : first.zdd + fmu.independent[i]);
    if (is_chosen) initial.push_back(first.q + static_cast<int>(k++));
  }
  for (int i = first.y; i < first.z; ++i) add(i, fmu.outputs);
  for (const int i : rates) add(i, fmu.derivatives);
  for (const int i : accelerations) add(i, fmu.derivatives);
  for (int i = first.xd; i < first.q; ++i) add(i, fmu.derivatives);
  for (const std::vector<FmuUnknown>* unknowns : {&fmu.outputs, &fmu.derivatives}) {
    for (const FmuUnknown& unknown : *unknowns) initial.push_back(unknown.variable);
  }
  std::sort(initial.begin(), initial.end());
  for (const int variable : initial) {
    if (fmu.variables[static_cast<std::size_t>(variable)].start != Start::calculated) continue;
    const std::set<int>& known = dependencies[static_cast<std::size_t>(variable)];
    FmuUnknown unknown{variable, at_start(first, fmu, known)};
    take_start(initial_state, first, unknown);
    fmu.initial_unknowns.push_back(std::move(unknown));
  }
}

/// Coordinates whose block may take others as independent ones, and where they stand among the independent ones.
void find_chosen(const EmitContext& context, FmuLayout& fmu) {
  for (int i = 0; i < context.layout.coordinates; ++i) {
    const int block = context.topology.groups[context.topology.group_of[i]].block;
    fmu.block_of.push_back(context.layout.chooses_again && !context.analysis.driven[i] ? block : -1);
    if (!context.analysis.driven[i]) fmu.undriven.push_back(i);
  }
  for (std::size_t i = 0; i < fmu.independent.size(); ++i) {
    if (fmu.block_of[fmu.independent[i]] >= 0) fmu.chosen.push_back(static_cast<int>(i));
  }
}

}  // namespace

std::string fmu_parameter_name(const std::string& name) { return name == kTime ? "par." + name : name; }
std::string fmu_input_name(const std::string& name) { return name == kTime ? "in." + name : name; }

std::string fmu_output_name(const Model& model, const std::string& name) {
  const auto has_name = [&](const auto& one) { return one.name == name; };
  const bool is_parameter = std::any_of(model.parameters.begin(), model.parameters.end(), [&](const Parameter& one) {
    return (one.tunable || one.at_start) && one.name == name;
  });
  const bool is_taken =
      name == kTime || is_parameter || std::any_of(model.inputs.begin(), model.inputs.end(), has_name);
  return is_taken ? "y." + name : name;
}

FmuLayout fmu_layout(const EmitContext& context, const Programs& programs, const InitialState& initial,
                     FmiVersion version) {
  FmuLayout fmu;
  fmu.independent = free_coordinates(context.topology, context.analysis);
  std::sort(fmu.independent.begin(), fmu.independent.end());
  find_chosen(context, fmu);
  const References first = references(context, static_cast<int>(fmu.chosen.size()));
  add_given(context, fmu);
  add_outputs(context, fmu);
  add_motion(context, initial, first, fmu);
  add_chosen(context, first, fmu);
  add_start_parameters(context, initial, fmu);
  add_structure(first, initial, dependencies(context, programs, first, fmu), version, fmu);
  return fmu;
}

}  // namespace mbgen
