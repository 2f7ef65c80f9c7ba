#include "compiler/emit/layout.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "compiler/emit/mapped.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

using Texts = std::vector<std::string>;

/// Sizes and names that decide where arrays live.
struct Extents {
  const SolverLayout& layout;
  const SolverNames& names;
  int directions, derived;
};

/// The numbers of an array: as many as `size` says, a flat array of all loop blocks, or one a coordinate.
struct ArrayExtent {
  Array array;
  const char* comment = "";  ///< as a member of a result
  int (*size)(const Extents&) = nullptr;
  int BlockPlaces::*first = nullptr;
  int (*in_block)(const BlockPlaces&) = nullptr;

  bool is_by_coordinate() const { return size == nullptr && first == nullptr; }
};

int auxiliary_states(const Extents& e) { return e.layout.auxiliary_states; }
int equations(const BlockPlaces& block) { return block.equations; }
int coordinates(const BlockPlaces& block) { return block.coordinates; }

constexpr ArrayExtent kExtents[] = {
    {Array::zd, "consistent velocities"},
    {Array::zdd, "accelerations"},
    {Array::dz, "Newton correction; driven coordinates go to their motions"},
    {Array::driven_acceleration, "of driven coordinates, by their motions; no others"},
    {Array::x, "", auxiliary_states},
    {Array::charts, "", [](const Extents& e) { return e.layout.balls; }},
    {Array::xd, "rates of the auxiliary states", auxiliary_states},
    {Array::lambda, "multipliers, loop after loop", [](const Extents& e) { return e.layout.equations; }},
    {Array::drive, "generalised driving forces", [](const Extents& e) { return e.layout.drives; }},
    {Array::residual, "of every closure equation, block after block, then of every motion",
     [](const Extents& e) { return e.layout.equations + e.layout.drives; }},
    {Array::pivot, "smallest pivot of each block over its reference",
     [](const Extents& e) { return static_cast<int>(e.layout.blocks.size()); }},
    {Array::inertia, "pivots of the final equations", [](const Extents& e) { return e.directions; }},
    {Array::derived, "", [](const Extents& e) { return e.derived; }},
    {Array::Phi, "residuals", nullptr, &BlockPlaces::first_equation, equations},
    {Array::c, "right-hand side of the accelerations", nullptr, &BlockPlaces::first_equation, equations},
    {Array::rate, "Jacobian times velocities", nullptr, &BlockPlaces::first_equation, equations},
    {Array::missing, "what multipliers and drives must provide, block after block", nullptr,
     &BlockPlaces::first_coordinate, coordinates},
    {Array::zdd_star, "", nullptr, &BlockPlaces::first_coordinate, coordinates},
    {Array::Jz, "Jacobian of each block, row by row", nullptr, &BlockPlaces::first_jacobian,
     [](const BlockPlaces& b) { return b.equations * b.coordinates; }},
    {Array::Rz, "", nullptr, &BlockPlaces::first_projection,
     [](const BlockPlaces& b) { return b.coordinates * b.free; }}};

ArrayExtent extent_of(Array array) {
  const auto found = std::ranges::find(kExtents, array, &ArrayExtent::array);
  return found != std::end(kExtents) ? *found : ArrayExtent{array};
}

int size_of(const ArrayExtent& extent, const Extents& extents) {
  if (extent.is_by_coordinate()) return extents.layout.coordinates;
  if (extent.size != nullptr) return extent.size(extents);
  const std::vector<BlockPlaces>& blocks = extents.layout.blocks;
  return blocks.empty() ? 0 : blocks.back().*extent.first + extent.in_block(blocks.back());
}

Texts indexed(const std::string& array, int size, int first = 0) {
  Texts texts;
  for (int i = 0; i < size; ++i) texts.push_back(array + "[" + std::to_string(first + i) + "]");
  return texts;
}

Texts around(const std::string& before, const std::vector<std::string>& names, const std::string& after = "") {
  return mapped(names, [&](const std::string& name) { return before + name + after; });
}

