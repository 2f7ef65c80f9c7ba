#include <algorithm>

#include "compiler/emit/context_values.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"
#include "compiler/fmu/texts.hpp"
#include "compiler/passes/passes.hpp"

namespace mbgen {
namespace {

/// Members of struct Direction, in this order.
std::vector<DirectionGroup> direction_groups(const EmitContext& context) {
  using enum Array;
  return direction_of(context.layout, {z, zd, x, t, in, par, zdd, lambda, drive});
}

/// Texts of the entries of struct Direction.
std::vector<std::string> direction_texts(const std::vector<DirectionGroup>& groups) {
  std::vector<std::string> texts;
  for (const DirectionGroup& group : groups) {
    for (int i = 0; i < group.size; ++i) {
      texts.push_back(group.group == Array::t ? "direction.t" : "direction." + text_of(Slot{group.group, i}));
    }
  }
  return texts;
}

/// Derivatives of every output along the direction, and the pivots; no other outputs.
Program along(const Program& program, const std::vector<DirectionGroup>& groups) {
  Program derived = differentiate(program, seeds_of(program, groups));
  std::erase_if(derived.outputs, [](const OutputValue& output) {
    return output.slot.group != Array::pivot && output.slot.group.derivative == 0;
  });
  return contract(optimise(derived));
}

/// A program along a direction as its text names it.
struct AlongRow {
  Role role;
  const char *function, *result;
  std::vector<Array> arrays;  ///< of its spec: their derivatives are asked for, and the pivots themselves
};

ProgramShape shape_along(const EmitContext& context, const AlongRow& row) {
  ProgramShape shape;
  shape.title = "Derivatives along a direction.";
  shape.function = row.function;
  shape.result = row.result;
  shape.titles = context.titles;
  shape.arguments = arguments_of(row.role);
  shape.arguments.push_back({"direction", "const Direction"});
  shape.inputs = input_places(context);
  shape.inputs[Array::seed] = {"direction", direction_texts(direction_groups(context))};
  int first = 0;
  for (const Array array : row.arrays) {
    // Outputs, energies and power stand in one array.
    const bool is_pivot = array == Array::pivot, is_joined = row.role == Role::outputs;
    const std::string name = std::string("result.") + (is_joined ? "y" : name_of(array));
    const int size = size_of(context.layout, array);
    shape.outputs[is_pivot ? SlotGroup(array) : derivative_of(array)] = {
        "result", indexed(name, size, first), {}, is_pivot ? "1.0" : "0.0", name, first};
    if (is_joined) first += size;
  }
  return shape;
}

}  // namespace

std::string directional_header_text(const EmitContext& context) { return fill_template(context, "directional.hpp.in"); }

std::string directional_source_text(const EmitContext& context, const Programs& programs) {
  using enum Array;
  const AlongRow rows[] = {{Role::closure, "closure_along", "ClosureAlong", {dz, zd, pivot}},
                           {Role::accelerations, "accelerations_along", "AccelerationsAlong", {zdd, xd, pivot}},
                           {Role::multipliers, "multipliers_along", "MultipliersAlong", {lambda, drive}},
                           {Role::outputs, "outputs_along", "OutputsAlong", {y, energy, power}}};
  std::string text;
  for (const AlongRow& row : rows) {
    const ProgramShape shape = shape_along(context, row);
    Program derived = along(program_of(programs, row.role), direction_groups(context));
    // Outputs without a place in the shape are dropped: pivots of the multipliers, and all that these alone need.
    std::erase_if(derived.outputs,
                  [&](const OutputValue& output) { return !shape.outputs.contains(output.slot.group); });
    const Program lean = remove_dead_values(std::move(derived));
    text += program_text(lean, schedule(lean, schedule_options(shape, context.options.roll_above)), shape) + "\n";
  }
  return fill_template(context, "directional.cpp.in", {{"programs", text}});
}

}  // namespace mbgen
