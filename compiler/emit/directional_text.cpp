#include <algorithm>

#include "compiler/emit/context_values.hpp"
#include "compiler/emit/program_text.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"
#include "compiler/passes/passes.hpp"

namespace mbgen {
namespace {

/// What struct Direction holds, in this order.
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

GroupPlace member_place(const std::string& array, int size, int first = 0, const std::string& missing = "0.0") {
  GroupPlace place{"result", {}, {}, missing, "result." + array, first};
  for (int i = 0; i < size; ++i) place.texts.push_back(place.array + "[" + std::to_string(first + i) + "]");
  return place;
}

using Argument = std::pair<std::string, std::string>;

ProgramShape shape_along(const EmitContext& context, const std::string& function, const std::string& result,
                         const std::vector<Argument>& arguments) {
  ProgramShape shape;
  shape.title = "Derivatives along a direction.";
  shape.function = function;
  shape.result = result;
  shape.arguments = {
      {"parameters", "const Tuned& parameters"}, {"inputs", "const Inputs& inputs"}, {"state", "const State& state"}};
  shape.arguments.insert(shape.arguments.end(), arguments.begin(), arguments.end());
  shape.arguments.push_back({"direction", "const Direction& direction"});
  shape.inputs = input_places(context);
  shape.titles = context.titles;
  GroupPlace& seed = shape.inputs[Array::seed];
  seed.argument = "direction";
  seed.texts = direction_texts(direction_groups(context));
  return shape;
}

}  // namespace

std::string directional_header_text(const EmitContext& context) { return fill_template(context, "directional.hpp.in"); }

std::string directional_source_text(const EmitContext& context, const Programs& programs) {
  const SolverLayout& layout = context.layout;
  const std::vector<DirectionGroup> groups = direction_groups(context);
  const Argument tau{"tau", "const double* tau"}, derivative{"derivative", "const Derivative& derivative"},
      multipliers{"multipliers", "const Multipliers& multipliers"};
  const int outputs = static_cast<int>(context.names.outputs.size());
  const GroupPlace pivot = member_place("pivot", static_cast<int>(layout.blocks.size()), 0, "1.0");

  ProgramShape closure = shape_along(context, "closure_along", "ClosureAlong", {});
  closure.outputs = {{derivative_of(Array::dz), member_place("dz", layout.coordinates)},
                     {derivative_of(Array::zd), member_place("zd", layout.coordinates)},
                     {Array::pivot, pivot}};
  ProgramShape accelerations = shape_along(context, "accelerations_along", "AccelerationsAlong", {tau});
  accelerations.outputs = {{derivative_of(Array::zdd), member_place("zdd", layout.coordinates)},
                           {derivative_of(Array::xd), member_place("xd", layout.auxiliary_states)},
                           {Array::pivot, pivot}};
  ProgramShape forces = shape_along(context, "multipliers_along", "MultipliersAlong", {tau, derivative});
  forces.outputs = {{derivative_of(Array::lambda), member_place("lambda", layout.equations)},
                    {derivative_of(Array::drive), member_place("drive", layout.drives)}};
  ProgramShape results = shape_along(context, "outputs_along", "OutputsAlong", {tau, derivative, multipliers});
  results.outputs = {{derivative_of(Array::y), member_place("y", outputs)},
                     {derivative_of(Array::energy), member_place("y", 2, outputs)},
                     {derivative_of(Array::power), member_place("y", 1, outputs + 2)}};

  const std::pair<const Program*, const ProgramShape*> all[] = {{&programs.closure, &closure},
                                                                {&programs.accelerations, &accelerations},
                                                                {&programs.multipliers, &forces},
                                                                {&programs.outputs, &results}};
  std::string text;
  for (const auto& [program, shape] : all) {
    Program derived = along(*program, groups);
    // What the shape has no place for is not asked for: pivots of the multipliers, what they are made of.
    const Places& wanted = shape->outputs;
    std::erase_if(derived.outputs, [&](const OutputValue& output) { return !wanted.contains(output.slot.group); });
    const Program lean = remove_dead_values(derived);
    text += program_text(lean, schedule(lean, schedule_options(*shape, context.options.roll_above)), *shape) + "\n";
  }
  return fill_template(context, "directional.cpp.in", {{"programs", text}});
}

}  // namespace mbgen
