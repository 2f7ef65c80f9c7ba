#include "compiler/emit/layout.hpp"

#include <algorithm>

#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

using Texts = std::vector<std::string>;

Texts indexed(const std::string& array, int size, int first = 0) {
  Texts texts;
  for (int i = 0; i < size; ++i) texts.push_back(array + "[" + std::to_string(first + i) + "]");
  return texts;
}

/// `array[Enum::name]` for every name.
Texts named(const std::string& array, const std::string& enumeration, const std::vector<std::string>& names) {
  Texts texts;
  for (const std::string& name : names) texts.push_back(array + "[" + enumeration + "::" + name + "]");
  return texts;
}

Texts members(const std::string& structure, const std::vector<std::string>& names) {
  Texts texts;
  for (const std::string& name : names) texts.push_back(structure + "." + name);
  return texts;
}

Texts prefixed(const std::string& prefix, const std::vector<std::string>& names) {
  Texts texts;
  for (const std::string& name : names) texts.push_back(prefix + name);
  return texts;
}

GroupPlace result_place(Texts texts, const std::string& missing = "0.0") {
  return {"result", std::move(texts), {}, missing, "", 0};
}

/// Slots in the order of an array.
GroupPlace result_array(const std::string& array, Texts texts, const std::string& missing = "0.0") {
  return {"result", std::move(texts), {}, missing, array, 0};
}

/// Adds an array of every block, one after the other in one flat array.
template <class Size, class First>
void add_blocks(Places& places, const std::string& argument, Array array, const SolverLayout& layout, Size size,
                First first) {
  const int blocks = static_cast<int>(layout.blocks.size());
  for (int b = 0; b < blocks; ++b) {
    const BlockPlaces& block = layout.blocks[b];
    const std::string member = argument + "." + name_of(array);
    places[of_block(array, static_cast<std::size_t>(b))] = {
        argument, indexed(member, size(block), first(block)), {}, "0.0", member, first(block)};
  }
}

const std::vector<std::pair<std::string, std::string>> kStateArguments = {
    {"parameters", "const Tuned& parameters"}, {"inputs", "const Inputs& inputs"}, {"state", "const State& state"}};

ProgramShape shape(const std::string& title, const std::string& result, const std::string& function,
                   const std::vector<std::pair<std::string, std::string>>& more_arguments, const Places& inputs) {
  ProgramShape shape;
  shape.title = title;
  shape.function = function;
  shape.result = result;
  shape.arguments = kStateArguments;
  shape.arguments.insert(shape.arguments.end(), more_arguments.begin(), more_arguments.end());
  shape.inputs = inputs;
  return shape;
}

const std::pair<std::string, std::string> kTau{"tau", "const double* tau"};
const std::pair<std::string, std::string> kDerivative{"derivative", "const Derivative& derivative"};
const std::pair<std::string, std::string> kMultipliers{"multipliers", "const Multipliers& multipliers"};
const std::pair<std::string, std::string> kProjection{"projection", "const Projection& projection"};

ProgramShape accelerations_shape(const SolverLayout& layout, const SolverNames& names, const Places& inputs,
                                 int directions) {
  ProgramShape s = shape("All accelerations with the frozen partition of the loop blocks.", "Accelerations",
                         "compute_accelerations", {kTau}, inputs);
  const int blocks = static_cast<int>(layout.blocks.size());
  s.members = {{"zdd", layout.coordinates, "accelerations"},
               {"xd", layout.auxiliary_states, "rates of the auxiliary states"},
               {"pivot", blocks, "smallest pivot of each block over its reference"},
               {"inertia", directions, "pivots of the final equations"}};
  s.outputs[Array::zdd] = result_array("result.zdd", named("result.zdd", "Coordinate", names.coordinates));
  s.outputs[Array::xd] = result_array("result.xd", indexed("result.xd", layout.auxiliary_states));
  // A block of rank zero has no pivot to watch.
  s.outputs[Array::pivot] = result_array("result.pivot", indexed("result.pivot", blocks), "1.0");
  s.outputs[Array::inertia] = result_array("result.inertia", indexed("result.inertia", directions), "1.0");
  return s;
}

