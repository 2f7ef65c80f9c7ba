#include "compiler/emit/batch_text.hpp"

// The batch interface: the solver's programs once more, on vectors.

#include <fmt/format.h>

#include <algorithm>

#include "compiler/emit/frame.hpp"
#include "compiler/emit/input_text.hpp"
#include "compiler/emit/interface_text.hpp"
#include "compiler/emit/program_text.hpp"
#include "compiler/emit/solver_text.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

using Members = std::vector<NumberMember>;

/// AVX-512 addresses vectors by multiples of their size: so many after a pointer take one byte, the others four.
constexpr std::size_t kReachedByOneByte = 128;
/// Values between two calls of mbgen::read_back(): docs/use/batch.md.
constexpr std::size_t kReadBackAfter = 64;

int alignment(const EmitContext& context) { return 8 * context.lanes; }

/// A row of every number; one with a value has it in every lane.
std::string row_struct(const std::string& name, const Members& members, const EmitContext& context) {
  std::string text = fmt::format("struct alignas({}) {} {{\n", alignment(context), name);
  for (const NumberMember& member : members) {
    const std::string declaration = "  double " + member.name + "[kLanes]";
    const std::vector<std::string> values(static_cast<std::size_t>(context.lanes), member.value);
    text += member.value.empty() ? declaration + ";" : braced_list(declaration + " = ", values, ";");
    text += (member.unit.empty() ? "" : "  ///< " + comment_text(member.unit)) + "\n";
  }
  return text + "};";
}

/// One statement a member: a format of its name.
std::string statements(const Members& members, const char* format) {
  std::string text;
  for (const NumberMember& member : members) {
    text += wrapped_statement(fmt::format(fmt::runtime(format), member.name)) + "\n";
  }
  return text;
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
  return fill_template("batch.hpp.in",
                       {{"banner", banner_text(context.model, "//")},
                        {"solver", context.names.solver},
                        {"lanes", std::to_string(context.lanes)},
                        {"alignment", std::to_string(alignment(context))},
                        {"parameter_struct", row_struct("Parameters", parameter_members(context), context)},
                        {"input_struct", row_struct("Inputs", input_members(context), context)},
                        {"output_struct", row_struct("Outputs", output_members(context), context)},
                        {"initial", context.initial ? "yes" : ""},
                        {"auxiliary_size", size_text(context.layout.auxiliary_states)},
                        {"multiplier_size", size_text(context.layout.equations)},
                        {"drive_size", size_text(context.layout.drives)}});
}

std::string batch_text(const EmitContext& context, const std::vector<ShapedProgram>& scalars) {
  std::string programs, members;
  ConstantNames constants(context.programs);
  for (const ShapedProgram& scalar : scalars) {
    if (scalar.role == Role::closure_terms || scalar.role == Role::accelerations_chosen)
      continue;  // of lanes that are alone
    ShapedProgram shaped = in_lanes(scalar);
    shaped.shape.constants = &constants;
    programs +=
        program_text(*shaped.program, schedule(*shaped.program, {.order = ValueOrder::fewest_alive}), shaped.shape) +
        "\n";
    if (shaped.role == Role::derived_constants) programs += tuned_constructor_text(context.programs);
    if (shaped.role == Role::outputs || shaped.role == Role::derived_constants) continue;
    members += "  using " + shaped.shape.result + " = lanes::" + shaped.shape.result + "Of<Row>;\n" +
               "  static constexpr auto " + shaped.shape.function.substr(std::string("compute_").size()) +
               " = &lanes::" + shaped.shape.function + ";\n";
  }
  const Members parameters = parameter_members(context), inputs = input_members(context),
                outputs = output_members(context);
  constexpr const char* kMember = "  Lanes {0};";
  constexpr const char* kLoadParameter = "    group.{0} = load_group<Lanes>(batch.{0}, g);";
  constexpr const char* kLoadInput = "    values.group[g].{0} = load_group<Lanes>(batch.{0}, g);";
  constexpr const char* kOne = "  one.{0} = batch.{0}[lane];";
  constexpr const char* kSet = "  batch.{0}[lane] = one.{0};";
  return fill_template("batch.cpp.in",
                       {{"banner", banner_text(context.model, "//")},
                        {"solver", context.names.solver},
                        {"parameter_lanes", statements(parameters, kMember)},
                        {"tuned_type", tuned_type_text(context.programs, "Lanes")},
                        {"input_lanes", statements(inputs, kMember)},
                        {"output_lanes", statements(outputs, kMember)},
                        {"auxiliary_size", size_text(context.layout.auxiliary_states)},
                        {"multiplier_size", size_text(context.layout.equations)},
                        {"drive_size", size_text(context.layout.drives)},
                        {"programs", constants_text(constants, "double") + programs},
                        {"system", system_text(context, members, "Lanes")},
                        {"later_inputs", advanced_inputs(context.model, context.names, "double", "    ")},
                        {"load_parameters", statements(parameters, kLoadParameter)},
                        {"load_inputs", statements(inputs, kLoadInput)},
                        {"parameters_of", statements(parameters, kOne)},
                        {"inputs_of", statements(inputs, kOne)},
                        {"outputs_of", statements(outputs, kOne)},
                        {"set_parameters", statements(parameters, kSet)},
                        {"set_inputs", statements(inputs, kSet)},
                        {"set_outputs", statements(outputs, kSet)},
                        {"store_outputs", statements(outputs, "  store_row(good, result.{0}, values.{0});")},
                        {"initial", context.initial ? "yes" : ""},
                        {"outputs_take_multipliers", outputs_take_multipliers(context.programs) ? "yes" : ""}});
}

}  // namespace mbgen
