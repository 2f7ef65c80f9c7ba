// The batch interface: the solver's programs on vectors.

#include "compiler/emit/context_values.hpp"
#include "compiler/emit/law_text.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/quantity_ranges.hpp"
#include "compiler/emit/system_values.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"
#include "compiler/model/inputs.hpp"

namespace mbgen {
namespace {

/// Values between two calls of mbgen::read_back(): docs/use/batch.md.
constexpr std::size_t kReadBackAfter = 64;
constexpr int kLaneBytes = 8;

/// Arrays of lanes filled with the default.
FrameRows default_rows(const std::vector<NumberMember>& members, int lanes) {
  return mapped(members, [&](const NumberMember& member) {
    const std::vector<std::string> values(static_cast<std::size_t>(lanes), member.value);
    return FrameValues{{"declaration", braced_list("  double " + member.name + "[kLanes] = ", values, ";")},
                       {"unit", comment_text(member.unit)}};
  });
}

/// The program on vectors, beside the scalar function, with the same name and arguments. Its lanes are instances: pairs
/// are split into single numbers.
ShapedProgram in_lanes(const EmitContext& context, ShapedProgram shaped) {
  shaped.program = &program_of(context.programs, shaped.role);
  shaped.shape.scalar = Scalar::lanes;
  shaped.shape.read_back_after = kReadBackAfter;
  shaped.shape.in_groups = shaped.role != Role::derived_constants;
  return shaped;
}

}  // namespace

std::string batch_interface_text(const EmitContext& context) {
  const int lanes = context.options.lanes;
  return fill_template(context, "batch.hpp.in",
                       {{"alignment", kLaneBytes * lanes},
                        {"parameters", default_rows(parameter_members(context), lanes)},
                        {"inputs", default_rows(input_members(context), lanes)},
                        {"outputs", member_rows(output_members(context))}});
}

std::string batch_text(const EmitContext& context, const std::vector<ShapedProgram>& scalars) {
  FrameRows programs, members;
  ConstantNames constants(context.written);
  for (const ShapedProgram& scalar : scalars) {
    if (scalar.role == Role::closure_terms || scalar.role == Role::accelerations_chosen ||
        scalar.role == Role::sampled || scalar.role == Role::ground_places || scalar.role == Role::actuators ||
        scalar.role == Role::required_forces)
      continue;  // of lanes that are alone
    ShapedProgram shaped = in_lanes(context, scalar);
    shaped.shape.constants = &constants;
    const Schedule order = schedule(*shaped.program, {.order = ValueOrder::fewest_alive, .shares_places = true});
    const std::string laws = shaped.shape.laws.empty() ? "" : law_texts(context, shaped.shape.scalar, &constants);
    programs.push_back({{"program", laws + program_text(*shaped.program, order, shaped.shape)}});
    if (shaped.role != Role::outputs && shaped.role != Role::derived_constants)
      members.push_back(system_member(shaped, "lanes::" + shaped.shape.result + "Of<Row>", "lanes::"));
  }
  FrameRows one_step_methods = {{{"method", "rk4"}, {"limit", "kRk4Turn"}}};
  if (context.model.solver.is_implicit())
    one_step_methods.push_back({{"method", "rosenbrock"}, {"limit", "kRosenbrockTurn"}});
  FrameValues values = {{"parameters", name_rows(context.names.parameters)},
                        {"has_inputs", !context.names.inputs.empty()},
                        {"inputs", name_rows(context.names.inputs)},
                        {"outputs", name_rows(names_of(output_members(context)))},
                        {"constants", constants.declarations(Scalar::doubles)},
                        {"programs", programs},
                        {"has_quantities", has_quantities(context)},
                        {"turning", turning_table(context, Scalar::doubles)},
                        {"one_step_methods", one_step_methods},
                        {"projection", false}};
  values.merge(tuned_values(context.programs, false));
  values.merge(system_values(context, members, Scalar::lanes));
  return fill_template(context, "batch.cpp.in", values);
}

}  // namespace mbgen
