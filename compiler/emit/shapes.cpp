#include "compiler/emit/shapes.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "compiler/emit/mapped.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/program/in_threads.hpp"

namespace mbgen {
namespace {

using Texts = std::vector<std::string>;

/// The arrays that are members of a result, each with its comment.
constexpr std::pair<Array, const char*> kMembers[] = {
    {Array::zd, "consistent velocities"},
    {Array::zdd, "accelerations"},
    {Array::dz, "Newton correction; driven coordinates go to their motions"},
    {Array::driven_acceleration, "of driven coordinates, by their motions; no others"},
    {Array::xd, "rates of the auxiliary states"},
    {Array::hold, "of places of elements: negative, or NaN, where one does not hold"},
    {Array::held, "the last auxiliary states: sampled values"},
    {Array::place, "x and y below each wheel on ground of the host"},
    {Array::lambda, "multipliers, loop after loop"},
    {Array::drive, "generalised driving forces"},
    {Array::force, "of each actuator"},
    {Array::actuation, "pivots of the actuators over their references"},
    {Array::position, "of each actuator's motor"},
    {Array::direction, "generalised forces for a unit force of each actuator, row by row"},
    {Array::drift, "acceleration of each motor where no coordinate accelerates"},
    {Array::required, "generalised forces of the tree"},
    {Array::residual, "of every closure equation, block after block, then of every motion"},
    {Array::pivot, "smallest pivot of each block over its reference"},
    {Array::inertia, "pivots of the final equations"},
    {Array::state_pivot, "pivots of the states' equations"},
    {Array::tangent, "entries of the implicit equations that are not constant"},
    {Array::Phi, "residuals"},
    {Array::c, "right-hand side of the accelerations"},
    {Array::rate, "Jacobian times velocities"},
    {Array::missing, "force that multipliers and drives must provide, block after block"},
    {Array::Jz, "Jacobian of each block, row by row"},
    {Array::Rz, "free directions of each block, row by row"}};

/// Whether the array has one number per coordinate, at the coordinate's name.
bool is_by_coordinate(Array array) {
  using enum Array;
  return array == z || array == zd || array == zdd || array == dz || array == driven_acceleration || array == tau ||
         array == required;
}

Texts around(const std::string& before, const std::vector<std::string>& names, const std::string& after = "") {
  return mapped(names, [&](const std::string& name) { return before + name + after; });
}

/// Value of an output that the program does not give. A block of rank zero has no pivot to monitor.
std::string missing_value(Array array) {
  if (array == Array::driven_acceleration) return "";
  return array == Array::pivot || array == Array::inertia || array == Array::state_pivot || array == Array::actuation
             ? "1.0"
             : "0.0";
}

/// Adds the places of an array in the struct of an argument, by coordinates or by number.
void add_array(Places& places, const std::string& argument, Array array, const EmitContext& context) {
  const bool is_bare = array == Array::tau || array == Array::due;
  const std::string name = is_bare ? name_of(array) : argument + "." + name_of(array);
  if (share_of({}, array)) {
    for (std::size_t b = 0; b < context.layout.blocks.size(); ++b) {
      const ArrayShare share = *share_of(context.layout.blocks[b], array);
      places[of_block(array, b)] = {argument, indexed(name, share.size, share.first), {}, "0.0", name, share.first};
    }
    return;
  }
  GroupPlace& place = places[array] = {argument, {}, {}, missing_value(array), name, 0};
  if (!is_by_coordinate(array)) {
    place.texts = indexed(name, size_in(context, array));
    return;
  }
  place.texts = around(name + "[Coordinate::", context.names.coordinates, "]");
  if (argument != "result") place.locals = around(std::string(name_of(array)) + "_", context.names.coordinates);
}

/// The arguments of a program that takes an array, beside parameters, inputs and state.
struct ArgumentOfArray {
  Array array;
  const char *name, *type;
  Passing passing = Passing::reference;
};
constexpr ArgumentOfArray kArguments[] = {
    {Array::tau, "tau", kOfScalar, Passing::pointer},    {Array::zdd, "derivative", "const Derivative"},
    {Array::lambda, "multipliers", "const Multipliers"}, {Array::due, "due", kOfScalar, Passing::pointer},
    {Array::Rz, "projection", "const Projection"},       {Array::step, "size", "const StepSize"},
    {Array::tangent, "tangents", "const Tangents"}};

/// Names of a program in its text.
struct ShapeRow {
  Role role;
  const char *name, *result, *title;
};

/// In the order of the file.
constexpr ShapeRow kShapes[] = {
    {Role::derived_constants, "derived_constants", "Tuned", "Constants that follow from tunable parameters."},
    {Role::accelerations, "accelerations", "Accelerations",
     "All accelerations with the frozen partition of the loop blocks."},
    {Role::closure, "closure", "Closure", "One Newton step of the frozen partition, and consistent velocities."},
    {Role::tangents, "tangents", "Tangents",
     "Equations of an implicit step: tangents of the force elements, and the factors of its matrix."},
    {Role::changes, "changes", "Changes",
     "Changes that solve the implicit equations, of rates in place of velocities and accelerations."},
    {Role::multipliers, "multipliers", "ConstraintForces",
     "Multipliers of the closures and generalised driving forces, at given accelerations."},
    {Role::closure_terms, "closure_terms", "ClosureTerms",
     "Closure equations and their derivatives, for the pivoting factorisation."},
    {Role::accelerations_chosen, "chosen_accelerations", "ChosenAccelerations",
     "All accelerations with a partition chosen at run time."},
    {Role::outputs, "outputs", "Outputs", "Outputs, energies and power, at given accelerations."},
    {Role::sampled, "sampled_values", "SampledValues",
     "Values that hold between instants, after the values that are due."},
    {Role::ground_places, "ground_places", "GroundPlaces", "Places below the wheels on ground of the host."},
    {Role::inverse_dynamics, "inverse_dynamics", "InverseDynamics",
     "Forces of the actuators for given accelerations of the independent coordinates."},
    {Role::actuators, "actuators", "ActuatorTerms", "Positions and directions of the actuators, and their drifts."},
    {Role::required_forces, "required_forces", "RequiredForces",
     "Forces of the tree that accelerations need, without those of the actuators."}};

/// Whether a solver has the program: programs of closures are left out if there is nothing to close.
bool is_written(Role role, const EmitContext& context) {
  const SolverLayout& layout = context.layout;
  if (role == Role::derived_constants) return derived_constant_count(context.programs) > 0;
  if (role == Role::tangents || role == Role::changes || role == Role::inverse_dynamics || role == Role::actuators ||
      role == Role::required_forces)
    return !program_of(context.programs, role).outputs.empty();
  if (role == Role::closure || role == Role::multipliers) return layout.has_closure;
  if (role == Role::sampled) return layout.sampled > 0;
  if (role == Role::ground_places) return layout.grounds > 0;
  if (role == Role::closure_terms) return !layout.blocks.empty();
  if (role != Role::accelerations_chosen) return true;
  return (!layout.blocks.empty() || layout.balls > 0) && layout.chooses_again && !context.regular_only;
}

/// Adds the names of the shared laws to the shape of the program around them.
void add_laws(const EmitContext& context, ProgramShape& shape) {
  for (std::size_t k = 0; k < context.written.laws.size(); ++k) {
    const SharedLaw& shared = context.written.laws[k];
    const LawShape law = law_shape(context, k);
    GroupPlace arguments{law.argument, {}}, results{law.argument, {}};
    const auto add = [&](GroupPlace& place, const std::string& name) {
      for (const std::string& text : indexed(law.argument + "." + name, law.elements)) place.texts.push_back(text);
    };
    for (const LawArgument& argument : shared.arguments) {
      if (!argument.numbers.empty()) continue;
      if (argument.is_common)
        arguments.texts.push_back(law.argument + "." + argument.name);
      else
        add(arguments, argument.name);
    }
    for (const std::string& name : shared.results) add(results, name);
    shape.outputs[of_block(Array::law_argument, k)] = arguments;
    shape.inputs[of_block(Array::law_result, k)] = results;
    shape.laws.push_back(law);
  }
}

/// Arrays that the text of a program takes only if it uses them.
std::vector<Array> unused_arrays(const Program& program, Role role) {
  std::vector<Array> unused;
  if (!takes_multipliers(program)) unused.push_back(Array::lambda);
  if (role == Role::sampled && !takes(program, Array::zdd)) unused.push_back(Array::zdd);
  return unused;
}

ProgramShape shape_of(const ShapeRow& row, const EmitContext& context) {
  ProgramShape shape;
  shape.title = row.title;
  shape.name = row.name;
  shape.function = "compute_" + shape.name;
  shape.result = row.result;
  shape.titles = context.titles;
  shape.inputs = input_places(context);
  shape.arguments = arguments_of(row.role, unused_arrays(program_of(context.programs, row.role), row.role));
  if (context.layout.blocks.empty())
    std::erase_if(shape.arguments, [](const auto& argument) { return argument.name == "projection"; });
  if (row.role == Role::derived_constants) shape.inputs.erase(Array::derived);
  if (row.role == Role::outputs) {
    shape.outputs = {{Array::y, {"result", around("result.", context.names.outputs)}},
                     {Array::energy, {"result", {"result.kinetic_energy", "result.potential_energy"}}},
                     {Array::power, {"result", {"result.applied_power"}}}};
    return shape;
  }
  for (const Array array : spec_of(row.role).outputs) {
    if (array == Array::law_argument || array == (context.layout.chooses_again ? Array::rate : Array::Jz)) continue;
    if (array == Array::hold && context.layout.holds == 0) continue;
    if (array == Array::state_pivot && context.layout.own_states == 0) continue;
    if (array == Array::Rz && (context.layout.blocks.empty() || !context.layout.chooses_again)) continue;
    for (const auto& [member, comment] : kMembers)
      if (member == array) shape.members.push_back({name_of(array), size_in(context, array), comment});
    add_array(shape.outputs, "result", array, context);
  }
  if (row.role == Role::accelerations) add_laws(context, shape);
  return shape;
}

/// Changes the shape from doubles to floats. The time remains a double, and is narrowed where a program uses it.
void take_floats(ProgramShape& shape) {
  shape.scalar = Scalar::floats;
  shape.inputs[Array::t].texts = {"static_cast<float>(state.t)"};
  for (auto& [group, place] : shape.outputs) {
    if (!place.missing.empty()) place.missing += "f";
  }
}

/// Changes the shape from doubles to numbers with derivatives. The time has none.
void take_tangents(ProgramShape& shape) {
  shape.scalar = Scalar::tangents;
  shape.inputs[Array::t].texts = {"Real(state.t)"};
}

/// Order of the values: for speed in programs whose time matters, unless they are so short that registers and cache
/// hold most values. All others, and the matrix form, keep the order of the method's steps, for people who read from
/// top to bottom.
ValueOrder order_of(const EmitContext& context, const ShapedProgram& shaped) {
  const Form form = context.programs.form;
  if (context.options.spelling == Spelling::reading) return ValueOrder::reading;
  const bool runs_in_every_step = shaped.role == Role::accelerations || shaped.role == Role::closure ||
                                  shaped.role == Role::tangents || shaped.role == Role::changes;
  const bool is_long = shaped.program->nodes.size() > kLargestPart;
  return form == Form::recursive && runs_in_every_step && is_long ? ValueOrder::fewest_alive : ValueOrder::by_section;
}

}  // namespace

int size_in(const EmitContext& context, Array array) {
  if (array == Array::derived) return derived_constant_count(context.programs);
  return array == Array::tangent ? tangent_count(context.programs) : size_of(context.layout, array);
}

LawShape law_shape(const EmitContext& context, std::size_t k) {
  const std::string number = k > 0 ? std::to_string(k + 1) : "";
  return {"tyres" + number, "Tyres" + number, "kTyreLanes" + number,
          static_cast<int>(context.written.laws[k].tyres.size())};
}

std::vector<std::string> indexed(const std::string& array, int size, int first) {
  Texts texts;
  for (int i = 0; i < size; ++i) texts.push_back(array + "[" + std::to_string(first + i) + "]");
  return texts;
}

Arguments arguments_of(Role role, const std::vector<Array>& unused) {
  if (role == Role::derived_constants) return {{"parameters", "const Parameters"}};
  Arguments arguments = {{"parameters", "const Tuned"}, {"inputs", "const Inputs"}, {"state", "const State"}};
  for (const auto& [array, name, type, passing] : kArguments)
    if (std::ranges::count(spec_of(role).inputs, array) > 0 && std::ranges::count(unused, array) == 0)
      arguments.push_back({name, type, passing});
  return arguments;
}

Places input_places(const EmitContext& context) {
  Places places;
  for (const Array array : {Array::z, Array::zd, Array::x, Array::charts}) add_array(places, "state", array, context);
  for (const Array array : {Array::lambda, Array::drive}) add_array(places, "multipliers", array, context);
  for (const Array array : {Array::Rz, Array::zdd_star}) add_array(places, "projection", array, context);
  add_array(places, "tau", Array::tau, context);
  add_array(places, "due", Array::due, context);
  for (const Array array : {Array::zdd, Array::xd}) add_array(places, "derivative", array, context);
  add_array(places, "tangents", Array::tangent, context);
  places[Array::step] = {"size", {"size.step"}};
  add_array(places, "parameters", Array::derived, context);
  places[Array::derived].locals = derived_constant_names(context.programs);
  places[Array::derived].local_tells_more = true;
  places[Array::t] = {"state", {"state.t"}};
  places[Array::in] = {"inputs", around("inputs.", context.names.inputs)};
  places[Array::par] = {"parameters", around("parameters.", context.names.parameters)};
  return places;
}

std::string constant_text(const Program& program, const Node& node, const ProgramShape& shape) {
  if (node.label >= 0 && shape.constants != nullptr) return shape.constants->text(program, node);
  return number_text(node.constant, shape.scalar);
}

int derived_constant_count(const Programs& programs) {
  return static_cast<int>(programs.derived_constants.outputs.size());
}

int tangent_count(const Programs& programs) {
  return static_cast<int>(std::ranges::count_if(
      programs.tangents.outputs, [](const OutputValue& output) { return output.slot.group == Array::tangent; }));
}

std::vector<std::string> derived_constant_names(const Programs& programs) {
  const Program& program = programs.derived_constants;
  std::vector<std::string> names(program.outputs.size());
  UniqueNames unique;
  for (const OutputValue& output : program.outputs) {
    const Node& node = program.nodes[output.value];
    if (node.op != Op::constant && node.label >= 0)
      names[static_cast<std::size_t>(output.slot.index)] = unique.identifier(program.labels[node.label]);
  }
  return names;
}

ScheduleOptions schedule_options(const ProgramShape& shape, std::size_t roll_above) {
  ScheduleOptions options{shape.clock.empty() ? Division::cheapest : Division::by_section, shape.order, roll_above};
  for (const Places* places : {&shape.inputs, &shape.outputs})
    for (const auto& [group, place] : *places)
      if (!place.array.empty()) options.indexed.insert(group);
  return options;
}

std::string type_text(const ProgramShape& shape) { return name_of(shape.scalar) + shape.elements; }

bool takes_pairs(const EmitContext& context) {
  if (context.options.scalar != Scalar::doubles || !context.written.in_pairs) return false;
  const auto& row = *std::ranges::find(kShapes, Role::accelerations, &ShapeRow::role);
  return !is_rolled(context.programs.accelerations,
                    schedule_options(shape_of(row, context), context.options.roll_above));
}

std::vector<ShapedProgram> shaped_programs(const EmitContext& context) {
  std::vector<ShapedProgram> all;
  for (const ShapeRow& row : kShapes) {
    if (!is_written(row.role, context)) continue;
    ShapedProgram shaped{&program_of(context.programs, row.role), row.role, shape_of(row, context)};
    if (context.options.scalar == Scalar::floats) take_floats(shaped.shape);
    if (context.options.scalar == Scalar::tangents) take_tangents(shaped.shape);
    if (row.role == Role::accelerations && context.in_pairs) shaped.program = &context.written.in_pairs->program;
    shaped.shape.order = order_of(context, shaped);
    if (shaped.shape.order == ValueOrder::reading) shaped.shape.longest_statement = 2 * kLineWidth;
    all.push_back(std::move(shaped));
  }
  in_threads(all.size(), [&](std::size_t i) {
    all[i].schedule = schedule(*all[i].program, schedule_options(all[i].shape, context.options.roll_above));
  });
  return all;
}

ShapedProgram clocked_accelerations(const EmitContext& context) {
  const Program& program = context.programs.accelerations;
  ProgramShape shape = shape_of(*std::ranges::find(kShapes, Role::accelerations, &ShapeRow::role), context);
  shape.title = "All accelerations, step by step against the clock.";
  shape.name = "clocked_accelerations";
  shape.function = "compute_" + shape.name;
  shape.result = "ClockedAccelerations";
  shape.clock = "clock";
  shape.arguments.push_back({"clock", "mbgen::StepClock"});
  return {&program, Role::accelerations, shape, schedule(program, schedule_options(shape, kRollAbove))};
}

bool takes(const Program& program, Array array) {
  return std::ranges::any_of(program.inputs, [array](const Slot& slot) { return slot.group == array; });
}

bool takes_multipliers(const Program& program) { return takes(program, Array::lambda) || takes(program, Array::drive); }

}  // namespace mbgen