/// The value of an output that the program does not give. A block of rank zero has no pivot to watch.
std::string missing_value(Array array) {
  if (array == Array::driven_acceleration) return "";
  return array == Array::pivot || array == Array::inertia ? "1.0" : "0.0";
}

/// Adds where an array lives in the struct of an argument, by coordinates or by number.
void add_array(Places& places, const std::string& argument, Array array, const Extents& extents) {
  const std::string name = array == Array::tau ? "tau" : argument + "." + name_of(array);
  const ArrayExtent extent = extent_of(array);
  for (std::size_t b = 0; extent.first != nullptr && b < extents.layout.blocks.size(); ++b) {
    const BlockPlaces& block = extents.layout.blocks[b];
    const int first = block.*extent.first;
    places[of_block(array, b)] = {argument, indexed(name, extent.in_block(block), first), {}, "0.0", name, first};
  }
  if (extent.first != nullptr) return;
  GroupPlace& place = places[array] = {argument, {}, {}, missing_value(array), name, 0};
  if (!extent.is_by_coordinate()) {
    place.texts = indexed(name, extent.size(extents));
    return;
  }
  place.texts = around(name + "[Coordinate::", extents.names.coordinates, "]");
  if (argument != "result") place.locals = around(std::string(name_of(array)) + "_", extents.names.coordinates);
}

/// The arguments of a program that takes an array, beside parameters, inputs and state.
constexpr std::tuple<Array, const char*, const char*> kArguments[] = {
    {Array::tau, "tau", "const double* tau"},
    {Array::zdd, "derivative", "const Derivative& derivative"},
    {Array::lambda, "multipliers", "const Multipliers& multipliers"},
    {Array::Rz, "projection", "const Projection& projection"}};

/// A program as its text names it.
struct ShapeRow {
  Role role;
  const char *function, *result, *title;
};

/// In the order of the file.
constexpr ShapeRow kShapes[] = {
    {Role::derived_constants, "derived_constants", "Tuned", "Constants that follow from tunable parameters."},
    {Role::accelerations, "accelerations", "Accelerations",
     "All accelerations with the frozen partition of the loop blocks."},
    {Role::closure, "closure", "Closure", "One Newton step of the frozen partition, and consistent velocities."},
    {Role::multipliers, "multipliers", "ConstraintForces",
     "Multipliers of the closures and generalised driving forces, at given accelerations."},
    {Role::closure_terms, "closure_terms", "ClosureTerms",
     "Closure equations and their derivatives, for the pivoting factorisation."},
    {Role::accelerations_chosen, "chosen_accelerations", "ChosenAccelerations",
     "All accelerations with a partition chosen at run time."},
    {Role::outputs, "outputs", "Outputs", "Outputs, energies and power, at given accelerations."}};

/// Whether a solver has the program: those of closures are left out when there is nothing to close.
bool is_written(Role role, const Programs& programs, const SolverLayout& layout) {
  if (role == Role::derived_constants) return derived_constant_count(programs) > 0;
  if (role == Role::closure || role == Role::multipliers) return layout.has_closure;
  if (role == Role::closure_terms) return !layout.blocks.empty();
  return role != Role::accelerations_chosen || ((!layout.blocks.empty() || layout.balls > 0) && layout.chooses_again);
}

Extents extents_of(const Programs& programs, const SolverLayout& layout, const SolverNames& names) {
  return {layout, names, static_cast<int>(programs.free_direction_coordinate.size()), derived_constant_count(programs)};
}

/// Whether the solver has the argument that holds an array.
bool is_given(Array array, const Programs& programs, const SolverLayout& layout) {
  if (array == Array::lambda) return outputs_take_multipliers(programs);
  return array != Array::Rz || !layout.blocks.empty();
}

