#include "compiler/emit/batch_text.hpp"

// The batch interface: the solver's programs once more, on vectors.

#include "compiler/emit/frame.hpp"
#include "compiler/emit/input_text.hpp"
#include "compiler/emit/interface_text.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/program_text.hpp"
#include "compiler/emit/solver_text.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/model/inputs.hpp"

namespace mbgen {
namespace {

/// AVX-512 addresses vectors by multiples of their size: so many after a pointer take one byte, the others four.
constexpr std::size_t kReachedByOneByte = 128;
/// Values between two calls of mbgen::read_back(): docs/use/batch.md.
constexpr std::size_t kReadBackAfter = 64;
constexpr int kLaneBytes = 8;

/// Arrays of lanes that have the default in each.
FrameRows default_rows(const std::vector<NumberMember>& members, int lanes) {
  return mapped(members, [&](const NumberMember& member) {
    const std::vector<std::string> values(static_cast<std::size_t>(lanes), member.value);
    return FrameValues{{"declaration", braced_list("  double " + member.name + "[kLanes] = ", values, ";")},
                       {"unit", comment_text(member.unit)}};
  });
}

/// The program on vectors: a sibling of the scalar function, with the same name and arguments.
ShapedProgram in_lanes(ShapedProgram shaped) {
  shaped.shape.scalar = "Lanes";
  shaped.shape.most_crossing = kReachedByOneByte;
  shaped.shape.read_back_after = kReadBackAfter;
  shaped.shape.in_groups = shaped.role != Role::derived_constants;
  for (auto& [name, declaration] : shaped.shape.arguments) {
    if (name == "tau") declaration = "const Lanes* tau";
  }
  return shaped;
}

}  // namespace

std::string batch_interface_text(const EmitContext& context) {
  return fill_template("batch.hpp.in", {{"banner", banner_text(context.model, "//")},
                                        {"solver", context.names.solver},
                                        {"lanes", context.options.lanes},
                                        {"balls", context.layout.balls > 0 ? std::to_string(context.layout.balls) : ""},
                                        {"alignment", kLaneBytes * context.options.lanes},
                                        {"parameters", default_rows(parameter_members(context), context.options.lanes)},
                                        {"inputs", default_rows(input_members(context), context.options.lanes)},
                                        {"outputs", member_rows(output_members(context))},
                                        {"initial", context.options.initial.has_value()},
                                        {"auxiliary_size", size_text(context.layout.auxiliary_states)},
                                        {"multiplier_size", size_text(context.layout.equations)},
                                        {"drive_size", size_text(context.layout.drives)}});
}

std::string batch_text(const EmitContext& context, const std::vector<ShapedProgram>& scalars) {
  FrameRows programs, members;
  ConstantNames constants(context.programs);
  for (const ShapedProgram& scalar : scalars) {
    if (scalar.role == Role::closure_terms || scalar.role == Role::accelerations_chosen)
      continue;  // of lanes that are alone
    ShapedProgram shaped = in_lanes(scalar);
    shaped.shape.constants = &constants;
    const Schedule order = schedule(*shaped.program, {.order = ValueOrder::fewest_alive});
    programs.push_back({{"program", program_text(*shaped.program, order, shaped.shape)}});
    if (shaped.role != Role::outputs && shaped.role != Role::derived_constants)
      members.push_back(system_member(shaped, "lanes::" + shaped.shape.result + "Of<Row>", "lanes::"));
  }
  FrameValues values = {{"banner", banner_text(context.model, "//")},
                        {"solver", context.names.solver},
                        {"parameters", name_rows(context.names.parameters)},
                        {"has_inputs", !context.names.inputs.empty()},
                        {"inputs", name_rows(context.names.inputs)},
                        {"outputs", name_rows(names_of(output_members(context)))},
                        {"auxiliary_size", size_text(context.layout.auxiliary_states)},
                        {"multiplier_size", size_text(context.layout.equations)},
                        {"drive_size", size_text(context.layout.drives)},
                        {"constants", constants.declarations("double")},
                        {"programs", programs},
                        {"projection", false},
                        {"later_inputs", later_inputs(context.model, context.names, "double")},
                        {"advances", inputs_have_derivatives(context.model.inputs)},
                        {"initial", context.options.initial.has_value()},
                        {"outputs_take_multipliers", outputs_take_multipliers(context.programs)}};
  values.merge(tuned_values(context.programs, false));
  values.merge(system_values(context, members, "Lanes"));
  return fill_template("batch.cpp.in", values);
}

}  // namespace mbgen
