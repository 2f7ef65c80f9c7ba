#include "compiler/emit/batch_text.hpp"

// The batch interface: the solver's programs once more, on vectors.

#include <fmt/format.h>

#include <algorithm>

#include "compiler/emit/input_text.hpp"
#include "compiler/emit/interface_text.hpp"
#include "compiler/emit/program_text.hpp"
#include "compiler/emit/solver_text.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/tuned_text.hpp"
#include "compiler/model/inputs.hpp"

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

std::string lane_struct(const std::string& name, const std::vector<std::string>& members) {
  std::string text = "struct " + name + " {\n";
  for (const std::string& member : members) text += "  Lanes " + member + ";\n";
  return text + "};\n";
}

/// A struct of rows for the iterations, and of vectors for the programs.
std::string row_or_lane_struct(const std::string& name, const std::vector<std::string>& members) {
  return "template <class Lanes>\n" + lane_struct(name + "Of", members) + "using " + name + " = " + name +
         "Of<Lanes>;\n";
}

/// The structs of the interface with vectors in place of each number.
std::string lane_structs(const EmitContext& context) {
  const SolverLayout& layout = context.layout;
  const std::string auxiliary = size_text(layout.auxiliary_states);
  return lane_struct("Parameters", names_of(parameter_members(context))) + tuned_type_text(context.programs, "Lanes") +
         lane_struct("Inputs", names_of(input_members(context))) +
         row_or_lane_struct("State", {"z[kCoordinates]", "zd[kCoordinates]", "x[" + auxiliary + "]", "t"}) +
         row_or_lane_struct("JointForces", {"tau[kCoordinates]"}) +
         row_or_lane_struct("Derivative", {"zdd[kCoordinates]", "xd[" + auxiliary + "]"}) +
         row_or_lane_struct("Multipliers", {"lambda[" + size_text(layout.equations) + "]",
                                            "drive[" + size_text(layout.drives) + "]"}) +
         row_or_lane_struct("Outputs", names_of(output_members(context)));
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

/// The inputs of a step dt seconds after its start.
std::string inputs_at(const EmitContext& context) {
  if (!inputs_have_derivatives(context.model.inputs)) {
    return "  static const Inputs& inputs_at(const Inputs& inputs, const Lanes& /*dt*/) noexcept { return inputs; }\n";
  }
  std::string text = "  static Inputs inputs_at(const Inputs& inputs, const Lanes& dt) noexcept {\n    Inputs later;\n";
  for (std::size_t i = 0; i < context.names.inputs.size(); ++i) {
    const std::string value = input_polynomial(context.model, context.names, static_cast<int>(i));
    text += wrapped_statement(fmt::format("    later.{} = {};", context.names.inputs[i], value)) + "\n";
  }
  return text + "    return later;\n  }\n";
}

std::string batch_outputs_call(const EmitContext& context) {
  if (!outputs_take_multipliers(context.programs)) {
    return "  const Mask good = mbgen::batch_detail::arguments_are_finite<System>(p, in, at, &tau);\n"
           "  mbgen::run_groups(&lanes::compute_outputs, result, p, in, at, tau, rates);";
  }
  return "  System::Multipliers constraint;\n"
         "  const Mask good = mbgen::constrain_lanes<System>(p, in, at, &tau, rates, constraint);\n"
         "  mbgen::run_groups(&lanes::compute_outputs, result, p, in, at, tau, rates, constraint);";
}

/// The start of every lane.
std::string batch_start(const EmitContext& context) {
  if (!context.initial) return "";
  return "State initial_state() noexcept {\n  State state;\n  for (int lane = 0; lane < kLanes; ++lane) "
         "set_lane(state, "
         "lane, " +
         context.names.solver + "::initial_state());\n  return state;\n}\n\n";
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
                        {"state_comment", state_comment(context)},
                        {"initial_state", context.initial ? "State initial_state() noexcept;\n" : ""},
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
  constexpr const char* kLoadParameter = "    group.{0} = load_group<Lanes>(batch.{0}, g);";
  constexpr const char* kLoadInput = "    values.group[g].{0} = load_group<Lanes>(batch.{0}, g);";
  constexpr const char* kOne = "  one.{0} = batch.{0}[lane];";
  constexpr const char* kSet = "  batch.{0}[lane] = one.{0};";
  return fill_template(
      "batch.cpp.in",
      {{"banner", banner_text(context.model, "//")},
       {"solver", context.names.solver},
       {"lane_structs", lane_structs(context)},
       {"programs", constants_text(constants, "double") + programs},
       {"system", system_text(context, members, "Lanes")},
       {"inputs_at", inputs_at(context)},
       {"load_parameters", statements(parameters, kLoadParameter)},
       {"load_inputs",
        inputs.empty() ? "" : "  for (int g = 0; g < kGroups; ++g) {\n" + statements(inputs, kLoadInput) + "  }\n"},
       {"parameters_of", statements(parameters, kOne)},
       {"inputs_of", statements(inputs, kOne)},
       {"outputs_of", statements(outputs, kOne)},
       {"set_parameters", statements(parameters, kSet)},
       {"set_inputs", statements(inputs, kSet)},
       {"set_outputs", statements(outputs, kSet)},
       {"store_outputs", statements(outputs, "  store_row(good, result.{0}, values.{0});")},
       {"initial_state", batch_start(context)},
       {"outputs_call", batch_outputs_call(context)}});
}

}  // namespace mbgen