ProgramShape shape_of(const ShapeRow& row, const Programs& programs, const Extents& extents) {
  const ProgramSpec& spec = program_specs()[static_cast<std::size_t>(row.role)];
  ProgramShape shape;
  shape.title = row.title;
  shape.function = std::string("compute_") + row.function;
  shape.result = row.result;
  shape.inputs = input_places(programs, extents.layout, extents.names);
  shape.arguments = {
      {"parameters", "const Tuned& parameters"}, {"inputs", "const Inputs& inputs"}, {"state", "const State& state"}};
  if (row.role == Role::derived_constants) {
    shape.arguments = {{"parameters", "const Parameters& parameters"}};
    shape.inputs.erase(Array::derived);
  }
  for (const auto& [array, name, declaration] : kArguments)
    if (std::ranges::count(spec.inputs, array) > 0 && is_given(array, programs, extents.layout))
      shape.arguments.emplace_back(name, declaration);
  for (const Array array : spec.outputs) {
    if (array == (extents.layout.chooses_again ? Array::rate : Array::Jz)) continue;
    const ArrayExtent extent = extent_of(array);
    if (*extent.comment != 0) shape.members.push_back({name_of(array), size_of(extent, extents), extent.comment});
    add_array(shape.outputs, "result", array, extents);
  }
  if (row.role != Role::outputs) return shape;
  shape.outputs = {{Array::y, {"result", around("result.", extents.names.outputs)}},
                   {Array::energy, {"result", {"result.kinetic_energy", "result.potential_energy"}}},
                   {Array::power, {"result", {"result.applied_power"}}}};
  return shape;
}

/// The shape with floats in place of doubles. The time stays one, and is narrowed where a program looks at it.
void take_floats(ProgramShape& shape) {
  shape.scalar = "float";
  for (auto& [name, declaration] : shape.arguments) {
    if (name == "tau") declaration = "const float* tau";
  }
  shape.inputs[Array::t].texts = {"static_cast<float>(state.t)"};
  for (auto& [group, place] : shape.outputs) {
    if (!place.missing.empty()) place.missing += "f";
  }
}

}  // namespace

Places input_places(const Programs& programs, const SolverLayout& layout, const SolverNames& names) {
  const Extents extents = extents_of(programs, layout, names);
  Places places;
  for (const Array array : {Array::z, Array::zd, Array::x, Array::charts}) add_array(places, "state", array, extents);
  for (const Array array : {Array::lambda, Array::drive}) add_array(places, "multipliers", array, extents);
  for (const Array array : {Array::Rz, Array::zdd_star}) add_array(places, "projection", array, extents);
  add_array(places, "tau", Array::tau, extents);
  add_array(places, "derivative", Array::zdd, extents);
  add_array(places, "parameters", Array::derived, extents);
  places[Array::derived].locals = derived_constant_names(programs);
  places[Array::derived].local_tells_more = true;
  places[Array::t] = {"state", {"state.t"}};
  places[Array::in] = {"inputs", around("inputs.", names.inputs)};
  places[Array::par] = {"parameters", around("parameters.", names.parameters)};
  return places;
}

SolverLayout solver_layout(const Model& model, const Topology& topology, const Analysis& analysis) {
  SolverLayout layout;
  layout.coordinates = topology.size();
  layout.auxiliary_states = auxiliary_state_count(model);
  layout.balls = static_cast<int>(topology.balls.size());
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

std::vector<std::string> derived_constant_names(const Programs& programs) {
  const Program& program = programs.derived_constants;
  std::vector<std::string> names(program.outputs.size()), taken;
  for (const OutputValue& output : program.outputs) {
    const Node& node = program.nodes[output.value];
    if (node.op != Op::constant && node.label >= 0)
      names[static_cast<std::size_t>(output.slot.index)] = identifier(program.labels[node.label], taken);
  }
  return names;
}

ShapedProgram clocked_accelerations(const Programs& programs, const SolverLayout& layout, const SolverNames& names,
                                    const Titles& titles) {
  const ShapeRow* row = std::ranges::find(kShapes, Role::accelerations, &ShapeRow::role);
  ProgramShape s = shape_of(*row, programs, extents_of(programs, layout, names));
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
  const Extents extents = extents_of(programs, layout, names);
  std::vector<ShapedProgram> all;
  for (const ShapeRow& row : kShapes) {
    if (!is_written(row.role, programs, layout)) continue;
    all.push_back({&program_of(programs, row.role), row.role, shape_of(row, programs, extents)});
    if (scalar == "float") take_floats(all.back().shape);
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