ProgramShape chosen_shape(const SolverLayout& layout, const SolverNames& names, const Places& inputs, int directions) {
  ProgramShape s = accelerations_shape(layout, names, inputs, directions);
  s.title = "All accelerations with a partition chosen at run time.";
  s.function = "compute_chosen_accelerations";
  s.result = "ChosenAccelerations";
  s.arguments.push_back(kProjection);
  s.outputs.erase(Array::pivot);
  s.members.erase(s.members.begin() + 2);
  return s;
}

ProgramShape closure_shape(const SolverLayout& layout, const SolverNames& names, const Places& inputs) {
  ProgramShape s = shape("One Newton step of the frozen partition, and consistent velocities.", "Closure",
                         "compute_closure", {}, inputs);
  const int blocks = static_cast<int>(layout.blocks.size());
  const int residuals = layout.equations + layout.drives;
  s.members = {{"residual", residuals, "of every closure equation, block after block, then of every motion"},
               {"dz", layout.coordinates, "Newton correction; driven coordinates go to their motions"},
               {"zd", layout.coordinates, "consistent velocities"},
               {"pivot", blocks, "smallest pivot of each block over its reference"}};
  s.outputs[Array::residual] = result_array("result.residual", indexed("result.residual", residuals));
  s.outputs[Array::dz] = result_array("result.dz", named("result.dz", "Coordinate", names.coordinates));
  s.outputs[Array::zd] = result_array("result.zd", named("result.zd", "Coordinate", names.coordinates));
  s.outputs[Array::pivot] = result_array("result.pivot", indexed("result.pivot", blocks), "1.0");
  return s;
}

ProgramShape closure_terms_shape(const SolverLayout& layout, const SolverNames& names, const Places& inputs) {
  ProgramShape s = shape("Closure equations and their derivatives, for the pivoting factorisation.", "ClosureTerms",
                         "compute_closure_terms", {}, inputs);
  s.members = {{"Phi", layout.equations, "residuals"},
               {"Jz", layout.jacobian_entries, "Jacobian of each block, row by row"},
               {"c", layout.equations, "right-hand side of the accelerations"},
               {"driven_acceleration", layout.coordinates, "of driven coordinates, by their motions; no others"}};
  const auto equations = [](const BlockPlaces& b) { return b.equations; };
  const auto first_equation = [](const BlockPlaces& b) { return b.first_equation; };
  for (const Array array : {Array::Phi, Array::c}) {
    add_blocks(s.outputs, "result", array, layout, equations, first_equation);
  }
  if (!layout.chooses_again) {
    s.members[1] = {"rate", layout.equations, "Jacobian times velocities"};
    add_blocks(s.outputs, "result", Array::rate, layout, equations, first_equation);
  } else {
    add_blocks(
        s.outputs, "result", Array::Jz, layout, [](const BlockPlaces& b) { return b.equations * b.coordinates; },
        [](const BlockPlaces& b) { return b.first_jacobian; });
  }
  s.outputs[Array::driven_acceleration] = result_array(
      "result.driven_acceleration", named("result.driven_acceleration", "Coordinate", names.coordinates), "");
  return s;
}

ProgramShape multipliers_shape(const SolverLayout& layout, const Places& inputs) {
  ProgramShape s = shape("Multipliers of the closures and generalised driving forces, at given accelerations.",
                         "ConstraintForces", "compute_multipliers", {kTau, kDerivative}, inputs);
  const int blocks = static_cast<int>(layout.blocks.size());
  s.members = {{"lambda", layout.equations, "multipliers, loop after loop"},
               {"drive", layout.drives, "generalised driving forces"},
               {"missing", layout.block_coordinates, "what multipliers and drives must provide, block after block"},
               {"pivot", blocks, "smallest pivot of each block over its reference"}};
  add_blocks(
      s.outputs, "result", Array::missing, layout, [](const BlockPlaces& b) { return b.coordinates; },
      [](const BlockPlaces& b) { return b.first_coordinate; });
  s.outputs[Array::pivot] = result_array("result.pivot", indexed("result.pivot", blocks), "1.0");
  s.outputs[Array::lambda] = result_array("result.lambda", indexed("result.lambda", layout.equations));
  s.outputs[Array::drive] = result_array("result.drive", indexed("result.drive", layout.drives));
  return s;
}

