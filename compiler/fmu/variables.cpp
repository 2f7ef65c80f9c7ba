#include "compiler/fmu/variables.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/inputs.hpp"

namespace mbgen {
namespace {

using Causality = FmuVariable::Causality;
using Start = FmuVariable::Start;

constexpr const char* kTime = "time";

bool contains(const std::vector<int>& list, int value) { return std::ranges::find(list, value) != list.end(); }

/// Adds a parameter, an input or an output of the model. what: its description, where the model gives none.
template <class Given>
void add_given(Slot slot, const Given& given, const std::string& name, const std::string& what, Causality causality,
               Start start, double value, FmuLayout& fmu) {
  const std::string& description = given.shown.description;
  fmu.variables.push_back(
      {slot, name, given.unit, description.empty() ? what : description, causality, start, value, -1, given.shown});
}

void add_parameters_and_inputs(const EmitContext& context, FmuLayout& fmu) {
  const Model& model = context.model;
  fmu.variables.push_back({{Array::t, 0}, kTime, "s", "time", Causality::independent, Start::none});
  for (int i = 0; const Parameter& parameter : tunable_parameters(model))
    add_given({Array::par, i++}, parameter, fmu_parameter_name(parameter.name), "tunable parameter",
              Causality::parameter, Start::exact, parameter.value, fmu);
  const int first_input = static_cast<int>(fmu.variables.size());
  for (int i = 0; const Input& input : model.inputs) {
    const std::string rate = input.derivative < 0 ? "" : ", goes on by " + model.inputs[input.derivative].name;
    add_given({Array::in, i++}, input, fmu_input_name(input.name), "input" + rate, Causality::input, Start::none,
              input.default_value, fmu);
  }
  // The description connects an input with its derivative; a derivative that several inputs share belongs to none.
  for (const std::vector<int>& row : input_rows(model.inputs)) {
    for (std::size_t k = 1; k < row.size(); ++k) {
      fmu.variables[static_cast<std::size_t>(first_input + row[k])].derivative_of = first_input + row[k - 1];
    }
  }
}

void add_outputs(const EmitContext& context, FmuLayout& fmu) {
  for (int i = 0; const Output& output : context.model.outputs)
    add_given({Array::y, i++}, output, fmu_output_name(context.model, output.name), "output of the model",
              Causality::output, Start::calculated, 0, fmu);
  const auto add = [&](Slot slot, const char* name, const char* unit, const char* description) {
    fmu.variables.push_back({slot, name, unit, description, Causality::output, Start::calculated});
  };
  add({Array::energy, 0}, "energy.kinetic", "J", "kinetic energy");
  add({Array::energy, 1}, "energy.potential", "J", "potential energy of gravity");
  add({Array::power, 0}, "power.applied", "W", "power of all applied forces but gravity");
}

/// Whether a velocity follows from this parameter at the start.
bool acts_on(const StartParameter& parameter, int coordinate) {
  return parameter.zd[static_cast<std::size_t>(coordinate)] != 0;
}

void add_start_parameters(const EmitContext& context, const InitialState& initial, FmuLayout& fmu) {
  for (const StartParameter& one : initial.parameters) {
    const Parameter& parameter = context.model.parameters[static_cast<std::size_t>(one.parameter)];
    add_given({Array::par, -1}, parameter, fmu_parameter_name(parameter.name), "parameter of the start",
              Causality::parameter, Start::exact, parameter.value, fmu);
    fmu.variables.back().is_fixed = true;
  }
}

/// Coordinates and their derivatives, and the same of the states of loop blocks.
struct MotionGroup {
  Array array;
  const char *per, *prefix, *description, *chosen_prefix, *chosen_description, *ball_description;
};

constexpr MotionGroup kMotionGroups[] = {
    {Array::z, "", "z.", "", "q.", "state of a loop", "angle of a joint"},
    {Array::zd, "/s", "zd.", "velocity of the coordinate", "qd.", "velocity of the state of a loop",
     "rate of an angle of a joint"},
    {Array::zdd, "/s^2", "zdd.", "acceleration of the coordinate", "qdd.", "acceleration of the state of a loop",
     "acceleration of an angle of a joint"}};

/// One number of a motion, shown in degrees where it is of an angle. before: variables of a group.
FmuVariable moving(const FmuLayout& fmu, const TreeBody& body, const MotionGroup& group, int coordinate, int before) {
  FmuVariable variable{
      {group.array, coordinate}, group.prefix + body.coordinate, unit_of(body.kind), group.description};
  variable.unit += group.per;
  if (group.array != Array::z) variable.derivative_of = static_cast<int>(fmu.variables.size()) - before;
  return variable;
}

Start start_of(const FmuLayout& fmu, const InitialState& initial, Array array, int c) {
  const auto acts = [&](const StartParameter& parameter) { return acts_on(parameter, c); };
  const bool is_independent = contains(fmu.independent, c);
  if (array == Array::z && !is_independent) return contains(fmu.undriven, c) ? Start::approx : Start::calculated;
  const bool is_given = array == Array::z || (array == Array::zd && std::ranges::none_of(initial.parameters, acts));
  return is_independent && is_given ? Start::exact : Start::calculated;
}

void add_motion(const EmitContext& context, const InitialState& initial, FmuLayout& fmu) {
  for (const MotionGroup& group : kMotionGroups) {
    for (int c = 0; const TreeBody& body : context.topology.bodies) {
      FmuVariable variable = moving(fmu, body, group, c, context.layout.coordinates);
      variable.start = start_of(fmu, initial, group.array, c);
      if (group.array == Array::z)
        variable.description = variable.start == Start::exact    ? "independent coordinate"
                               : variable.start == Start::approx ? "coordinate that its loop decides"
                                                                 : "driven coordinate";
      if (body.joint >= 0) {
        const std::string& text = context.model.joints[static_cast<std::size_t>(body.joint)].description;
        if (!text.empty()) variable.description += ": " + text;
      }
      if (group.array != Array::zdd) variable.value = (group.array == Array::z ? initial.z : initial.zd)[c];
      if (body.kind == FreedomKind::revolute) variable.shown.display_unit = std::string("deg") + group.per;
      fmu.variables.push_back(std::move(variable));
      ++c;
    }
  }
  const std::vector<AuxiliaryState> states = auxiliary_states(context.model);
  const int count = static_cast<int>(states.size()), flowing = count - context.layout.held;
  for (int i = 0; i < count; ++i) {
    fmu.variables.push_back({{Array::x, i},
                             "x." + states[i].name,
                             states[i].unit,
                             states[i].description,
                             Causality::local,
                             Start::exact,
                             initial.x[i]});
    fmu.variables.back().is_discrete = i >= flowing;
  }
  for (int i = 0; i < flowing; ++i) {
    FmuVariable rate{{Array::xd, i}, "xd." + states[i].name, states[i].rate_unit, "rate of the auxiliary state"};
    rate.derivative_of = static_cast<int>(fmu.variables.size()) - count;
    fmu.variables.push_back(std::move(rate));
  }
}

/// The states of loop blocks and balls, each named after its coordinate at the start.
void add_chosen(const EmitContext& context, FmuLayout& fmu) {
  for (const MotionGroup& group : kMotionGroups) {
    for (const int place : fmu.chosen) {
      const int coordinate = fmu.independent[place];
      const TreeBody& body = context.topology.bodies[coordinate];
      FmuVariable variable = moving(fmu, body, group, coordinate, static_cast<int>(fmu.chosen.size()));
      variable.name = group.chosen_prefix + body.coordinate;
      variable.description =
          fmu.block_of[coordinate] >= 0
              ? std::string(group.chosen_description) + ": of this coordinate, until an event chooses another one"
              : std::string(group.ball_description) + ": of this sequence, until an event takes other angles";
      variable.reinit = group.array != Array::zdd;
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

/// Knowns of dependent and driven positions: the knowns of the closure's Newton step, until nothing is added.
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

/// With other angles of a ball, each of them and of their rates and accelerations may depend on all that one of these
/// does now, and on all three angles and rates.
void share_in_balls(const Topology& topology, Array array, Knowns& knowns) {
  for (const Ball& ball : topology.balls) {
    std::set<int> all;
    for (const int i : ball.coordinate) {
      for (const Array part : {Array::z, Array::zd, Array::zdd}) {
        const auto found = knowns.find({part, i});
        if (part <= array && found != knowns.end()) all.insert(found->second.begin(), found->second.end());
      }
    }
    for (const int i : ball.coordinate) knowns[{array, i}] = all;
  }
}

/// Value references of the numbers of programs: of each itself, and of the state in its place where an event may choose
/// another coordinate.
struct References {
  std::map<Slot, int> own, state;
};

References references_of(const FmuLayout& fmu) {
  References references;
  for (int i = 0; const FmuVariable& variable : fmu.variables) {
    references.own.try_emplace(variable.slot, i);
    references.state[variable.slot] = i++;
  }
  return references;
}

/// Dependencies of all numbers of the programs.
Knowns dependencies(const EmitContext& context, const Programs& programs, const References& references,
                    const FmuLayout& fmu) {
  Knowns knowns;
  for (const auto& [slot, reference] : references.state) {
    const Array array = slot.group.array;
    const bool is_flowing = array == Array::x && slot.index < context.layout.auxiliary_states - context.layout.held;
    const bool is_given = array == Array::t || array == Array::par || array == Array::in || is_flowing;
    const bool is_state = (array == Array::z || array == Array::zd) && contains(fmu.independent, slot.index);
    if (is_given || is_state) knowns[slot] = {reference};
  }
  if (context.layout.has_closure) close_positions(context, programs, fmu, knowns);
  for (const Array array : {Array::z, Array::zd}) {
    share_in_blocks(fmu, array, knowns);
    share_in_balls(context.topology, array, knowns);
  }
  knowns.merge(reached(programs.accelerations, knowns));
  share_in_blocks(fmu, Array::zdd, knowns);
  share_in_balls(context.topology, Array::zdd, knowns);
  if (context.layout.has_closure) knowns.merge(reached(programs.multipliers, knowns));
  knowns.merge(reached(programs.outputs, knowns));
  return knowns;
}

/// Dependencies of a variable at the initialisation: start values of coordinates replace states, and the parameters
/// that velocities follow from replace velocities.
std::set<int> at_start(const FmuLayout& fmu, const References& references, const InitialState& initial,
                       const std::set<int>& dependencies) {
  const int first_parameter = static_cast<int>(fmu.variables.size() - initial.parameters.size());
  std::set<int> result;
  for (const int known : dependencies) {
    const Slot& slot = fmu.variables[static_cast<std::size_t>(known)].slot;
    std::set<int> acting;
    for (int i = 0; const StartParameter& parameter : initial.parameters) {
      if (slot.group == Array::zd && acts_on(parameter, slot.index)) acting.insert(first_parameter + i);
      ++i;
    }
    if (acting.empty()) acting = {references.own.at(slot)};
    result.merge(acting);
  }
  return result;
}

void add_structure(const InitialState& initial_state, const References& references, Knowns knowns, FmiVersion version,
                   FmuLayout& fmu) {
  const auto is_parameter = [&](int known) {
    return fmu.variables[static_cast<std::size_t>(known)].causality == Causality::parameter;
  };
  const auto is_motion = [&](int known) {
    const Array array = fmu.variables[static_cast<std::size_t>(known)].slot.group.array;
    return array == Array::z || array == Array::zd || array == Array::x;
  };
  const auto add = [&](int variable, std::vector<FmuUnknown>& unknowns) {
    FmuUnknown unknown{variable, knowns[fmu.variables[static_cast<std::size_t>(variable)].slot]};
    if (version == FmiVersion::two) std::erase_if(unknown.dependencies, is_parameter);
    if (!fmu.has_states) std::erase_if(unknown.dependencies, is_motion);
    unknowns.push_back(std::move(unknown));
  };
  for (int i = 0; i < static_cast<int>(fmu.variables.size()); ++i)
    if (fmu.variables[i].causality == Causality::output) add(i, fmu.outputs);
  for (const Array array : {Array::zd, Array::zdd})
    for (const int i : fmu.independent) add(references.state.at({array, i}), fmu.derivatives);
  for (int i = 0; references.own.contains({Array::xd, i}); ++i) add(references.own.at({Array::xd, i}), fmu.derivatives);

  std::set<int> initial;
  for (const int place : fmu.chosen) initial.insert(references.state.at({Array::z, fmu.independent[place]}));
  for (const std::vector<FmuUnknown>* unknowns : {&fmu.outputs, &fmu.derivatives}) {
    if (!fmu.has_states && unknowns == &fmu.derivatives) continue;
    for (const FmuUnknown& unknown : *unknowns) initial.insert(unknown.variable);
  }
  for (const int i : initial) {
    const FmuVariable& variable = fmu.variables[static_cast<std::size_t>(i)];
    if (variable.start != Start::calculated) continue;
    fmu.initial_unknowns.push_back({i, at_start(fmu, references, initial_state, knowns[variable.slot])});
  }
}

/// Coordinates whose block may take others as independent ones, and where they stand among the independent ones.
void find_chosen(const EmitContext& context, FmuLayout& fmu) {
  for (int i = 0; i < context.layout.coordinates; ++i) {
    const int block = context.topology.groups[context.topology.group_of[i]].block;
    fmu.block_of.push_back(context.layout.chooses_again && !context.analysis.driven[i] ? block : -1);
    if (!context.analysis.driven[i]) fmu.undriven.push_back(i);
  }
  const auto is_angle = [&](int coordinate) {
    return std::ranges::any_of(context.topology.balls, [coordinate](const Ball& ball) {
      return std::ranges::find(ball.coordinate, coordinate) != std::end(ball.coordinate);
    });
  };
  for (std::size_t i = 0; i < fmu.independent.size() && fmu.has_states; ++i) {
    if (fmu.block_of[fmu.independent[i]] >= 0 || is_angle(fmu.independent[i]))
      fmu.chosen.push_back(static_cast<int>(i));
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
  fmu.has_states = rolling_loop(context.topology) == nullptr;
  fmu.independent = free_coordinates(context.topology, context.analysis);
  std::sort(fmu.independent.begin(), fmu.independent.end());
  find_chosen(context, fmu);
  add_parameters_and_inputs(context, fmu);
  add_outputs(context, fmu);
  add_motion(context, initial, fmu);
  add_chosen(context, fmu);
  add_start_parameters(context, initial, fmu);
  const References references = references_of(fmu);
  add_structure(initial, references, dependencies(context, programs, references, fmu), version, fmu);
  add_indicators(context, fmu);
  add_nominals(context, initial, fmu);
  return fmu;
}

}  // namespace mbgen