ProgramShape outputs_shape(const SolverNames& names, const Places& inputs, bool with_multipliers) {
  ProgramShape s = shape("Outputs, energies and power, at given accelerations.", "Outputs", "compute_outputs",
                         {kTau, kDerivative}, inputs);
  if (with_multipliers) s.arguments.push_back(kMultipliers);
  s.outputs[Array::y] = result_place(members("result", names.outputs));
  s.outputs[Array::energy] = result_place({"result.kinetic_energy", "result.potential_energy"});
  s.outputs[Array::power] = result_place({"result.applied_power"});
  return s;
}

ProgramShape derived_shape(const Places& inputs, int count) {
  ProgramShape s;
  s.title = "Constants that follow from tunable parameters.";
  s.function = "compute_derived_constants";
  s.result = "Tuned";
  s.arguments = {{"parameters", "const Parameters& parameters"}};
  s.inputs = inputs;
  s.outputs[Array::derived] = result_array("result.derived", indexed("result.derived", count));
  return s;
}

/// The shape with floats in place of doubles. The time stays one, and is narrowed where a program looks at it.
void take_floats(ProgramShape& shape) {
  shape.scalar = "float";
  for (auto& [name, declaration] : shape.arguments) {
    if (name == kTau.first) declaration = "const float* tau";
  }
  shape.inputs[Array::t].texts = {"static_cast<float>(state.t)"};
  for (auto& [group, place] : shape.outputs) {
    if (!place.missing.empty()) place.missing += "f";
  }
}

}  // namespace

Places input_places(const Programs& programs, const SolverLayout& layout, const SolverNames& names) {
  const auto& coordinates = names.coordinates;
  Places places;
  places[Array::z] = {"state", named("state.z", "Coordinate", coordinates), prefixed("z_", coordinates), "", "state.z",
                      0};
  places[Array::zd] = {
      "state", named("state.zd", "Coordinate", coordinates), prefixed("zd_", coordinates), "", "state.zd", 0};
  places[Array::x] = {"state", indexed("state.x", layout.auxiliary_states), {}, "", "state.x", 0};
  places[Array::t] = {"state", {"state.t"}, {}, "", "", 0};
  places[Array::tau] = {"tau", named("tau", "Coordinate", coordinates), prefixed("tau_", coordinates), "", "tau", 0};
  places[Array::zdd] = {"derivative",
                        named("derivative.zdd", "Coordinate", coordinates),
                        prefixed("zdd_", coordinates),
                        "",
                        "derivative.zdd",
                        0};
  places[Array::lambda] = {
      "multipliers", indexed("multipliers.lambda", layout.equations), {}, "", "multipliers.lambda", 0};
  places[Array::drive] = {"multipliers", indexed("multipliers.drive", layout.drives), {}, "", "multipliers.drive", 0};
  places[Array::in] = {"inputs", members("inputs", names.inputs), {}, "", "", 0};
  places[Array::par] = {"parameters", members("parameters", names.parameters), {}, "", "", 0};
  const int derived = derived_constant_count(programs);
  places[Array::derived] = {"parameters", indexed("parameters.derived", derived), {}, "", "parameters.derived", 0};
  add_blocks(
      places, "projection", Array::Rz, layout, [](const BlockPlaces& b) { return b.coordinates * b.free; },
      [](const BlockPlaces& b) { return b.first_projection; });
  add_blocks(
      places, "projection", Array::zdd_star, layout, [](const BlockPlaces& b) { return b.coordinates; },
      [](const BlockPlaces& b) { return b.first_coordinate; });
  return places;
}

SolverLayout solver_layout(const Model& model, const Topology& topology, const Analysis& analysis) {
  SolverLayout layout;
  layout.coordinates = topology.size();
  layout.auxiliary_states = auxiliary_state_count(model);
  layout.drives = static_cast<int>(model.motions.size());
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

std::string constant_text(const Program& program, const Node& node, const ProgramShape& shape) {
  if (node.label >= 0 && shape.constants != nullptr) return shape.constants->text(program, node);
  return number_text(node.constant, shape.scalar);
}

int derived_constant_count(const Programs& programs) {
  return static_cast<int>(programs.derived_constants.outputs.size());
}

ShapedProgram clocked_accelerations(const Programs& programs, const SolverLayout& layout, const SolverNames& names,
                                    const Titles& titles) {
  const int directions = static_cast<int>(programs.free_direction_coordinate.size());
  ProgramShape s = accelerations_shape(layout, names, input_places(programs, layout, names), directions);
  s.title = "All accelerations, step by step against the clock.";
  s.function = "compute_clocked_accelerations";
  s.result = "ClockedAccelerations";
  s.clock = "clock";
  s.titles = titles;
  s.arguments.push_back({"clock", "mbgen::StepClock& clock"});
  return {&programs.accelerations, Role::accelerations, s,
          schedule(programs.accelerations, schedule_options(s, kRollAbove))};
}

ScheduleOptions schedule_options(const ProgramShape& shape, std::size_t roll_above) {
  ScheduleOptions options{shape.clock.empty() ? Division::cheapest : Division::by_section, shape.order, roll_above};
  for (const Places* places : {&shape.inputs, &shape.outputs})
    for (const auto& [group, place] : *places)
      if (!place.array.empty()) options.indexed.insert(group);
  return options;
}

/// The programs whose time counts, unless they are so short that registers and cache hold most of them. All others, and
/// the matrix form, keep the order of the steps of the method: a person reads them from top to bottom.
static ValueOrder order_of(Form form, const ShapedProgram& shaped) {
  const bool runs_in_every_step = shaped.role == Role::accelerations || shaped.role == Role::closure;
  const bool is_long = shaped.program->nodes.size() > kLargestPart;
  return form == Form::recursive && runs_in_every_step && is_long ? ValueOrder::fewest_alive : ValueOrder::by_section;
}

bool is_number(const std::string& scalar) { return scalar == "double" || scalar == "float"; }

std::vector<ShapedProgram> shaped_programs(const Programs& programs, const SolverLayout& layout,
                                           const SolverNames& names, const Titles& titles, const std::string& scalar,
                                           std::size_t roll_above) {
  const Places inputs = input_places(programs, layout, names);
  const int directions = static_cast<int>(programs.free_direction_coordinate.size());
  std::vector<ShapedProgram> all = {
      {&programs.accelerations, Role::accelerations, accelerations_shape(layout, names, inputs, directions)}};
  if (layout.has_closure) {
    all.push_back({&programs.closure, Role::closure, closure_shape(layout, names, inputs)});
    all.push_back({&programs.multipliers, Role::multipliers, multipliers_shape(layout, inputs)});
  }
  if (!layout.blocks.empty()) {
    all.push_back({&programs.closure_terms, Role::closure_terms, closure_terms_shape(layout, names, inputs)});
    if (layout.chooses_again)
      all.push_back({&programs.accelerations_chosen, Role::accelerations_chosen,
                     chosen_shape(layout, names, inputs, directions)});
  }
  all.push_back({&programs.outputs, Role::outputs, outputs_shape(names, inputs, outputs_take_multipliers(programs))});
  if (derived_constant_count(programs) > 0)
    all.insert(all.begin(), {&programs.derived_constants, Role::derived_constants,
                             derived_shape(inputs, derived_constant_count(programs))});
  if (scalar == "float") {
    for (ShapedProgram& shaped : all) take_floats(shaped.shape);
  }
  for (ShapedProgram& shaped : all) {
    shaped.shape.titles = titles;
    shaped.shape.order = order_of(programs.form, shaped);
    shaped.schedule = schedule(*shaped.program, schedule_options(shaped.shape, roll_above));
  }
  return all;
}

bool outputs_take_multipliers(const Programs& programs) {
  return std::any_of(programs.outputs.inputs.begin(), programs.outputs.inputs.end(),
                     [](const Slot& slot) { return slot.group == Array::lambda || slot.group == Array::drive; });
}

}  // namespace mbgen
